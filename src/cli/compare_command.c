// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compare_command.h"

#include "cli/exit_code.h"
#include "pdmc/views.h"

#include <stdio.h>
#include <string.h>
#include <sysexits.h>

static const double radian = 57.295779513082320877; // in degrees

static void print_notes(const char *notes)
{
    while (*notes) {
        const int length = (int)strcspn(notes, "\n");
        fprintf(stderr, "pdmc: note: %.*s\n", length, notes);
        notes += length + (notes[length] == '\n');
    }
}

static pdmc_status show(const arguments *given, const pdmc_comparison *comparison)
{
    pdmc_status status = PDMC_OK;
    if (!given->quiet) print_notes(pdmc_comparison_notes(comparison));
    if (given->folder) status = pdmc_view_comparison_plot(comparison, given->folder);
    if (status != PDMC_OK) return status;
    return (given->json ? pdmc_view_comparison_json : pdmc_view_comparison_table)(comparison, stdout);
}

static pdmc_status compare(const arguments *given, const pdmc_results results[2])
{
    double angles[PDMC_ASKED];
    pdmc_comparison *comparison = NULL;
    for (int k = 0; k < given->angle_count; k++) angles[k] = given->angles[k] / radian;
    const pdmc_comparison_request request = {.labels = {given->input, given->other},
                                             .tip_count = given->tip_count,
                                             .tips = given->tips,
                                             .angle_count = given->angle_count,
                                             .angles = angles,
                                             .has_measure = given->has_measure,
                                             .measure = given->measure};
    pdmc_status status = pdmc_comparison_create(&results[0], &results[1], &request, &comparison);
    if (status == PDMC_OK) status = show(given, comparison);
    pdmc_comparison_destroy(&comparison);
    return status;
}

int compare_command(const arguments *given)
{
    pdmc_results results[2] = {0};
    pdmc_status status = pdmc_results_read(given->input, &results[0]);
    if (status == PDMC_OK) status = pdmc_results_read(given->other, &results[1]);
    if (status == PDMC_OK) status = compare(given, results);
    for (int i = 0; i < 2; i++) pdmc_results_clear(&results[i]);
    if (status == PDMC_ERR_IO && ferror(stdout)) return EX_IOERR; // main() says why
    return status == PDMC_OK ? EX_OK : fail(status);
}
