// SPDX-License-Identifier: GPL-3.0-or-later

/// impact THREADS STEPS [DUMP]: the disc of lammps/in.impact by the rules of LAMMPS' peri/pmb: mean damage every 100 steps and the
/// speed of whole steps, best of the hundreds. With the damage that LAMMPS wrote for the last step, the mean and the number of
/// broken bonds of both.

#include "pdmc/particles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double spacing = 5e-4;

static void give_up(const char *why)
{
    fprintf(stderr, "impact: %s\n", why);
    exit(EXIT_FAILURE);
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static pdmc_particles *make_disc(int threads)
{
    const pdmc_body disc = {
        .name = "disc",
        .shape = {.kind = PDMC_SHAPE_CYLINDER, .from = {0, -0.0025, 0}, .to = {0, 0, 0}, .radius = 0.03705}};
    const pdmc_brittle_material glass = {
        .density = 2200, .micromodulus = 1.6863e22, .critical_stretch = 0.0005, .strengthening = 0.25};
    const pdmc_rigid_sphere sphere = {
        .radius = 0.005, .centre = {0, 0.0051, 0}, .velocity = {0, -100, 0}, .mass = INFINITY, .stiffness = 1e17};
    const pdmc_particles_options options = {.dimension = 3,
                                            .spacing = spacing,
                                            .horizon = 0.0015001,
                                            .volume_rule = PDMC_VOLUME_TAPERED,
                                            .contact_distance = 1.35,
                                            .contact_stiffness = 15,
                                            .material_count = 1,
                                            .materials = &glass,
                                            .body_count = 1,
                                            .bodies = &disc,
                                            .sphere_count = 1,
                                            .spheres = &sphere,
                                            .step = 1e-7,
                                            .threads = threads};
    pdmc_particles *particles;
    if (pdmc_particles_create(&options, &particles) != PDMC_OK) give_up(pdmc_last_error());
    return particles;
}

/// Bonds of every node at the start, from the nodes' places alone.
static void count_families(const pdmc_particles *particles, int family[])
{
    enum { WIDE = 160, HIGH = 16 };
    static int node_at[WIDE][HIGH][WIDE]; // 0: none
    const int count = pdmc_particles_count(particles);
    double *x = malloc(sizeof(double) * 3 * (size_t)count);
    if (!x) give_up("out of memory");
    pdmc_particles_reference(particles, x, NULL);
    int(*place)[3] = malloc(sizeof *place * (size_t)count);
    if (!place) give_up("out of memory");
    for (int k = 0; k < count; k++) {
        for (int a = 0; a < 3; a++) place[k][a] = (int)lround(x[3 * k + a] / spacing) + (a == 1 ? HIGH / 2 : WIDE / 2);
        node_at[place[k][0]][place[k][1]][place[k][2]] = 1;
    }
    for (int k = 0; k < count; k++) {
        family[k] = 0;
        for (int i = -3; i <= 3; i++)
            for (int j = -3; j <= 3; j++)
                for (int l = -3; l <= 3; l++)
                    if (i * i + j * j + l * l > 0 && i * i + j * j + l * l <= 9)
                        family[k] += node_at[place[k][0] + i][place[k][1] + j][place[k][2] + l];
    }
    free(place);
    free(x);
}

/// LAMMPS makes its atoms in the same order, x fastest.
static void compare_with(const char *dump, const pdmc_particles *particles)
{
    const int count = pdmc_particles_count(particles);
    int *family = malloc(sizeof(int) * (size_t)count), atoms = 0;
    char line[256];
    FILE *file = fopen(dump, "r");
    if (!file || !family) give_up(dump);
    count_families(particles, family);
    double mean = 0.0, broken = 0.0;
    while (fgets(line, sizeof line, file))
        if (strncmp(line, "ITEM: ATOMS", 11) == 0) break;
    for (; atoms < count && fgets(line, sizeof line, file); atoms++) {
        const double damage = strtod(line, NULL);
        mean += damage / count;
        broken += 0.5 * damage * family[atoms];
    }
    fclose(file);
    free(family);
    if (atoms != count) give_up("LAMMPS has other nodes");
    const pdmc_particles_sums sums = pdmc_particles_sum(particles);
    printf("after step %d: mean damage %.6g, LAMMPS %.6g (%+.1e); broken bonds %llu, LAMMPS %.0f (%+.1e)\n",
           pdmc_particles_steps(particles), sums.mean_damage, mean, sums.mean_damage / mean - 1.0,
           (unsigned long long)sums.broken, broken, (double)sums.broken / broken - 1.0);
}

int main(int count, char *words[])
{
    if (count < 3) give_up("usage: impact THREADS STEPS [DUMP]");
    const int threads = atoi(words[1]), steps = atoi(words[2]);
    pdmc_particles *particles = make_disc(threads);
    const double bonds = (double)pdmc_particles_bonds(particles);
    printf("pdmc, %s, %d thread%s: %d nodes, %.0f bonds, %.2f bytes a bond beyond the nodes\n",
           pdmc_particles_kernel(particles), threads, threads == 1 ? "" : "s", pdmc_particles_count(particles), bonds,
           (double)pdmc_particles_bond_bytes(particles) / bonds);
    double best = INFINITY, all = 0.0;
    for (int k = 0; k < steps; k += 100) {
        const double start = seconds();
        if (pdmc_particles_advance(particles, 100) != PDMC_OK) give_up(pdmc_last_error());
        const double spent = seconds() - start;
        best = fmin(best, spent);
        all += spent;
        printf("  step %4d: mean damage %.8g, %.2f ms a step\n", k + 100, pdmc_particles_sum(particles).mean_damage,
               10.0 * spent);
    }
    printf("  whole steps: %.2f ms, %.3f Gbond/s; best hundred %.3f Gbond/s\n", 1e3 * all / steps,
           bonds * steps / all / 1e9, bonds * 100 / best / 1e9);
    if (count > 3) compare_with(words[3], particles);
    pdmc_particles_destroy(particles);
    return EXIT_SUCCESS;
}
