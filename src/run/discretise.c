// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdmc/discretisation.h"

#include "base/base_impl.h"
#include "bond/method.h"
#include "galerkin/method.h"
#include "kansa/method.h"
#include "paper/method.h"
#include "visible/method.h"

static pdmc_status collocate(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
{
    switch (problem->solver.crack_model) {
    case PDMC_CRACKS_ANALYTIC: return pdmc_kansa_discretise(problem, threads, out);
    case PDMC_CRACKS_VISIBLE: return pdmc_visible_discretise(problem, threads, out);
    case PDMC_CRACKS_PAPER: return pdmc_paper_discretise(problem, threads, out);
    }
    return pdmc_raise(PDMC_ERR_ARG, "crack model %d is unknown", (int)problem->solver.crack_model);
}

pdmc_status pdmc_discretise(const pdmc_problem *problem, int threads, pdmc_discretisation *out)
{
    *out = (pdmc_discretisation){0};
    switch (problem->solver.method) {
    case PDMC_METHOD_KANSA: return collocate(problem, threads, out);
    case PDMC_METHOD_BOND: return pdmc_bond_discretise(problem, threads, out);
    case PDMC_METHOD_GALERKIN: return pdmc_galerkin_discretise(problem, threads, out);
    }
    return pdmc_raise(PDMC_ERR_ARG, "method %d is unknown", (int)problem->solver.method);
}

void pdmc_discretisation_clear(pdmc_discretisation *discretisation)
{
    if (discretisation->method) discretisation->verbs->destroy(discretisation->method);
    *discretisation = (pdmc_discretisation){0};
}
