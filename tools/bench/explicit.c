// SPDX-License-Identifier: GPL-3.0-or-later

/// explicit THREADS STEPS STUDY [DUMP]: the speed of whole steps of an explicit study, all of them and the best hundred; beside the
/// kernel of forces alone, the bandwidth of a triad, and one thread, a hundred steps of each in turn; its mean damage, and how far damage of 0.3 has come along x. With the damage that LAMMPS wrote for the last step, of the same nodes
/// in the same order, the mean and the number of broken bonds of both.

#include "limits.h"
#include "pdmc/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *room(size_t count, size_t size)
{
    void *pointer = calloc(count, size);
    if (!pointer) bench_give_up("out of memory");
    return pointer;
}

/// Bonds of a node at the start, from the nodes' places alone: each is the only one in its cell of a grid.
enum { WIDE = 160, HIGH = 16, REACH = 4 };
typedef int cells[WIDE][HIGH][WIDE]; // 1 + the node; 0: none

static int count_family(const pdmc_explicit *study, cells node_at, const double x[], const int cell[3], int k)
{
    int family = 0;
    for (int i = -REACH; i <= REACH; i++)
        for (int j = -REACH; j <= REACH; j++)
            for (int l = -REACH; l <= REACH; l++) {
                const int other = node_at[cell[0] + i][cell[1] + j][cell[2] + l] - 1;
                double square = 0.0;
                if (other < 0 || other == k) continue;
                for (int a = 0; a < 3; a++) square += pow(x[3 * k + a] - x[3 * other + a], 2);
                family += sqrt(square) <= study->horizon;
            }
    return family;
}

static void count_families(const pdmc_explicit *study, const pdmc_particles *particles, int family[])
{
    static cells node_at;
    const int count = pdmc_particles_count(particles);
    double *x = room(3 * (size_t)count, sizeof *x);
    int(*cell)[3] = room((size_t)count, sizeof *cell);
    pdmc_particles_reference(particles, x, NULL);
    for (int k = 0; k < count; k++) {
        for (int a = 0; a < 3; a++)
            cell[k][a] = (int)lround(x[3 * k + a] / study->spacing) + (a == 1 ? HIGH / 2 + 2 : WIDE / 2);
        node_at[cell[k][0]][cell[k][1]][cell[k][2]] = 1 + k;
    }
    for (int k = 0; k < count; k++) family[k] = count_family(study, node_at, x, cell[k], k);
    free(cell);
    free(x);
}

static void compare_with(const char *dump, const pdmc_explicit *study, const pdmc_particles *particles)
{
    const int count = pdmc_particles_count(particles);
    int *family = room((size_t)count, sizeof *family), atoms = 0;
    char line[256];
    FILE *file = fopen(dump, "r");
    if (!file) bench_give_up(dump);
    count_families(study, particles, family);
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
    if (atoms != count) bench_give_up("LAMMPS has other nodes");
    const pdmc_particles_sums sums = pdmc_particles_sum(particles);
    printf("  after step %d: mean damage %.6g, LAMMPS %.6g (%+.1e); broken bonds %llu, LAMMPS %.0f (%+.1e)\n",
           pdmc_particles_steps(particles), sums.mean_damage, mean, sums.mean_damage / mean - 1.0,
           (unsigned long long)sums.broken, broken, (double)sums.broken / broken - 1.0);
}

/// The largest |x| of nodes with that damage.
static double find_front(const pdmc_particles *particles, double least)
{
    const int count = pdmc_particles_count(particles);
    double *x = room(3 * (size_t)count, sizeof *x), *damage = room((size_t)count, sizeof *damage), front = 0.0;
    pdmc_particles_reference(particles, x, NULL);
    pdmc_particles_state(particles, NULL, NULL, damage);
    for (int k = 0; k < count; k++)
        if (damage[k] > least) front = fmax(front, fabs(x[3 * k]));
    free(damage);
    free(x);
    return front;
}

typedef struct {
    pdmc_particles *particles;
    double all, best; // seconds of all steps, and of one of the best hundred
} timed;

static timed begin(const pdmc_explicit *study, int threads)
{
    timed t = {.best = INFINITY};
    if (pdmc_explicit_particles(study, threads, &t.particles) != PDMC_OK) bench_give_up(pdmc_last_error());
    return t;
}

static void advance(timed *t, int steps)
{
    const double start = bench_seconds();
    if (pdmc_particles_advance(t->particles, steps) != PDMC_OK) bench_give_up(pdmc_last_error());
    const double spent = bench_seconds() - start;
    t->best = fmin(t->best, spent / steps);
    t->all += spent;
}

static void print_steps(const timed *t, int steps)
{
    const double bonds = (double)pdmc_particles_bonds(t->particles);
    printf("  whole steps: %.2f ms, %.3f Gbond/s; best hundred %.2f ms, %.3f Gbond/s\n", 1e3 * t->all / steps,
           bonds * steps / t->all / 1e9, 1e3 * t->best, bonds / t->best / 1e9);
}

static void print_limits(const pdmc_explicit *study, const timed *t, int threads)
{
    const double bare = bench_bare_kernel(study, threads), triad = bench_triad(threads);
    const double rate = (double)pdmc_particles_bonds(t->particles) / t->best;
    const double bytes = bench_bytes_of_step(study, t->particles);
    printf("  the best hundred: %.0f %% of the kernel alone, %.3f Gbond/s; %.0f %% of a triad's %.1f GB/s\n",
           100.0 * rate / bare, bare / 1e9, 100.0 * bytes / t->best / triad, triad / 1e9);
}

/// On some threads, and on one in turn with these.
static void run(const pdmc_explicit *study, int threads, int steps, const char *dump)
{
    enum { MANY = 100 };
    timed more = begin(study, threads), one = begin(study, 1);
    for (int done = 0; done < steps; done += MANY) {
        const int now = steps - done < MANY ? steps - done : MANY;
        advance(&more, now);
        if (threads > 1) advance(&one, now);
    }
    print_steps(&more, steps);
    if (threads > 1)
        printf("  %d threads are %.2f times one, in the best hundred %.2f times\n", threads, one.all / more.all,
               one.best / more.best);
    print_limits(study, &more, threads);
    printf("  mean damage %.8g; damage of 0.3 up to x = %.4g\n", pdmc_particles_sum(more.particles).mean_damage,
           find_front(more.particles, 0.3));
    if (dump) compare_with(dump, study, more.particles);
    pdmc_particles_destroy(one.particles);
    pdmc_particles_destroy(more.particles);
}

static void print_study(const pdmc_explicit *study, int threads)
{
    pdmc_particles *particles = begin(study, 1).particles;
    const double bonds = (double)pdmc_particles_bonds(particles);
    printf("pdmc, %s, %s, %d thread%s: %d nodes, %.0f bonds, %.2f bytes a bond beyond the nodes\n",
           pdmc_particles_kernel(particles), study->precision == PDMC_PRECISION_SINGLE ? "single" : "double", threads,
           threads == 1 ? "" : "s", pdmc_particles_count(particles), bonds,
           (double)pdmc_particles_bond_bytes(particles) / bonds);
    pdmc_particles_destroy(particles);
}

int main(int count, char *words[])
{
    pdmc_study study;
    if (count < 4) bench_give_up("usage: explicit THREADS STEPS STUDY [DUMP]");
    const int threads = atoi(words[1]), steps = atoi(words[2]);
    if (pdmc_study_read(words[3], &study) != PDMC_OK) bench_give_up(pdmc_last_error());
    print_study(&study.motion, threads);
    run(&study.motion, threads, steps, count > 4 ? words[4] : NULL);
    pdmc_study_clear(&study);
    return EXIT_SUCCESS;
}
