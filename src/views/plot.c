// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "views/plots.h"

/// One picture of what a study has, by what it is of.
typedef enum {
    OF_DENSITY,
    OF_QUANTILES,
    OF_DIRECTION,
    OF_MICROMODULUS,
    OF_ENERGIES,
    OF_DISPLACEMENTS,
    OF_PLATE,
    OF_ELASTIC_DISPLACEMENT,
    OF_ELASTIC_STRAIN,
    OF_ELASTIC_ENERGIES,
    OF_SCALAR_CONVERGENCE,
    OF_SCALAR_FIELD,
    OF_EXPLICIT_ENERGIES,
    OF_EXPLICIT_TIPS,
    OF_LOAD_DISPLACEMENT,
    OF_EXPLICIT_DAMAGE,
    OF_EXPLICIT_FRAGMENTS,
    OF_EXPLICIT_MASSES,
    OF_GROWTH,
    OF_PATHS,
    OF_FORCES,
    OF_QUADRATURE_POINTS,
    OF_QUADRATURE_TIME
} subject;

static pdmc_status draw(const pdmc_results *r, subject of, int tip, pdmc_measure measure, pdmc_figure *figure)
{
    switch (of) {
    case OF_DENSITY: return pdmc_draw_density(r, tip, measure, figure);
    case OF_QUANTILES: pdmc_draw_quantiles(r, tip, measure, figure); break;
    case OF_DIRECTION: pdmc_draw_direction(r, tip, figure); break;
    case OF_MICROMODULUS: pdmc_draw_micromodulus(r, figure); break;
    case OF_ENERGIES: pdmc_draw_motion_energies(r, figure); break;
    case OF_DISPLACEMENTS: pdmc_draw_motion_displacements(r, figure); break;
    case OF_PLATE: pdmc_draw_plate(r, figure); break;
    case OF_ELASTIC_DISPLACEMENT: pdmc_draw_elastic_displacement(r, figure); break;
    case OF_ELASTIC_STRAIN: pdmc_draw_elastic_strain(r, figure); break;
    case OF_ELASTIC_ENERGIES: pdmc_draw_elastic_energies(r, figure); break;
    case OF_SCALAR_CONVERGENCE: pdmc_draw_scalar_convergence(r, figure); break;
    case OF_SCALAR_FIELD: pdmc_draw_scalar_field(r, figure); break;
    case OF_EXPLICIT_ENERGIES: pdmc_draw_explicit_energies(r, figure); break;
    case OF_EXPLICIT_TIPS: pdmc_draw_explicit_tips(r, figure); break;
    case OF_LOAD_DISPLACEMENT: pdmc_draw_load_displacement(r, figure); break;
    case OF_EXPLICIT_DAMAGE: return pdmc_draw_explicit_damage(r, figure);
    case OF_EXPLICIT_FRAGMENTS: return pdmc_draw_explicit_fragments(r, figure);
    case OF_GROWTH: pdmc_draw_growth(r, tip, figure); break;
    case OF_PATHS: pdmc_draw_paths(r, figure); break;
    case OF_FORCES: return pdmc_draw_forces(r, tip, figure);
    case OF_EXPLICIT_MASSES: pdmc_draw_explicit_masses(r, figure); break;
    case OF_QUADRATURE_POINTS: pdmc_draw_quadrature_points(r, figure); break;
    case OF_QUADRATURE_TIME: pdmc_draw_quadrature_time(r, figure); break;
    }
    return PDMC_OK;
}

static pdmc_status plot(const pdmc_results *r, const char *folder, const char *stem, subject of, int tip,
                        pdmc_measure measure)
{
    pdmc_status status = PDMC_OK;
    pdmc_figure figure;
    PDMC_TRY(pdmc_figure_open(folder, stem, &figure));
    PDMC_TRY(draw(r, of, tip, measure, &figure));
    PDMC_TRY(pdmc_figure_draw(&figure));

done:
    pdmc_figure_close(&figure);
    return status;
}

static pdmc_status plot_measure(const pdmc_results *r, const char *folder, int tip, pdmc_measure measure)
{
    pdmc_status status = PDMC_OK;
    char stem[sizeof r->tips[tip].name + 32];
    if (r->histogram_bins > 0) {
        snprintf(stem, sizeof stem, "pdf_%s_%s", r->tips[tip].name, pdmc_measure_names[measure]);
        PDMC_TRY(plot(r, folder, stem, OF_DENSITY, tip, measure));
    }
    snprintf(stem, sizeof stem, "quantiles_%s_%s", r->tips[tip].name, pdmc_measure_names[measure]);
    PDMC_TRY(plot(r, folder, stem, OF_QUANTILES, tip, measure));

done:
    return status;
}

static pdmc_status plot_tip(const pdmc_results *r, const char *folder, int tip)
{
    pdmc_status status = PDMC_OK;
    char stem[sizeof r->tips[tip].name + 32];
    for (int m = 0; m < PDMC_MEASURES; m++) PDMC_TRY(plot_measure(r, folder, tip, (pdmc_measure)m));
    snprintf(stem, sizeof stem, "direction_%s", r->tips[tip].name);
    PDMC_TRY(plot(r, folder, stem, OF_DIRECTION, tip, r->measure));

done:
    return status;
}

static pdmc_status plot_motion(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(plot(r, folder, "motion_energies", OF_ENERGIES, 0, r->measure));
    if (r->motion.probe_count > 0) PDMC_TRY(plot(r, folder, "motion_displacements", OF_DISPLACEMENTS, 0, r->measure));

done:
    return status;
}

static pdmc_status plot_plate(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    if (r->angle_count > 0)
        for (int t = 0; t < r->tip_count; t++) PDMC_TRY(plot_tip(r, folder, t));
    if (r->bin_count > 0 && r->kept_count > 0)
        PDMC_TRY(plot(r, folder, "micromodulus", OF_MICROMODULUS, 0, r->measure));
    if (r->motion.time_count > 0) PDMC_TRY(plot_motion(r, folder));
    PDMC_TRY(plot(r, folder, "plate", OF_PLATE, 0, r->measure));

done:
    return status;
}

static pdmc_status plot_ensemble(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    char stem[PDMC_LONG_NAME_SIZE + 8];
    for (int t = 0; t < r->ensemble.tip_count && status == PDMC_OK; t++) {
        snprintf(stem, sizeof stem, "growth_%s", r->particles.tips[t].name);
        status = plot(r, folder, stem, OF_GROWTH, t, r->measure);
    }
    if (r->ensemble.tip_count > 0 && status == PDMC_OK) status = plot(r, folder, "paths", OF_PATHS, 0, r->measure);
    for (int c = 0; c < r->ensemble.condition_count && status == PDMC_OK; c++) {
        snprintf(stem, sizeof stem, "forces_%s", r->particles.conditions[c].name);
        status = plot(r, folder, stem, OF_FORCES, c, r->measure);
    }
    return status;
}

static pdmc_status plot_explicit(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    const pdmc_explicit_record *p = &r->particles;
    PDMC_TRY(plot(r, folder, "energies", OF_EXPLICIT_ENERGIES, 0, r->measure));
    if (p->residual && p->condition_count + p->sphere_count > 0)
        PDMC_TRY(plot(r, folder, "load_displacement", OF_LOAD_DISPLACEMENT, 0, r->measure));
    if (p->tip_count > 0) PDMC_TRY(plot(r, folder, "tips", OF_EXPLICIT_TIPS, 0, r->measure));
    if (p->state_count > 0) PDMC_TRY(plot(r, folder, "damage", OF_EXPLICIT_DAMAGE, 0, r->measure));
    if (p->fragment_count > p->body_count) {
        PDMC_TRY(plot(r, folder, "fragments", OF_EXPLICIT_FRAGMENTS, 0, r->measure));
        PDMC_TRY(plot(r, folder, "fragment_masses", OF_EXPLICIT_MASSES, 0, r->measure));
    }
    PDMC_TRY(plot_ensemble(r, folder));

done:
    return status;
}

static pdmc_status plot_elastic(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(plot(r, folder, "displacement", OF_ELASTIC_DISPLACEMENT, 0, r->measure));
    PDMC_TRY(plot(r, folder, "strain", OF_ELASTIC_STRAIN, 0, r->measure));
    if (r->elastic.energy_count > 0) PDMC_TRY(plot(r, folder, "energies", OF_ELASTIC_ENERGIES, 0, r->measure));

done:
    return status;
}

static pdmc_status plot_scalar(const pdmc_results *r, const char *folder)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(plot(r, folder, "convergence", OF_SCALAR_CONVERGENCE, 0, r->measure));
    PDMC_TRY(plot(r, folder, "field", OF_SCALAR_FIELD, 0, r->measure));

done:
    return status;
}

static pdmc_status plot_quadrature(const pdmc_results *r, const char *folder)
{
    const pdmc_status status = plot(r, folder, "quadrature_points", OF_QUADRATURE_POINTS, 0, r->measure);
    return status == PDMC_OK ? plot(r, folder, "quadrature_time", OF_QUADRATURE_TIME, 0, r->measure) : status;
}

pdmc_status pdmc_view_plot(const pdmc_results *results, const char *folder)
{
    static pdmc_status (*const of_kind[])(const pdmc_results *, const char *) = {
        [PDMC_STATIC] = plot_plate, [PDMC_DYNAMIC] = plot_plate, [PDMC_EXPLICIT] = plot_explicit,
        [PDMC_QUASI_STATIC] = plot_explicit, [PDMC_SCALAR] = plot_scalar,
        [PDMC_ELASTIC] = plot_elastic, [PDMC_QUADRATURE] = plot_quadrature};
    pdmc_status status = PDMC_OK;
    pdmc_locale locale;
    PDMC_TRY(pdmc_locale_plain(&locale));
    PDMC_TRY(pdmc_folder_make(folder));
    PDMC_TRY(of_kind[results->kind](results, folder));

done:
    pdmc_locale_restore(&locale);
    return status;
}
