// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/family.h"

#include "base/base_impl.h"
#include "pdmc/discretisation.h"

typedef struct {
    pdmc_problem problem; // a copy but for the cracks, which are its own
    pdmc_discretisation discretisation;
} own_plate;

static pdmc_status make(const void *context, const double value[], bool measure_alone, pdmc_affine *model, void **plate)
{
    pdmc_status status = PDMC_OK;
    const pdmc_problem *problem = context;
    own_plate *made = NULL;
    PDMC_NEW(made, 1);
    *plate = made;
    made->problem = *problem;
    made->problem.cracks = NULL;
    made->problem.energy.measure_alone = measure_alone;
    PDMC_NEW(made->problem.cracks, problem->crack_count);
    pdmc_problem_place_cracks(problem, value, made->problem.cracks);
    if (!pdmc_problem_cracks_fit(problem, made->problem.cracks))
        PDMC_FAIL(PDMC_ERR_DATA, "the cracks leave the plate, are too short, or come too near");
    PDMC_TRY(pdmc_discretise(&made->problem, 1, &made->discretisation));
    PDMC_TRY(made->discretisation.verbs->affine(made->discretisation.method, model));
done:
    return status;
}

static void release(pdmc_affine *model, void *plate)
{
    own_plate *made = plate;
    pdmc_affine_clear(model);
    if (!made) return;
    pdmc_discretisation_clear(&made->discretisation);
    pdmc_free(made->problem.cracks);
    pdmc_free(made);
}

pdmc_affine_family pdmc_plate_family(const pdmc_problem *problem, int threads)
{
    return (pdmc_affine_family){.threads = threads, .context = problem, .make = make, .release = release};
}
