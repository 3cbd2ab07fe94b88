// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/csv.h"

static void put_estimate_columns(FILE *stream, const char *name, const char *unit)
{
    char column[64];
    pdmc_csv_column(stream, name, unit);
    snprintf(column, sizeof column, "%s_lower", name);
    pdmc_csv_column(stream, column, unit);
    snprintf(column, sizeof column, "%s_upper", name);
    pdmc_csv_column(stream, column, unit);
}

static void put_estimate(FILE *stream, const pdmc_estimate *e)
{
    pdmc_csv_number(stream, e->value);
    pdmc_csv_number(stream, e->lower);
    pdmc_csv_number(stream, e->upper);
}

static void put_sample_header(const pdmc_results *r, FILE *stream)
{
    static const char *const speeds[] = {"mean_speed", "most_speed"};
    char unit[PDMC_UNIT_SIZE];
    fputs("sample,failure,load,velocity,youngs_modulus,fracture_energy", stream);
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    pdmc_csv_column(stream, "fracture", unit);
    fputs(",tip,outcome", stream);
    pdmc_csv_column(stream, "growth", r->length_unit);
    pdmc_csv_column(stream, "begin", r->time_unit);
    pdmc_results_unit(r, PDMC_UNIT_VELOCITY, sizeof unit, unit);
    for (int k = 0; k < 2; k++) pdmc_csv_column(stream, speeds[k], unit);
    pdmc_csv_column(stream, "end.x", r->length_unit);
    pdmc_csv_column(stream, "end.y", r->length_unit);
    fputc('\n', stream);
}

pdmc_status pdmc_csv_draws(const pdmc_results *r, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    put_sample_header(r, stream);
    for (int i = 0; i < e->sample_count * e->tip_count; i++) {
        const int s = i / e->tip_count;
        const double factors[] = {e->load[s], e->velocity[s], e->youngs_modulus[s], e->fracture_energy[s],
                                  e->fracture[s]};
        const double figures[] = {e->growth[i],     e->begin[i],   e->mean_speed[i],
                                  e->most_speed[i], e->end[2 * i], e->end[2 * i + 1]};
        fprintf(stream, "%d,%d", s, e->failure[s]);
        pdmc_csv_numbers(stream, sizeof factors / sizeof factors[0], factors);
        fputc(',', stream);
        pdmc_csv_text(stream, r->particles.tips[i % e->tip_count].name);
        fprintf(stream, ",%s", e->failure[s] == PDMC_SAMPLE_OK ? pdmc_outcome_names[e->outcome[i]] : "");
        pdmc_csv_numbers(stream, sizeof figures / sizeof figures[0], figures);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_forces(const pdmc_results *r, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    fputs("sample,failure,load,youngs_modulus,fracture_energy,condition", stream);
    pdmc_csv_column(stream, "largest_force", r->force_unit);
    fputs(",load_of_largest_force\n", stream);
    for (int i = 0; i < e->sample_count * e->condition_count; i++) {
        const int s = i / e->condition_count;
        fprintf(stream, "%d,%d", s, e->failure[s]);
        pdmc_csv_numbers(stream, 3, (double[]){e->load[s], e->youngs_modulus[s], e->fracture_energy[s]});
        fputc(',', stream);
        pdmc_csv_text(stream, r->particles.conditions[i % e->condition_count].name);
        pdmc_csv_numbers(stream, 2, (double[]){e->largest_force[i], e->load_of_force[i]});
        fputc('\n', stream);
    }
    return PDMC_OK;
}

pdmc_status pdmc_csv_paths(const pdmc_results *r, FILE *stream)
{
    const pdmc_ensemble_results *e = &r->ensemble;
    fputs("tip", stream);
    pdmc_csv_column(stream, "station", r->length_unit);
    fputs(",samples", stream);
    put_estimate_columns(stream, "mean", r->length_unit);
    put_estimate_columns(stream, "low", r->length_unit);
    put_estimate_columns(stream, "median", r->length_unit);
    put_estimate_columns(stream, "high", r->length_unit);
    fputc('\n', stream);
    for (int i = 0; i < e->tip_count * e->station_count; i++) {
        pdmc_csv_text(stream, r->particles.tips[i / e->station_count].name);
        pdmc_csv_number(stream, e->station[i % e->station_count]);
        pdmc_csv_number(stream, e->path_samples[i]);
        put_estimate(stream, &e->path_mean[i]);
        for (int q = 0; q < PDMC_QUANTILES; q++) put_estimate(stream, &e->path_quantiles[i * PDMC_QUANTILES + q]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}
