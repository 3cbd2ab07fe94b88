// SPDX-License-Identifier: GPL-3.0-or-later
#include "stochastic/toughness.h"

#include "base/base_impl.h"

#include <math.h>

// Above what the rounding of n covariances and of their factorisation can take from an eigenvalue, some n (n + 1) 1e-16
// (Higham 2002, theorem 10.7).
static const double lowered_for_each_tip = 1e-12;

static void correlate_tips(const pdmc_problem *problem, const pdmc_crack cracks[], double correlation[])
{
    const pdmc_covariance *covariance = &pdmc_problem_uncertainty(problem, PDMC_QUANTITY_FRACTURE_ENERGY)->covariance;
    const int count = problem->energy.tip_count, *tips = problem->energy.tips;
    for (int i = 0; i < count; i++) {
        const double *x = pdmc_crack_end(cracks, tips[i]);
        correlation[i * count + i] = 1.0;
        for (int j = 0; j < i; j++) {
            const double *y = pdmc_crack_end(cracks, tips[j]);
            const double kernel = pdmc_covariance_at(covariance, hypot(x[0] - y[0], x[1] - y[1]));
            correlation[i * count + j] = correlation[j * count + i] = (1.0 - lowered_for_each_tip * count) * kernel;
        }
    }
}

pdmc_status pdmc_toughness_factor(const pdmc_problem *problem, const double value[], double factor[])
{
    pdmc_status status = PDMC_OK;
    const int count = problem->energy.tip_count;
    pdmc_crack *cracks = NULL;
    double *correlation = NULL;
    PDMC_NEW(cracks, problem->crack_count);
    PDMC_NEW(correlation, count * count);
    pdmc_problem_place_cracks(problem, value, cracks);
    correlate_tips(problem, cracks, correlation);
    PDMC_TRY(pdmc_copula_factor(count, correlation, factor));
done:
    pdmc_free(cracks);
    pdmc_free(correlation);
    return status;
}
