// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/design.h"

#include "base/base_impl.h"
#include "random/design_impl.h"

#include <inttypes.h>

static pdmc_status check_latin_hypercube(uint64_t samples, uint64_t replicates)
{
    PDMC_REQUIRE(samples % replicates == 0,
                 "%" PRIu64 " samples are no multiple of the %" PRIu64 " replicates of a Latin hypercube", samples,
                 replicates);
    return PDMC_OK;
}

static pdmc_status check_sobol(size_t dimension)
{
    PDMC_REQUIRE(dimension <= PDMC_DESIGN_SOBOL_DIMENSIONS, "Sobol' points have at most %d dimensions, not %zu",
                 PDMC_DESIGN_SOBOL_DIMENSIONS, dimension);
    return PDMC_OK;
}

static pdmc_status check(pdmc_design_kind kind, size_t dimension, uint64_t samples, uint64_t replicates)
{
    PDMC_REQUIRE(dimension >= 1, "a design of no dimension");
    PDMC_REQUIRE(samples >= 1, "a design of no samples");
    PDMC_REQUIRE(replicates >= 1, "a design of no replicates");
    PDMC_REQUIRE((samples - 1) / replicates <= UINT32_MAX, "%" PRIu64 " samples are more than 2^32 a replicate",
                 samples);
    switch (kind) {
    case PDMC_DESIGN_LATIN_HYPERCUBE: return check_latin_hypercube(samples, replicates);
    case PDMC_DESIGN_SOBOL: return check_sobol(dimension);
    case PDMC_DESIGN_MONTE_CARLO: break;
    }
    return pdmc_raise(PDMC_ERR_ARG, "kind %d is no design", (int)kind);
}

pdmc_status pdmc_design_create(pdmc_design_kind kind, uint64_t seed, size_t dimension, uint64_t samples,
                               uint64_t replicates, pdmc_design **design)
{
    pdmc_status status = PDMC_OK;
    pdmc_design *made = NULL;
    PDMC_TRY(check(kind, dimension, samples, replicates));
    PDMC_NEW(made, 1);
    *made =
        (pdmc_design){.kind = kind, .seed = seed, .samples = samples, .replicates = replicates, .dimension = dimension};
    if (kind == PDMC_DESIGN_SOBOL) {
        PDMC_NEW(made->directions, dimension * PDMC_SOBOL_DIGITS);
        PDMC_TRY(pdmc_sobol_directions(dimension, made->directions));
    }
    *design = made;
    made = NULL;

done:
    pdmc_design_destroy(&made);
    return status;
}

void pdmc_design_destroy(pdmc_design **design)
{
    if (!design || !*design) return;
    pdmc_free((*design)->directions);
    pdmc_free(*design);
    *design = NULL;
}

void pdmc_design_point(const pdmc_design *design, uint64_t sample, double u[])
{
    if (design->kind == PDMC_DESIGN_SOBOL) pdmc_sobol_point(design, sample, u);
    else pdmc_latin_hypercube_point(design, sample, u);
}
