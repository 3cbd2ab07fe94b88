// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/variation.h"

#include "base/base_impl.h"
#include "pdmc/random.h"

#include <math.h>
#include <string.h>

pdmc_status pdmc_brittle_strengths(const pdmc_distribution *distribution, double strengths[])
{
    const pdmc_status status = pdmc_distribution_check(distribution);
    if (status != PDMC_OK) return status;
    for (int k = 0; k < PDMC_STRENGTH_CLASSES; k++) {
        const double z = pdmc_normal_quantile((k + 0.5) / PDMC_STRENGTH_CLASSES);
        strengths[k] = pdmc_distribution_value(distribution, z);
    }
    PDMC_REQUIRE(strengths[0] > 0.0, "the distribution of strengths: its least is %g, needs to be > 0", strengths[0]);
    return PDMC_OK;
}

static pdmc_status check_factors(const pdmc_particles_options *o, const pdmc_nodes *g, const double factors[],
                                 const char *name)
{
    PDMC_REQUIRE(!factors || o->factor_count == g->node_count, "%s: %d, there are %d nodes", name, o->factor_count,
                 g->node_count);
    for (int k = 0; factors && k < g->node_count; k++)
        PDMC_REQUIRE(factors[k] > 0.0 && isfinite(factors[k]), "%s[%d]: %g, needs to be > 0", name, k, factors[k]);
    return PDMC_OK;
}

/// Empty cells have 0, so that what is summed over neighbours counts nodes alone.
static pdmc_status spread(const pdmc_nodes *g, const double factors[], double **cells)
{
    pdmc_status status = PDMC_OK;
    if (!factors) return PDMC_OK;
    PDMC_NEW(*cells, g->cells + PDMC_LANES);
    for (int k = 0; k < g->node_count; k++) (*cells)[g->cell[k]] = factors[k];
done:
    return status;
}

static pdmc_status copy_cells(const pdmc_nodes *g, const double from[], double **to)
{
    pdmc_status status = PDMC_OK;
    if (!from) return PDMC_OK;
    PDMC_NEW(*to, g->cells + PDMC_LANES);
    memcpy(*to, from, (g->cells + PDMC_LANES) * sizeof **to);
done:
    return status;
}

static bool is_in_zone(const pdmc_shape *zone, const pdmc_nodes *g, size_t cell)
{
    const double slack = 1e-9 * g->spacing;
    double x[PDMC_AXES];
    for (int a = 0; a < PDMC_AXES; a++) x[a] = g->reference[a][cell];
    return pdmc_shape_holds(zone, x, slack);
}

/// Nodes in a zone never are the weaker ones of a bond, so that those of two of them never break.
static pdmc_status spare_zones(const pdmc_particles_options *o, const pdmc_nodes *g, double **first_strength)
{
    pdmc_status status = PDMC_OK;
    if (o->no_fail_count == 0) return PDMC_OK;
    if (!*first_strength) {
        PDMC_NEW(*first_strength, g->cells + PDMC_LANES);
        for (int k = 0; k < g->node_count; k++) (*first_strength)[g->cell[k]] = 1.0;
    }
    for (int z = 0; z < o->no_fail_count; z++) {
        bool any = false;
        for (int k = 0; k < g->node_count; k++) {
            if (!is_in_zone(&o->no_fail[z], g, g->cell[k])) continue;
            (*first_strength)[g->cell[k]] = INFINITY;
            any = true;
        }
        if (!any) PDMC_FAIL(PDMC_ERR_ARG, "no_fail[%d]: holds no node", z);
    }
done:
    return status;
}

static void multiply_by_laws(const pdmc_nodes *g, const pdmc_brittle_law laws[], double first_strength[])
{
    for (int b = 0; first_strength && b < g->block_count; b++)
        for (unsigned left = g->blocks[b].nodes; left; left &= left - 1)
            first_strength[g->blocks[b].cell + (size_t)__builtin_ctz(left)] *=
                laws[g->blocks[b].material].critical_stretch;
}

static pdmc_status copy_strengths(const pdmc_particles_options *o, pdmc_brittle_law laws[], pdmc_variation *v)
{
    pdmc_status status = PDMC_OK;
    bool any = false;
    for (int m = 0; m < o->material_count; m++) any |= o->materials[m].strengths != NULL;
    if (!any) return PDMC_OK;
    PDMC_NEW(v->strengths, (size_t)PDMC_STRENGTH_CLASSES * (size_t)o->material_count);
    for (int m = 0; m < o->material_count; m++) {
        double *own = &v->strengths[(size_t)PDMC_STRENGTH_CLASSES * (size_t)m];
        if (!o->materials[m].strengths) continue;
        memcpy(own, o->materials[m].strengths, PDMC_STRENGTH_CLASSES * sizeof *own);
        laws[m].strengths = own;
    }
done:
    return status;
}

static pdmc_hash_key draw_key(const pdmc_particles_options *o)
{
    const double words = 4294967296.0; // 2^32
    double u[2];
    pdmc_random_uniform(o->seed, PDMC_STREAM_BONDS, o->sample, 0, 2, u);
    return (pdmc_hash_key){(uint32_t)(u[0] * words), (uint32_t)(u[1] * words)};
}

pdmc_status pdmc_variation_create(const pdmc_particles_options *o, const pdmc_nodes *g, pdmc_brittle_law laws[],
                                  pdmc_variation *v)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(check_factors(o, g, o->stiffness_factors, "stiffness_factors"));
    PDMC_TRY(check_factors(o, g, o->strength_factors, "strength_factors"));
    PDMC_TRY(spread(g, o->stiffness_factors, &v->stiffness));
    PDMC_TRY(spread(g, o->strength_factors, &v->first_strength));
    PDMC_TRY(spare_zones(o, g, &v->first_strength));
    if (v->joints.bonded) PDMC_TRY(copy_cells(g, v->first_strength, &v->relative_strength));
    multiply_by_laws(g, laws, v->first_strength);
    PDMC_TRY(copy_strengths(o, laws, v));
    v->key = draw_key(o);
done:
    return status;
}

void pdmc_variation_clear(pdmc_variation *v)
{
    pdmc_free(v->stiffness);
    pdmc_free(v->first_strength);
    pdmc_free(v->relative_strength);
    pdmc_joints_clear(&v->joints);
    pdmc_free(v->strengths);
    *v = (pdmc_variation){0};
}

/// 1 + beta^2 times the excess along fibres, beta the cosine of bond and fibre (Silling & Askari 2005, eq. 10).
static double along_fibres(const pdmc_nodes *g, const double fibre[], double excess, size_t cell, size_t other)
{
    double beta = 0.0, square = 0.0;
    for (int a = 0; a < PDMC_AXES && excess != 0.0; a++) {
        const double step = g->reference[a][other] - g->reference[a][cell];
        beta += step * fibre[a];
        square += step * step;
    }
    return square > 0.0 ? 1.0 + excess * beta * beta / square : 1.0;
}

double pdmc_variation_micromodulus(const pdmc_variation *v, const pdmc_nodes *g, const pdmc_brittle_law *law,
                                   size_t cell, size_t other)
{
    const double factor = v->stiffness ? 0.5 * (v->stiffness[cell] + v->stiffness[other]) : 1.0;
    double c = law->micromodulus, excess = law->fibre_excess;
    if (v->joints.bonded) {
        const size_t pair = pdmc_joints_row(&v->joints, g->body[cell]) + (size_t)(g->body[other] + 1);
        c = v->joints.micromodulus[pair];
        excess = v->joints.fibre_excess[pair];
    }
    return c * factor * along_fibres(g, law->fibre, excess, cell, other);
}
