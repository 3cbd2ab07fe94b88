// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the tests add to cmocka: comparisons of reals with their reason, and the refusal of every allocation in turn.

#include "base/base_impl.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
// cmocka.h needs the four headers above
#include <cmocka.h>

/// Fails the test, naming the value, the expectation and the tolerance, unless |got - want| <= tolerance.
#define CHECK_NEAR(got, want, tolerance)                                                                               \
    do {                                                                                                               \
        const double g_ = (got), w_ = (want), t_ = (tolerance);                                                        \
        if (!(fabs(g_ - w_) <= t_)) fail_msg("%s = %.17g, want %.17g +- %.3g", #got, g_, w_, t_);                      \
    } while (0)

#define CHECK_OK(call)                                                                                                 \
    do {                                                                                                               \
        const pdmc_status s_ = (call);                                                                                 \
        if (s_ != PDMC_OK) fail_msg("%s: %s: %s", #call, pdmc_status_string(s_), pdmc_last_error());                   \
    } while (0)

#define CHECK_STATUS(call, want)                                                                                       \
    do {                                                                                                               \
        const pdmc_status s_ = (call);                                                                                 \
        if (s_ != (want)) fail_msg("%s: got \"%s\" (%s)", #call, pdmc_status_string(s_), pdmc_last_error());           \
    } while (0)

/// Refuses the 1st, 2nd, ... allocation of `call` in turn until none is refused. Each time the call must report
/// PDMC_ERR_NOMEM if and only if an allocation was refused; run with sanitizers, it must not leak. `cleanup` is run
/// after a call that succeeded.
#define CHECK_FAILS_CLEANLY(call, cleanup)                                                                             \
    do {                                                                                                               \
        for (long a_ = 0;; a_++) {                                                                                     \
            pdmc_alloc_countdown = a_;                                                                                 \
            pdmc_alloc_refused = 0;                                                                                    \
            const pdmc_status s_ = (call);                                                                             \
            pdmc_alloc_countdown = -1;                                                                                 \
            if (s_ != (pdmc_alloc_refused ? PDMC_ERR_NOMEM : PDMC_OK))                                                 \
                fail_msg("allocation %ld refused: got \"%s\"", a_, pdmc_status_string(s_));                            \
            if (!pdmc_alloc_refused) break;                                                                            \
        }                                                                                                              \
        cleanup;                                                                                                       \
    } while (0)

/// The sanitizers look at memory and not at figures, five times as slowly: the finest grids are the release build's alone.
#ifdef __SANITIZE_ADDRESS__
enum { FINEST_LEFT_OUT = 1 };
#else
enum { FINEST_LEFT_OUT = 0 };
#endif
