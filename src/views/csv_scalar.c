// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/csv.h"
#include "views/scalar.h"

pdmc_status pdmc_csv_levels(const pdmc_results *results, FILE *stream)
{
    const pdmc_scalar_record *s = &results->scalar;
    fputs("level", stream);
    pdmc_csv_column(stream, "spacing", results->length_unit);
    pdmc_csv_column(stream, "horizon", results->length_unit);
    fputs(",elements,unknowns,entries,error,error_rate,classical,classical_rate", stream);
    pdmc_csv_column(stream, "stable_step", results->length_unit);
    pdmc_csv_column(stream, "stable_step_error", results->length_unit);
    fputs(",steps,motion_error,motion_error_rate,drift,iterations,residual", stream);
    pdmc_csv_column(stream, "seconds", "s");
    fputc('\n', stream);
    for (int i = 0; i < s->level_count; i++) {
        const double numbers[] = {
            s->spacing[i],
            s->horizon[i],
            s->elements[i],
            s->unknowns[i],
            s->entries[i],
            s->error[i],
            pdmc_rate_of(s->error, i),
            s->classical[i],
            pdmc_rate_of(s->classical, i),
            s->stable_step[i],
            s->stable_step_error[i],
            s->steps[i],
            s->motion_error[i],
            pdmc_rate_of(s->motion_error, i),
            s->drift[i],
            s->iterations[i],
            s->residual[i],
            s->seconds[i],
        };
        fprintf(stream, "%d", i + 1);
        pdmc_csv_numbers(stream, sizeof numbers / sizeof numbers[0], numbers);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_values(const pdmc_results *results, FILE *stream)
{
    const pdmc_scalar_record *s = &results->scalar;
    fputs("value", stream);
    pdmc_csv_column(stream, "x", results->length_unit);
    pdmc_csv_column(stream, "y", results->length_unit);
    fputs(",field,wave,moved\n", stream);
    for (int i = 0; i < s->value_count; i++) {
        fprintf(stream, "%d", i);
        pdmc_csv_numbers(stream, 2, &s->position[2 * i]);
        pdmc_csv_number(stream, s->value[i]);
        pdmc_csv_number(stream, s->wave[i]);
        pdmc_csv_number(stream, s->moved[i]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}
