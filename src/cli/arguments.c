// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"

#include <errno.h>
#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char usage[] =
    "pdmc - how likely is this crack to grow, and which way?\n"
    "\n"
    "  pdmc STUDY [options]      run a study\n"
    "  pdmc check STUDY          check a study; print every setting and what the run will cost\n"
    "  pdmc show [--json] FILE   print results, for people or for programs\n"
    "  pdmc export FILE DIR      write results as CSV\n"
    "  pdmc plot FILE DIR        draw results as PNG and SVG\n"
    "  pdmc describe             list every setting of a study file\n"
    "\n"
    "  -o, --output FILE         result file (default: the study's name, .h5, in the working folder)\n"
    "  -t, --threads N           number of threads (default: all processors); no result depends on it\n"
    "  -s, --seed S              instead of the study's\n"
    "  -n, --samples N           instead of the study's\n"
    "  -f, --force               overwrite the result file\n"
    "  -q, --quiet               print nothing but errors\n"
    "  -h, --help                print this\n"
    "      --version             print the version\n"
    "\n"
    "Exit codes: 0 done, 64 usage, 65 bad data, 66 no input, 70 internal error, 73 cannot create the output,\n"
    "74 input or output failed, 75 stopped early with everything saved, 78 bad study file.\n";

static bool mistake(const char *what, const char *word)
{
    fprintf(stderr, "pdmc: %s%s%s; see pdmc --help\n", what, word ? " " : "", word ? word : "");
    return false;
}

static bool read_number(const char *option, const char *text, long long lowest, long long highest, long long *out)
{
    char *end;
    errno = 0;
    *out = strtoll(text, &end, 10);
    if (*text != '\0' && *end == '\0' && errno == 0 && lowest <= *out && *out <= highest) return true;
    fprintf(stderr, "pdmc: %s: %s is not a whole number from %lld to %lld\n", option, text, lowest, highest);
    return false;
}

static bool read_option(int letter, const char *value, arguments *out)
{
    long long number = 0;
    switch (letter) {
    case 'o': out->output = value; return true;
    case 'f': out->force = true; return true;
    case 'q': out->quiet = true; return true;
    case 'j': out->json = true; return true;
    case 'h': out->command = COMMAND_HELP; return true;
    case 'V': out->command = COMMAND_VERSION; return true;
    case 't':
        if (!read_number("--threads", value, 1, 1024, &number)) return false;
        out->threads = (int)number;
        return true;
    case 's':
        if (!read_number("--seed", value, 0, LLONG_MAX, &number)) return false;
        out->seed = (uint64_t)number;
        out->has_seed = true;
        return true;
    case 'n':
        if (!read_number("--samples", value, 1, 100000000, &number)) return false;
        out->samples = (int)number;
        return true;
    default: fputs("See pdmc --help.\n", stderr); return false; // getopt has told what is wrong
    }
}

static bool read_words(int count, char *word[], arguments *out)
{
    static const struct {
        const char *name;
        command command;
        int operands;
    } commands[] = {
        {"check", COMMAND_CHECK, 1}, {"show", COMMAND_SHOW, 1},         {"export", COMMAND_EXPORT, 2},
        {"plot", COMMAND_PLOT, 2},   {"describe", COMMAND_DESCRIBE, 0},
    };
    if (count == 0) return mistake("a study is missing", NULL);
    int operands = 1;
    out->command = COMMAND_RUN;
    for (size_t k = 0; k < sizeof commands / sizeof commands[0]; k++) {
        if (strcmp(word[0], commands[k].name) != 0) continue;
        out->command = commands[k].command;
        operands = commands[k].operands;
        word++;
        count--;
        break;
    }
    if (count < operands) return mistake(operands == 2 ? "FILE and DIR are needed" : "a file is needed", NULL);
    if (count > operands) return mistake("unexpected argument", word[operands]);
    if (operands > 0) out->input = word[0];
    if (operands > 1) out->folder = word[1];
    return true;
}

bool read_arguments(int argc, char *argv[], arguments *out)
{
    static const struct option options[] = {
        {"output", required_argument, NULL, 'o'}, {"threads", required_argument, NULL, 't'},
        {"seed", required_argument, NULL, 's'},   {"samples", required_argument, NULL, 'n'},
        {"force", no_argument, NULL, 'f'},        {"quiet", no_argument, NULL, 'q'},
        {"json", no_argument, NULL, 'j'},         {"help", no_argument, NULL, 'h'},
        {"version", no_argument, NULL, 'V'},      {NULL, 0, NULL, 0},
    };
    *out = (arguments){0};
    int letter;
    while ((letter = getopt_long(argc, argv, "o:t:s:n:fqh", options, NULL)) != -1)
        if (!read_option(letter, optarg, out)) return false;
    if (out->command == COMMAND_HELP || out->command == COMMAND_VERSION) return true;
    return read_words(argc - optind, &argv[optind], out);
}
