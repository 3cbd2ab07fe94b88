// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A block of samples of a model, drawn and ready to be solved.

#include "check.h"
#include "stochastic/block.h"

typedef struct {
    pdmc_variables variables;
    pdmc_block *block;
} drawn_block;

static inline pdmc_block *drawn_block_begin(drawn_block *drawn, const pdmc_problem *problem, const pdmc_affine *model,
                                            int count)
{
    *drawn = (drawn_block){0};
    CHECK_OK(pdmc_variables_create(problem, model, &drawn->variables));
    CHECK_OK(pdmc_block_create(&drawn->variables, model, &drawn->block));
    CHECK_OK(pdmc_block_draw(drawn->block, 0, count));
    return drawn->block;
}

static inline void drawn_block_end(drawn_block *drawn)
{
    pdmc_block_destroy(&drawn->block);
    pdmc_variables_clear(&drawn->variables);
}
