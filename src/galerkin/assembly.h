// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "galerkin/pair.h"
#include "galerkin/pattern.h"

/// All that adding up pairs of elements needs, made once for a space, a kernel and a rule.
typedef struct {
    const pdmc_space *space;
    int threads;
    pdmc_neighbours neighbours;
    pdmc_pair_rule rule;
    pdmc_element *elements;  // all of them
    pdmc_pair_block *blocks; // of the pairs of one block of elements
} pdmc_assembly;

/// @param[in]  space, kernel  must outlive the assembly
/// @param[out] assembly       free with pdmc_assembly_clear(); zero on failure
/// @return PDMC_OK, PDMC_ERR_ARG, or PDMC_ERR_NOMEM
PDMC_NODISCARD pdmc_status pdmc_assembly_create(const pdmc_space *space, const pdmc_scalar_kernel *kernel,
                                                const pdmc_form_rule *rule, int threads, pdmc_assembly *assembly);
void pdmc_assembly_clear(pdmc_assembly *assembly);

/// What pairs add up to; the parts that are not NULL are added to.
typedef struct {
    pdmc_form *form; // of the pattern of the assembly's neighbours
    double *force;   // [free_count]
    double *energy;
} pdmc_assembled;

/// Adds up all pairs: of linear bonds where `law` is NULL, else of the bonds between the values u.
/// @param[in]  u  [count], or NULL without a law
void pdmc_assembly_add(const pdmc_assembly *assembly, const pdmc_bond_law *law, const double u[],
                       const pdmc_assembled *sum);
