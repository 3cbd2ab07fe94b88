// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/exit_code.h"
#include "cli/run_command.h"
#include "pdmc/study.h"
#include "pdmc/views.h"

#include <stdio.h>
#include <stdlib.h>
#include <sysexits.h>

static int view_command(const arguments *given)
{
    pdmc_results results = {0};
    pdmc_status status = pdmc_results_read(given->input, &results);
    if (status == PDMC_OK) {
        switch (given->command) {
        case COMMAND_EXPORT: status = pdmc_view_export(&results, given->folder); break;
        case COMMAND_PLOT: status = pdmc_view_plot(&results, given->folder); break;
        default: status = given->json ? pdmc_view_json(&results, stdout) : pdmc_view_table(&results, stdout);
        }
    }
    pdmc_results_clear(&results);
    return status == PDMC_OK ? EX_OK : fail(status);
}

static int describe_command(void)
{
    char *text = NULL;
    const pdmc_status status = pdmc_study_describe(&text);
    if (status != PDMC_OK) return fail(status);
    fputs(text, stdout);
    free(text);
    return EX_OK;
}

static int dispatch(const arguments *given)
{
    switch (given->command) {
    case COMMAND_RUN: return run_command(given);
    case COMMAND_CHECK: return check_command(given);
    case COMMAND_SHOW:
    case COMMAND_EXPORT:
    case COMMAND_PLOT: return view_command(given);
    case COMMAND_DESCRIBE: return describe_command();
    case COMMAND_HELP: fputs(usage, stdout); return EX_OK;
    case COMMAND_VERSION: printf("pdmc %s %s\n", pdmc_version(), pdmc_git_sha1()); return EX_OK;
    }
    return EX_SOFTWARE;
}

int main(int argc, char *argv[])
{
    arguments given;
    if (!read_arguments(argc, argv, &given)) return EX_USAGE;
    const int code = dispatch(&given);
    if (fflush(stdout) == 0 && !ferror(stdout)) return code;
    perror("pdmc: standard output");
    return EX_IOERR;
}
