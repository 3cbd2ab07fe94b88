// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits.h"

#include "particles/particles_impl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { REPEATS = 10 };

double bench_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void bench_give_up(const char *why)
{
    fprintf(stderr, "explicit: %s\n", why);
    exit(EXIT_FAILURE);
}

double bench_triad(int threads)
{
    enum { SIZE = 8000000 }; // 192 MB
    double *a = malloc(3 * sizeof(double) * SIZE), *b = a + SIZE, *c = b + SIZE, best = INFINITY;
    if (!a) bench_give_up("out of memory");
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        const double start = bench_seconds();
#pragma omp parallel for num_threads(threads) schedule(static)
        for (int i = 0; i < SIZE; i++) {
            if (repeat == 0) b[i] = c[i] = 1.0;
            a[i] = b[i] + 0.5 * c[i];
        }
        if (repeat > 0) best = fmin(best, bench_seconds() - start);
    }
    if (!(a[SIZE / 2] == 1.5)) bench_give_up("the triad is wrong");
    free(a);
    return 3.0 * sizeof(double) * SIZE / best;
}

/// The study without what it has beside its bonds.
static pdmc_particles *make_bare(const pdmc_explicit *study, int threads)
{
    pdmc_particles *particles;
    pdmc_explicit bare = *study;
    bare.materials = malloc((size_t)study->material_count * sizeof *bare.materials);
    if (!bare.materials) bench_give_up("out of memory");
    memcpy(bare.materials, study->materials, (size_t)study->material_count * sizeof *bare.materials);
    for (int m = 0; m < study->material_count; m++) {
        bare.materials[m].has_critical_stretch = bare.materials[m].has_fracture_energy = false;
        bare.materials[m].strengthening = 0.0;
    }
    bare.sphere_count = bare.condition_count = 0;
    bare.contact_distance = 0.0;
    if (pdmc_explicit_particles(&bare, threads, &particles) != PDMC_OK) bench_give_up(pdmc_last_error());
    free(bare.materials);
    return particles;
}

double bench_bare_kernel(const pdmc_explicit *study, int threads)
{
    pdmc_particles *particles = make_bare(study, threads);
    double best = INFINITY;
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        const double start = bench_seconds();
        for (int k = 0; k < REPEATS; k++) pdmc_particles_find_forces_in(particles, study->precision, particles->force);
        best = fmin(best, (bench_seconds() - start) / REPEATS);
    }
    const double rate = (double)pdmc_particles_bonds(particles) / best;
    pdmc_particles_destroy(particles);
    return rate;
}

double bench_bytes_of_step(const pdmc_explicit *study, const pdmc_particles *particles)
{
    const bool is_single = study->precision == PDMC_PRECISION_SINGLE;
    const double number = is_single ? sizeof(float) : sizeof(double), vector = 3.0 * sizeof(double);
    const double moving = 3.0 * vector + (is_single ? vector + 3.0 * number : 0.0); // v, x twice; first places, u
    const double forces = 3.0 * number + 2.0 * number + vector;                     // x or u, s_0 twice, f
    const double accelerating = 3.0 * vector, spheres = study->sphere_count * vector;
    return (double)pdmc_particles_bond_bytes(particles) +
           pdmc_particles_count(particles) * (moving + forces + accelerating + spheres);
}
