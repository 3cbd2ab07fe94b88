// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static atomic_int interrupts;         // a signal may reach any thread
static const char *volatile notes[2]; // what the first and the second interrupt say, written before they are caught

static void on_signal(int number)
{
    const int error = errno, count = atomic_fetch_add(&interrupts, 1);
    if (count >= 2) _exit(128 + number);
    const char *note = notes[count];
    if (note && write(STDERR_FILENO, note, strlen(note)) < 0) note = NULL; // there is nobody to tell
    errno = error;
}

static void catch_signal(int number)
{
    // Restarting: a signal while results are written is no failure to write them.
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

static void catch_signals(void)
{
    struct sigaction hangup;
    catch_signal(SIGINT);
    catch_signal(SIGTERM);
    sigaction(SIGHUP, NULL, &hangup);
    if (hangup.sa_handler != SIG_IGN) catch_signal(SIGHUP); // nohup pdmc ... goes on
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void progress_start(bool quiet, const char *what, progress *state)
{
    const char *terminal = getenv("TERM");
    *state = (progress){.quiet = quiet, .what = what};
    state->live = !quiet && isatty(STDERR_FILENO) && terminal && strcmp(terminal, "dumb") != 0;
    const int skip = state->live ? 0 : 1; // the line end that leaves the live line
    if (!quiet) {
        notes[0] = "\npdmc: stopping: what is under way is finished, then everything is saved; two more "
                   "interrupts leave at once and save nothing\n" +
                   skip;
        notes[1] = "\npdmc: still stopping; one more interrupt leaves at once and saves nothing\n" + skip;
    }
    catch_signals();
}

static void draw(progress *state, int done, int total)
{
    char text[80], left[40] = "";
    const double seconds = done > 0 ? (now() - state->begin) * (total - done) / done : 0.0;
    if (seconds >= 1.0) snprintf(left, sizeof left, ", about %.0f s left", seconds);
    snprintf(text, sizeof text, "%d of %d %s%s", done, total, state->what, left);
    if (state->live) fprintf(stderr, "\r%-60s", done > 0 ? text : "preparing the solver");
    else if (done > 0) fprintf(stderr, "%s\n", text);
    state->line_open = state->live;
}

bool progress_show(void *context, int done, int total)
{
    progress *state = context;
    const int tenth = (int)(10LL * done / total);
    if (done == 0) state->begin = now();
    if (!state->quiet && (state->live || tenth > state->tenth)) draw(state, done, total);
    state->tenth = tenth;
    return atomic_load(&interrupts) == 0;
}

void progress_round(void *context, const pdmc_round *round)
{
    static const char *const targets[] = {[PDMC_TARGET_MEAN] = "the mean", [PDMC_TARGET_QUANTILE] = "the 95 % quantile",
                                          [PDMC_TARGET_PROBABILITY] = "P(G > G_c)"};
    progress *state = context;
    if (state->quiet) return;
    progress_end(state);
    fprintf(stderr, "%d samples: %s at %s is ", round->samples, targets[round->target], round->tip);
    if (isinf(round->error)) fputs("not known at all", stderr);
    else fprintf(stderr, "known to %.3g %%", 100.0 * round->error);
    fprintf(stderr, ", %.3g %% wanted", 100.0 * round->wanted);
    if (round->error > round->wanted && !isinf(round->error))
        fprintf(stderr, ", about %.0f more needed", round->needed - round->samples);
    fputc('\n', stderr);
}

void progress_end(progress *state)
{
    if (state->line_open) fputc('\n', stderr);
    state->line_open = false;
}
