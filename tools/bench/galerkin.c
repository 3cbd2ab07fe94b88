// SPDX-License-Identifier: GPL-3.0-or-later

/// galerkin: how long the form of the scalar problem takes, from 2,000 to 110,000 triangles with a horizon of three rows of
/// cells: on one thread, a pair of an outer point and an element that its disc meets, beside the logarithms alone that its
/// closed forms need; and on two threads.

#include "pdmc/galerkin.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { OUTER_POINTS = 7, EDGES = 3 };

static void check(pdmc_status status)
{
    if (status == PDMC_OK) return;
    fprintf(stderr, "galerkin: %s\n", pdmc_last_error());
    exit(EXIT_FAILURE);
}

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// Elements that a disc meets, in the mean over its place: those whose sum with the disc it is in, by Steiner's formula.
static double elements_in_disc(double cell, double horizon)
{
    const double area = 0.5 * cell * cell, edges = (2.0 + sqrt(2.0)) * cell;
    return (M_PI * horizon * horizon + edges * horizon + area) / area;
}

static double logarithm_seconds(void)
{
    enum { COUNT = 4000000 };
    volatile double sum = 0.0;
    const double start = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    for (int i = 0; i < COUNT; i++) sum = sum + log1p(0.3 + 1e-9 * i);
    return (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start) / COUNT;
}

static void measure(int cells, double logarithm)
{
    const double cell = 1.0 / cells, horizon = 3.0 * cell, size[2] = {1.0, 1.0};
    const pdmc_form_rule rule = {PDMC_OUTER_GAUSS, PDMC_INNER_EXACT, 1};
    pdmc_mesh mesh;
    pdmc_space space;
    pdmc_scalar_kernel kernel;
    pdmc_form form[2];
    double wall[2], one = 0.0;
    check(pdmc_mesh_box(2, size, (int[2]){cells, cells}, horizon, &mesh));
    check(pdmc_space_create(&mesh, PDMC_SPACE_CONTINUOUS, &space));
    check(pdmc_scalar_kernel_create(2, horizon, 1.0, 1, NULL, &kernel));
    for (int threads = 1; threads <= 2; threads++) {
        const double user = seconds_of(CLOCK_PROCESS_CPUTIME_ID), start = seconds_of(CLOCK_MONOTONIC);
        check(pdmc_form_peridynamic(&space, &kernel, &rule, threads, &form[threads - 1]));
        wall[threads - 1] = seconds_of(CLOCK_MONOTONIC) - start;
        if (threads == 1) one = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - user;
    }
    const double body = 2.0 * cells * cells, pairs = OUTER_POINTS * body * elements_in_disc(cell, horizon);
    const size_t bytes = (size_t)form[0].start[form[0].free_count] * sizeof *form[0].value;
    printf("%9d %9.0f %11.1f %9.0f %15.2f %13.2f %6s\n", mesh.element_count, 1e3 * one, 1e6 * one / mesh.element_count,
           1e9 * one / pairs, EDGES * logarithm * pairs / one, wall[0] / wall[1],
           memcmp(form[0].value, form[1].value, bytes) == 0 ? "same" : "others");
    for (int i = 0; i < 2; i++) pdmc_form_clear(&form[i]);
    pdmc_space_clear(&space);
    pdmc_mesh_clear(&mesh);
}

int main(void)
{
    const double logarithm = logarithm_seconds();
    printf("a logarithm takes %.1f ns\n%9s %9s %11s %9s %15s %13s %6s\n", 1e9 * logarithm, "triangles", "ms",
           "us/triangle", "ns/pair", "logarithms' share", "two threads", "bits");
    for (int cells = 28; cells <= 250; cells *= 2) measure(cells, logarithm);
    return 0;
}
