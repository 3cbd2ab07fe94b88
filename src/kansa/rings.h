// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "discretisation/response.h"
#include "kansa/kansa_impl.h"

/// The rings' operators on y = R x: M_q = Q^T A_q R^-1, A_q the ring's rows and its share of the tractions.
typedef struct {
    const pdmc_kansa *kansa;
    double *rows; // [capacity, rows]
    int capacity; // vectors at a time
} pdmc_ring_operator;

PDMC_NODISCARD pdmc_status pdmc_ring_operator_create(const pdmc_kansa *kansa, pdmc_ring_operator *rings);
void pdmc_ring_operator_clear(pdmc_ring_operator *rings);

/// As pdmc_response_operator wants it; the context is a pdmc_ring_operator.
pdmc_status pdmc_ring_operator_apply(void *context, int q, int count, const double v[], double out[]);

/// R^-T A_q^T times the mean residual of load l: the direction in which the least-squares solution of a sample leaves
/// the limit of its Neumann expansion.
/// @param[out] out  [unknowns]
void pdmc_ring_operator_residual(pdmc_ring_operator *rings, int q, int l, double out[]);
