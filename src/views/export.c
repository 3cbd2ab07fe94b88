// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "results/whole_file.h"
#include "views/csv.h"
#include "views/density.h"
#include "views/views_impl.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

/// The units that stand in the header lines.
typedef struct {
    char energy[PDMC_UNIT_SIZE], density[PDMC_UNIT_SIZE], stress_intensity[PDMC_UNIT_SIZE], work[PDMC_UNIT_SIZE];
} csv_units;

typedef pdmc_status csv_writer(const pdmc_results *r, const csv_units *units, FILE *stream);

static void put_estimate(FILE *stream, const pdmc_estimate *e)
{
    pdmc_csv_number(stream, e->value);
    pdmc_csv_number(stream, e->lower);
    pdmc_csv_number(stream, e->upper);
}

/// The fields that say whose line it is: tip, measure, angle.
static void put_place(FILE *stream, const pdmc_results *r, int tip, int measure, int angle)
{
    pdmc_csv_text(stream, r->tips[tip].name);
    fprintf(stream, ",%s", pdmc_measure_names[measure]);
    pdmc_csv_number(stream, r->angles[angle]);
}

/// A row a bin, whose smooth density is that at its middle.
static pdmc_status write_pdf_at(const pdmc_results *r, int t, int m, int k, FILE *stream)
{
    pdmc_status status = PDMC_OK;
    const size_t at = pdmc_place(r, t, k), bins = (size_t)r->histogram_bins;
    const pdmc_energy_statistics *s = &r->statistics[m];
    const double *edges = &s->histogram_edges[at * (bins + 1)];
    double *middle = NULL;
    pdmc_estimate *smooth = NULL;
    PDMC_NEW(middle, bins);
    PDMC_NEW(smooth, bins);
    for (size_t b = 0; b < bins; b++) middle[b] = 0.5 * (edges[b] + edges[b + 1]);
    PDMC_TRY(pdmc_view_density(r, (pdmc_measure)m, at, bins, middle, smooth));
    for (size_t b = 0; b < bins; b++) {
        put_place(stream, r, t, m, k);
        pdmc_csv_number(stream, edges[b]);
        pdmc_csv_number(stream, edges[b + 1]);
        put_estimate(stream, &s->density[at * bins + b]);
        fprintf(stream, ",%lld", (long long)s->histogram_counts[at * (bins + 2) + b + 1]);
        put_estimate(stream, &smooth[b]);
        fputc('\n', stream);
    }

done:
    pdmc_free(middle);
    pdmc_free(smooth);
    return status;
}

static pdmc_status write_pdf(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    pdmc_status status = PDMC_OK;
    fputs("tip,measure,angle[rad]", stream);
    pdmc_csv_column(stream, "bin_lower", units->energy);
    pdmc_csv_column(stream, "bin_upper", units->energy);
    pdmc_csv_column(stream, "density", units->density);
    pdmc_csv_column(stream, "density_lower", units->density);
    pdmc_csv_column(stream, "density_upper", units->density);
    fputs(",count", stream);
    pdmc_csv_column(stream, "smooth_density", units->density);
    pdmc_csv_column(stream, "smooth_density_lower", units->density);
    pdmc_csv_column(stream, "smooth_density_upper", units->density);
    fputc('\n', stream);
    for (int t = 0; t < r->tip_count; t++)
        for (int m = 0; m < PDMC_MEASURES; m++)
            for (int k = 0; k < r->angle_count; k++) PDMC_TRY(write_pdf_at(r, t, m, k, stream));

done:
    return status;
}

static void write_statistic(const pdmc_results *r, int t, int m, int k, const char *name, const pdmc_estimate *e,
                            FILE *stream)
{
    put_place(stream, r, t, m, k);
    fprintf(stream, ",%s", name);
    put_estimate(stream, e);
    fputc('\n', stream);
}

static void write_statistics_at(const pdmc_results *r, int t, int m, int k, FILE *stream)
{
    const size_t at = pdmc_place(r, t, k);
    const pdmc_energy_statistics *s = &r->statistics[m];
    write_statistic(r, t, m, k, "mean", &s->mean[at], stream);
    if (r->control.tip_count > 0 && m == (int)r->measure)
        write_statistic(r, t, m, k, "controlled_mean", &r->control.mean[at], stream);
    write_statistic(r, t, m, k, "standard_deviation", &s->standard_deviation[at], stream);
    for (size_t q = 0; q < PDMC_QUANTILES; q++) {
        char level[16];
        snprintf(level, sizeof level, "%.2f", pdmc_quantile_levels[q]);
        write_statistic(r, t, m, k, level, &s->quantiles[at * PDMC_QUANTILES + q], stream);
    }
}

static pdmc_status write_quantiles(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    fputs("tip,measure,angle[rad],statistic", stream);
    pdmc_csv_column(stream, "value", units->energy);
    pdmc_csv_column(stream, "lower", units->energy);
    pdmc_csv_column(stream, "upper", units->energy);
    fputc('\n', stream);
    for (int t = 0; t < r->tip_count; t++)
        for (int m = 0; m < PDMC_MEASURES; m++)
            for (int k = 0; k < r->angle_count; k++) write_statistics_at(r, t, m, k, stream);
    return PDMC_OK;
}

static pdmc_status write_direction(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    (void)units;
    fputs("tip,measure,angle[rad],probability,lower,upper\n", stream);
    for (int t = 0; t < r->tip_count; t++)
        for (int k = 0; k < r->angle_count; k++) {
            put_place(stream, r, t, r->measure, k);
            put_estimate(stream, &r->direction[pdmc_place(r, t, k)]);
            fputc('\n', stream);
        }
    return PDMC_OK;
}

static void write_samples_header(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    const struct {
        const char *suffix, *unit;
    } columns[] = {
        {".K_I", units->stress_intensity},
        {".K_II", units->stress_intensity},
        {".bond_energy_max", units->energy},
        {".griffith_energy_max", units->energy},
        {".fracture_energy", units->energy},
    };
    fputs("sample,failure,load_factor,effective_modulus,contraction", stream);
    for (int t = 0; t < r->tip_count; t++)
        for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) {
            char column[sizeof r->tips[t].name + 32];
            snprintf(column, sizeof column, "%s%s", r->tips[t].name, columns[i].suffix);
            pdmc_csv_column(stream, column, columns[i].unit);
        }
    fputc('\n', stream);
}

static pdmc_status write_samples(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    static const char *const failures[] = {
        [PDMC_SAMPLE_OK] = "none",
        [PDMC_SAMPLE_DIVERGED] = "diverged",
        [PDMC_SAMPLE_SINGULAR] = "singular",
        [PDMC_SAMPLE_SOFT] = "soft",
        [PDMC_SAMPLE_GEOMETRY] = "geometry",
    };
    write_samples_header(r, units, stream);
    for (int s = 0; s < r->sample_count; s++) {
        fprintf(stream, "%d,%s", s, failures[r->failure[s]]);
        pdmc_csv_number(stream, r->load_factor[s]);
        pdmc_csv_number(stream, r->effective_modulus[s]);
        pdmc_csv_number(stream, r->contraction[s]);
        for (int t = 0; t < r->tip_count; t++) {
            const size_t place = (size_t)s * (size_t)r->tip_count + (size_t)t;
            for (size_t k = 0; k < 2; k++) pdmc_csv_number(stream, r->stress_intensity[2 * place + k]);
            for (int m = 0; m < PDMC_MEASURES; m++) pdmc_csv_number(stream, r->largest_energy[m][place]);
            pdmc_csv_number(stream, r->sample_fracture_energy[place]);
        }
        fputc('\n', stream);
    }
    return PDMC_OK;
}

static pdmc_status write_energy_samples(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    fputs("sample,tip,angle[rad]", stream);
    for (int m = 0; m < PDMC_MEASURES; m++) pdmc_csv_column(stream, pdmc_measure_names[m], units->energy);
    fputc('\n', stream);
    size_t at = 0;
    for (int s = 0; s < r->kept_count; s++)
        for (int t = 0; t < r->tip_count; t++)
            for (int k = 0; k < r->angle_count; k++, at++) {
                fprintf(stream, "%d,", s);
                pdmc_csv_text(stream, r->tips[t].name);
                pdmc_csv_number(stream, r->angles[k]);
                for (int m = 0; m < PDMC_MEASURES; m++) pdmc_csv_number(stream, r->energy[m][at]);
                fputc('\n', stream);
            }
    return PDMC_OK;
}

// The displacement at the mean, on both faces of every crack.
static pdmc_status write_faces(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    static const char *const columns[] = {"x", "y", "left_x", "left_y", "right_x", "right_y"};
    (void)units;
    fputs("crack", stream);
    for (size_t i = 0; i < sizeof columns / sizeof columns[0]; i++) pdmc_csv_column(stream, columns[i], r->length_unit);
    fputc('\n', stream);
    const size_t points = (size_t)r->field.face_points;
    for (size_t at = 0; at < (size_t)r->crack_count * points; at++) {
        fprintf(stream, "%zu", at / points);
        for (size_t k = 0; k < 2; k++) pdmc_csv_number(stream, r->field.face_position[2 * at + k]);
        for (size_t k = 0; k < 4; k++) pdmc_csv_number(stream, r->field.face_displacement[4 * at + k]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

static void write_motion_header(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    static const char *const energies[] = {"kinetic", "elastic", "dissipated", "work"};
    char column[sizeof r->motion.probes->name + PDMC_UNIT_SIZE];
    snprintf(column, sizeof column, "time[%s]", r->time_unit);
    pdmc_csv_text(stream, column);
    fputs(",load_factor", stream);
    for (size_t i = 0; i < sizeof energies / sizeof energies[0]; i++) pdmc_csv_column(stream, energies[i], units->work);
    for (int p = 0; p < r->motion.probe_count; p++)
        for (int k = 0; k < 2; k++) {
            snprintf(column, sizeof column, "%s.%c", r->motion.probes[p].name, "xy"[k]);
            pdmc_csv_column(stream, column, r->length_unit);
        }
    fputc('\n', stream);
}

static pdmc_status write_motion(const pdmc_results *r, const csv_units *units, FILE *stream)
{
    const pdmc_motion_record *m = &r->motion;
    write_motion_header(r, units, stream);
    for (int i = 0; i < m->time_count; i++) {
        fprintf(stream, "%.17g", m->time[i]);
        pdmc_csv_number(stream, m->load_factor[i]);
        pdmc_csv_number(stream, m->kinetic[i]);
        pdmc_csv_number(stream, m->elastic[i]);
        pdmc_csv_number(stream, m->dissipated[i]);
        pdmc_csv_number(stream, m->work[i]);
        for (int p = 0; p < m->probe_count; p++)
            for (int k = 0; k < 2; k++) pdmc_csv_number(stream, pdmc_probe_displacement(m, i, p)[k]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

/// A file of one kind of study, written by one of the two.
typedef struct {
    const char *name;
    pdmc_problem_kind kind;
    csv_writer *write;
    pdmc_status (*print)(const pdmc_results *r, FILE *stream);
} csv_file;

/// Writes through a stream of its own, since the descriptor belongs to the file.
static pdmc_status write_stream(pdmc_whole_file *file, const pdmc_results *r, const csv_units *units,
                                const csv_file *of)
{
    const int descriptor = dup(file->descriptor);
    FILE *stream = descriptor >= 0 ? fdopen(descriptor, "w") : NULL;
    if (!stream) {
        const int error = errno;
        if (descriptor >= 0) close(descriptor);
        return pdmc_raise_errno(file->path, error);
    }
    errno = 0;
    const pdmc_status status = of->write ? of->write(r, units, stream) : of->print(r, stream);
    const bool failed = ferror(stream) != 0;
    if (fclose(stream) != 0 || failed) return pdmc_raise_errno(file->path, errno ? errno : EIO);
    return status;
}

static pdmc_status export_file(const pdmc_results *r, const csv_units *units, const char *folder, const csv_file *of)
{
    pdmc_status status = PDMC_OK;
    pdmc_whole_file file = {0};
    char *path = pdmc_folder_path(folder, of->name);
    if (!path) return PDMC_ERR_NOMEM;
    PDMC_TRY(pdmc_whole_file_open(path, true, &file));
    PDMC_TRY(write_stream(&file, r, units, of));
    PDMC_TRY(pdmc_whole_file_appear(&file, true));

done:
    pdmc_whole_file_discard(&file);
    pdmc_free(path);
    return status;
}

/// Above this, every energy of every sample that is kept as text is of no use: it is in the result file.
static bool energies_are_few(const pdmc_results *r)
{
    return (double)r->kept_count * r->tip_count * r->angle_count <= 1e6;
}

static const csv_file files[] = {
    {"pdf.csv", PDMC_STATIC, .write = write_pdf},
    {"quantiles.csv", PDMC_STATIC, .write = write_quantiles},
    {"direction.csv", PDMC_STATIC, .write = write_direction},
    {"samples.csv", PDMC_STATIC, .write = write_samples},
    {"energy_samples.csv", PDMC_STATIC, .write = write_energy_samples},
    {"faces.csv", PDMC_STATIC, .write = write_faces},
    {"motion.csv", PDMC_DYNAMIC, .write = write_motion},
    {"records.csv", PDMC_EXPLICIT, .print = pdmc_csv_records},
    {"nodes.csv", PDMC_EXPLICIT, .print = pdmc_csv_nodes},
    {"fragments.csv", PDMC_EXPLICIT, .print = pdmc_csv_fragments},
    {"samples.csv", PDMC_EXPLICIT, .print = pdmc_csv_draws},
    {"paths.csv", PDMC_EXPLICIT, .print = pdmc_csv_paths},
    {"forces.csv", PDMC_EXPLICIT, .print = pdmc_csv_forces},
    {"levels.csv", PDMC_SCALAR, .print = pdmc_csv_levels},
    {"line.csv", PDMC_ELASTIC, .print = pdmc_csv_line},
    {"nodes.csv", PDMC_ELASTIC, .print = pdmc_csv_solid_nodes},
    {"faces.csv", PDMC_ELASTIC, .print = pdmc_csv_faces},
    {"energies.csv", PDMC_ELASTIC, .print = pdmc_csv_energies},
    {"values.csv", PDMC_SCALAR, .print = pdmc_csv_values},
    {"quadrature.csv", PDMC_QUADRATURE, .print = pdmc_csv_quadrature},
};

static bool is_wanted(const pdmc_results *r, const csv_file *file)
{
    const bool is_of_draws = file->print == pdmc_csv_draws || file->print == pdmc_csv_paths;
    if (file->write == write_energy_samples && !energies_are_few(r)) return false;
    if (is_of_draws && r->ensemble.sample_count == 0) return false;
    if (file->print == pdmc_csv_forces && r->ensemble.condition_count == 0) return false;
    return file->kind == (pdmc_is_of_bodies(r->kind) ? PDMC_EXPLICIT : r->kind);
}

pdmc_status pdmc_view_export(const pdmc_results *results, const char *folder)
{
    pdmc_status status = PDMC_OK;
    pdmc_locale locale = {0};
    csv_units units;
    pdmc_results_unit(results, PDMC_UNIT_ENERGY, sizeof units.energy, units.energy);
    pdmc_results_unit(results, PDMC_UNIT_DENSITY, sizeof units.density, units.density);
    pdmc_results_unit(results, PDMC_UNIT_WORK, sizeof units.work, units.work);
    pdmc_results_unit(results, PDMC_UNIT_STRESS_INTENSITY, sizeof units.stress_intensity, units.stress_intensity);
    PDMC_TRY(pdmc_locale_plain(&locale));
    PDMC_TRY(pdmc_folder_make(folder));
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        if (is_wanted(results, &files[i])) PDMC_TRY(export_file(results, &units, folder, &files[i]));

done:
    pdmc_locale_restore(&locale);
    return status;
}
