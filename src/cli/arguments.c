// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"

#include <errno.h>
#include <getopt.h>
#include <limits.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char usage[] =
    "pdmc - how likely is this crack to grow, and which way?\n"
    "\n"
    "  pdmc STUDY [options]      run a study\n"
    "  pdmc check STUDY          check a study; print every setting and what the run will cost\n"
    "  pdmc show [--json] FILE   print results, for people or for programs\n"
    "  pdmc export FILE DIR      write results as CSV\n"
    "  pdmc plot FILE DIR        draw results as PNG and SVG\n"
    "  pdmc compare A B          lay two result files side by side: means, distributions, K, time, memory\n"
    "  pdmc describe             list every setting of a study file\n"
    "\n"
    "  -o, --output FILE         result file (default: the study's name, .h5, in the working folder)\n"
    "  -t, --threads N           number of threads (default: OMP_NUM_THREADS, or all processors); no result\n"
    "                            depends on it\n"
    "  -s, --seed S              instead of the study's\n"
    "  -n, --samples N           instead of the study's\n"
    "  -f, --force               overwrite the result file\n"
    "  -q, --quiet               print nothing but errors\n"
    "      --json                of show and compare: one JSON object instead of a table\n"
    "      --tip NAME            of compare: the tip whose energies are compared; may be given again (default: the\n"
    "                            first that both have)\n"
    "      --angle DEG[,DEG...]  of compare: the angles, in degrees (default: straight ahead, and where the mean is\n"
    "                            largest)\n"
    "      --measure NAME        of compare: bond or griffith (default: the one that decides in A)\n"
    "      --plot DIR            of compare: also draw the densities of both into a folder, as PNG and SVG\n"
    "  -h, --help                print this\n"
    "      --version             print the version\n"
    "\n"
    "A run that is interrupted (Ctrl-C, SIGTERM, SIGHUP) finishes the samples under way and saves what it has.\n"
    "\n"
    "Exit codes: 0 done, 3 stopped at sampling.most_samples without the precision asked for, 64 usage,\n"
    "65 bad data, 66 no input, 70 internal error, 73 cannot create the output, 74 input or output failed,\n"
    "75 stopped early with everything saved, 78 bad study file.\n";

static const struct option long_options[] = {
    {"output", required_argument, NULL, 'o'}, {"threads", required_argument, NULL, 't'},
    {"seed", required_argument, NULL, 's'},   {"samples", required_argument, NULL, 'n'},
    {"force", no_argument, NULL, 'f'},        {"quiet", no_argument, NULL, 'q'},
    {"json", no_argument, NULL, 'j'},         {"tip", required_argument, NULL, 'T'},
    {"angle", required_argument, NULL, 'A'},  {"measure", required_argument, NULL, 'M'},
    {"plot", required_argument, NULL, 'P'},   {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},      {NULL, 0, NULL, 0},
};

// What may stand behind a command's name.
typedef struct {
    const char *name;
    command command;
    int operands;
    const char *needs, *options; // the operands in words, and the letters of the options that mean something
} grammar;

static const grammar run_grammar = {"a run", COMMAND_RUN, 1, "the name of a study", "otsnfq"};
static const grammar grammars[] = {
    {"check", COMMAND_CHECK, 1, "the name of a study", "tsnq"},
    {"show", COMMAND_SHOW, 1, "the name of a result file", "j"},
    {"export", COMMAND_EXPORT, 2, "a result file and a folder", "q"},
    {"plot", COMMAND_PLOT, 2, "a result file and a folder", "q"},
    {"compare", COMMAND_COMPARE, 2, "two result files", "jTAMPq"},
    {"describe", COMMAND_DESCRIBE, 0, "", ""},
};

static bool read_number(const char *option, const char *text, long long lowest, long long highest, long long *out)
{
    char *end;
    errno = 0;
    *out = strtoll(text, &end, 10);
    if (*text != '\0' && *end == '\0' && errno == 0 && lowest <= *out && *out <= highest) return true;
    fprintf(stderr, "pdmc: %s: \"%s\" is not a whole number from %lld to %lld\n", option, text, lowest, highest);
    return false;
}

static bool read_output(const char *value, arguments *out)
{
    if (*value == '\0') fputs("pdmc: --output: the name of the file is empty\n", stderr);
    out->output = value;
    return *value != '\0';
}

static bool read_folder(const char *value, arguments *out)
{
    if (*value == '\0') fputs("pdmc: --plot: the name of the folder is empty\n", stderr);
    out->folder = value;
    return *value != '\0';
}

static bool read_tip(const char *value, arguments *out)
{
    if (out->tip_count == PDMC_ASKED) {
        fprintf(stderr, "pdmc: --tip: more than %d tips\n", PDMC_ASKED);
        return false;
    }
    out->tips[out->tip_count++] = value;
    return true;
}

static bool read_angles(const char *value, arguments *out)
{
    for (const char *at = value;; at++) {
        char *end;
        const double degrees = strtod(at, &end);
        if (end == at || (*end != '\0' && *end != ',') || !(fabs(degrees) <= 360.0)) {
            fprintf(stderr, "pdmc: --angle: \"%s\" is not an angle from -360 to 360 degrees, or several with commas\n",
                    value);
            return false;
        }
        if (out->angle_count == PDMC_ASKED) {
            fprintf(stderr, "pdmc: --angle: more than %d angles\n", PDMC_ASKED);
            return false;
        }
        out->angles[out->angle_count++] = degrees;
        at = end;
        if (*at == '\0') return true;
    }
}

static bool read_measure(const char *value, arguments *out)
{
    out->has_measure = true;
    out->measure = strcmp(value, "bond") == 0 ? PDMC_MEASURE_BOND : PDMC_MEASURE_GRIFFITH;
    if (out->measure == PDMC_MEASURE_BOND || strcmp(value, "griffith") == 0) return true;
    fprintf(stderr, "pdmc: --measure: \"%s\" is neither bond nor griffith\n", value);
    return false;
}

static bool read_option(int letter, const char *value, arguments *out)
{
    long long number = 0;
    switch (letter) {
    case 'o': return read_output(value, out);
    case 'f': out->force = true; return true;
    case 'q': out->quiet = true; return true;
    case 'j': out->json = true; return true;
    case 'T': return read_tip(value, out);
    case 'A': return read_angles(value, out);
    case 'M': return read_measure(value, out);
    case 'P': return read_folder(value, out);
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

static const grammar *find_grammar(const char *word)
{
    for (size_t k = 0; k < sizeof grammars / sizeof grammars[0]; k++)
        if (strcmp(word, grammars[k].name) == 0) return &grammars[k];
    return &run_grammar;
}

// An option that does nothing here is a mistake about what the command does.
static bool check_options(const grammar *g, const char *letters)
{
    for (; *letters; letters++) {
        if (strchr(g->options, *letters)) continue;
        for (const struct option *o = long_options; o->name; o++)
            if (o->val == *letters) fprintf(stderr, "pdmc: %s does not take --%s; see pdmc --help\n", g->name, o->name);
        return false;
    }
    return true;
}

static bool check_count(const grammar *g, int count, char *word[])
{
    if (count == g->operands) return true;
    if (count < g->operands) {
        fprintf(stderr, "pdmc: %s needs %s; see pdmc --help\n", g->name, g->needs);
    } else if (g == &run_grammar && access(word[0], F_OK) != 0) {
        fprintf(stderr, "pdmc: %s: neither a command nor a file; see pdmc --help\n", word[0]);
    } else {
        fprintf(stderr, "pdmc: unexpected argument %s; see pdmc --help\n", word[g->operands]);
    }
    return false;
}

static bool read_words(int count, char *word[], const char *letters, arguments *out)
{
    const grammar *g = count > 0 ? find_grammar(word[0]) : &run_grammar;
    const int skip = g == &run_grammar ? 0 : 1;
    word += skip;
    count -= skip;
    if (!check_count(g, count, word) || !check_options(g, letters)) return false;
    out->command = g->command;
    if (count > 0) out->input = word[0];
    if (count > 1) *(g->command == COMMAND_COMPARE ? &out->other : &out->folder) = word[1];
    return true;
}

bool read_arguments(int argc, char *argv[], arguments *out)
{
    char letters[sizeof long_options / sizeof long_options[0]] = ""; // of the options that were given, each once
    char name[] = "pdmc";
    if (argc > 0) argv[0] = name; // by which getopt begins its messages
    *out = (arguments){.threads = omp_get_max_threads()}; // asked for before OpenBLAS is made to run on one
    int letter;
    while ((letter = getopt_long(argc, argv, "o:t:s:n:fqh", long_options, NULL)) != -1) {
        if (!read_option(letter, optarg, out)) return false;
        if (!strchr(letters, letter)) letters[strlen(letters)] = (char)letter;
    }
    if (out->command == COMMAND_HELP || out->command == COMMAND_VERSION) return true;
    return read_words(argc - optind, &argv[optind], letters, out);
}
