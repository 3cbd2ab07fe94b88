// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/compare_command.h"
#include "cli/exit_code.h"
#include "cli/run_command.h"
#include "pdmc/study.h"
#include "pdmc/views.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>
#include <unistd.h>

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
    if (status == PDMC_ERR_IO && ferror(stdout)) return EX_IOERR; // main() says why
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
    case COMMAND_COMPARE: return compare_command(given);
    case COMMAND_DESCRIBE: return describe_command();
    case COMMAND_HELP: fputs(usage, stdout); return EX_OK;
    case COMMAND_VERSION: printf("pdmc %s %s\n", pdmc_version(), pdmc_git_sha1()); return EX_OK;
    }
    return EX_SOFTWARE;
}

// Where a standard stream is closed, the next file to be opened would take its place and be printed into. The
// stand-ins cannot be used the way the streams are, so that the loss is still noticed.
static void occupy_standard_streams(void)
{
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; descriptor++)
        if (fcntl(descriptor, F_GETFD) == -1 &&
            open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor)
            _exit(EX_OSERR);
}

// To be called right after the command, while errno is still that of a failure to write.
static int close_output(int code)
{
    const int error = ferror(stdout) ? errno : 0;
    const bool failed = ferror(stdout) != 0;
    errno = 0;
    if (fclose(stdout) == 0 && !failed) return code;
    fprintf(stderr, "pdmc: standard output: %s\n", strerror(errno ? errno : error));
    return code == EX_OK ? EX_IOERR : code;
}

int main(int argc, char *argv[])
{
    arguments given;
    occupy_standard_streams();
    signal(SIGXFSZ, SIG_IGN); // past ulimit -f, writing fails instead, and says so
    if (!read_arguments(argc, argv, &given)) return EX_USAGE;
    return close_output(dispatch(&given));
}
