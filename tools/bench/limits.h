// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What an explicit study could do at most on this machine, measured in the same run.

#include "pdmc/explicit.h"

/// Bytes a second of a[i] = b[i] + s c[i], counted once each, with arrays far larger than the caches.
double bench_triad(int threads);

/// Bonds a second of the kernel of forces alone: the study's bodies, whose bonds neither break nor grow stronger.
double bench_bare_kernel(const pdmc_explicit *study, int threads);

/// Bytes that a step has to move at least once: what is kept of bonds, and the nodes' numbers in each pass over them.
double bench_bytes_of_step(const pdmc_explicit *study, const pdmc_particles *particles);

double bench_seconds(void);
_Noreturn void bench_give_up(const char *why);
