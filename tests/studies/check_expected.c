// SPDX-License-Identifier: GPL-3.0-or-later

/// check_expected RESULTS.json EXPECTED.csv: compares what `pdmc show --json` printed with a study's expected values.
/// A line of the table is "pointer,value,tolerance,source", the pointer as in RFC 6901, e.g. /tips/0/nominal/K_I; where the
/// tolerance is the word "interval", the pointer is that of an estimate whose own interval must contain the value. The
/// first line names the columns, and lines that begin with # are for people. Exits 0 where every value is within its
/// tolerance and there is at least one.

#include <jansson.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const json_t *value_at(const json_t *value, const char *pointer)
{
    char tokens[256];
    snprintf(tokens, sizeof tokens, "%s", pointer);
    char *rest = NULL;
    for (char *token = strtok_r(tokens, "/", &rest); token && value; token = strtok_r(NULL, "/", &rest)) {
        value = json_is_array(value) ? json_array_get(value, strtoul(token, NULL, 10)) : json_object_get(value, token);
    }
    return value;
}

static bool within(const json_t *results, const char *pointer, double want, double tolerance)
{
    const json_t *value = value_at(results, pointer);
    if (!json_is_number(value)) {
        printf("%s: no such number\n", pointer);
        return false;
    }
    const double got = json_number_value(value);
    const bool good = fabs(got - want) <= tolerance;
    if (!good) printf("%s: %.10g, expected %.10g +- %.3g\n", pointer, got, want, tolerance);
    return good;
}

static bool contains(const json_t *results, const char *pointer, double want)
{
    const json_t *estimate = value_at(results, pointer);
    const json_t *lower = json_object_get(estimate, "lower"), *upper = json_object_get(estimate, "upper");
    if (!json_is_number(lower) || !json_is_number(upper)) {
        printf("%s: no such interval\n", pointer);
        return false;
    }
    const bool good = json_number_value(lower) <= want && want <= json_number_value(upper);
    if (!good)
        printf("%s: [%.10g, %.10g] is without %.10g\n", pointer, json_number_value(lower), json_number_value(upper), want);
    return good;
}

/// @return whether the line can be read, and its value is as expected
static bool agrees(const json_t *results, const char *line)
{
    char pointer[256], word[16];
    double want, tolerance;
    if (sscanf(line, "%255[^,],%lf,%lf", pointer, &want, &tolerance) == 3)
        return within(results, pointer, want, tolerance);
    if (sscanf(line, "%255[^,],%lf,%15[a-z]", pointer, &want, word) == 3 && strcmp(word, "interval") == 0)
        return contains(results, pointer, want);
    printf("not pointer,value,tolerance: %s", line);
    return false;
}

/// @param[out] compared  number of lines with a value
/// @return number of lines that are wrong, or that cannot be read
static int compare_lines(const json_t *results, FILE *expected, int *compared)
{
    int wrong = 0;
    char line[1024];
    *compared = 0;
    for (int number = 1; fgets(line, sizeof line, expected); number++) {
        if (number == 1 || line[0] == '#' || line[0] == '\n') continue;
        (*compared)++;
        wrong += !agrees(results, line);
    }
    return wrong;
}

int main(int argc, char *argv[])
{
    if (argc != 3) return 64;
    json_error_t error;
    json_t *results = json_load_file(argv[1], 0, &error);
    FILE *expected = fopen(argv[2], "r");
    int compared = 0, wrong = 0;
    if (results && expected) wrong = compare_lines(results, expected, &compared);
    if (!results) printf("%s:%d: %s\n", argv[1], error.line, error.text);
    if (!expected) perror(argv[2]);
    printf("%d values compared, %d wrong\n", compared, wrong);
    if (expected) fclose(expected);
    json_decref(results);
    return compared > 0 && wrong == 0 ? 0 : 1;
}
