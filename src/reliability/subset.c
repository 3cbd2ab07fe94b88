// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "reliability/average.h"
#include "reliability/normals.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

enum { MOST_LEVELS = 64 };                  // so many places a run has in the random numbers
static const double best_acceptance = 0.44; // of the chains' moves (Papaioannou et al. 2015, section 3.4)
static const double first_spread = 0.6;     // sqrt(1 - rho^2) of a move, before anything is known (ibid.)
static const double stagnant = 0.5;         // share of a level from which on it is no progress: g is flat there

/// Runs side by side, each with the samples of its present level. The chains' first samples stand first; sample i of
/// what follows is one move from sample i - chains.
typedef struct {
    int count;
    uint64_t first; // the number of the first run; the others follow
    double *z, *g;  // [count, samples, dimension], [count, samples]; g is infinite where it is NaN
    int *filled;    // [count] samples that there are; 0 where none of the last level were in this one
    double *share;  // [count] P(level): the product of the levels' shares
} population;

typedef struct {
    const pdmc_limit_state *limit;
    const pdmc_subset_options *options;
    population pilot, runs;
    int chains;                    // of a level
    int *inside;                   // [samples] which of a run's are in the next level
    double *z, *g;                 // [runs samples, dimension], [runs samples] candidates
    int levels;                    // found by the pilot
    double level[MOST_LEVELS];     // b_j
    double spread[MOST_LEVELS];    // of the moves within that level
    bool reached;                  // the event has a level's share of the last level, or more
    pdmc_average events, possible; // of the runs
    long evaluations, failed;
} simulation;

pdmc_subset_options pdmc_subset_options_default(void)
{
    return (pdmc_subset_options){.seed = 1,
                                 .confidence = 0.95,
                                 .variation = 0.1,
                                 .most_evaluations = 500000,
                                 .samples = 1000,
                                 .level_probability = 0.1,
                                 .most_levels = 12,
                                 .runs = 20};
}

/// The unsolved may be in the event, and so they are in every level.
static pdmc_status evaluate(simulation *s, int count, const double z[], double g[])
{
    const pdmc_status status = s->limit->evaluate(s->limit->context, count, z, g);
    if (status != PDMC_OK) return status;
    s->evaluations += count;
    for (int k = 0; k < count; k++) {
        s->failed += isnan(g[k]);
        if (isnan(g[k])) g[k] = INFINITY;
    }
    return PDMC_OK;
}

static size_t place(const simulation *s, int r, int i)
{
    return (size_t)r * (size_t)s->options->samples + (size_t)i;
}

static double *point(const simulation *s, const population *p, int r, int i)
{
    return &p->z[place(s, r, i) * (size_t)s->limit->dimension];
}

/// Where the numbers of a run, level and place are, which no other has.
static uint64_t number(const simulation *s, const population *p, int r, int level, int i)
{
    const uint64_t sample = (p->first + (uint64_t)r) * MOST_LEVELS + (uint64_t)level;
    return sample * (uint64_t)s->options->samples + (uint64_t)i;
}

static void draw(const simulation *s, const population *p, int r, int level, int i, double z[])
{
    pdmc_random_normal(s->options->seed, PDMC_STREAM_SUBSET, number(s, p, r, level, i), 0, s->limit->dimension, z);
}

static pdmc_status start(simulation *s, population *p)
{
    const int n = s->options->samples;
    for (int r = 0; r < p->count; r++) {
        for (int i = 0; i < n; i++) draw(s, p, r, 0, i, point(s, p, r, i));
        p->share[r] = 1.0;
        p->filled[r] = n;
    }
    return evaluate(s, p->count * n, p->z, p->g);
}

static int find_inside(simulation *s, const population *p, int r, double level)
{
    int count = 0;
    for (int i = 0; i < s->options->samples; i++)
        if (p->g[place(s, r, i)] >= level) s->inside[count++] = i;
    return count;
}

/// Systematic resampling: as many chains, of the same length, whatever the number of samples inside the level, each
/// from any of these with the same probability. (A chain from every sample would be the shorter the more there are; a
/// run with many of them would forget them the less, and the product of the shares would be too large on average.) The
/// uniform number is that of a chain's first place, which draws no move.
static void begin_chains(simulation *s, population *p, int r, int j)
{
    const size_t d = (size_t)s->limit->dimension, chains = (size_t)s->chains;
    const size_t inside = (size_t)find_inside(s, p, r, s->level[j]);
    double u;
    p->share[r] *= (double)inside / s->options->samples;
    p->filled[r] = inside > 0 ? s->chains : 0;
    if (inside == 0) return;
    pdmc_random_uniform(s->options->seed, PDMC_STREAM_SUBSET, number(s, p, r, j + 1, 0), 0, 1, &u);
    const size_t shift = (size_t)(u * (double)(chains * inside));
    for (size_t k = 0; k < chains; k++) {
        const int from = s->inside[(k * inside + shift) / chains % inside];
        memcpy(&s->z[k * d], point(s, p, r, from), d * sizeof *s->z);
        s->g[k] = p->g[place(s, r, from)];
    }
    memcpy(point(s, p, r, 0), s->z, chains * d * sizeof *s->z);
    memcpy(&p->g[place(s, r, 0)], s->g, chains * sizeof *s->g);
}

/// Of every chain one, until the level is full; none of a run that has nothing in it.
static int next_moves(const simulation *s, const population *p, int r)
{
    const int left = s->options->samples - p->filled[r];
    if (p->filled[r] == 0) return 0;
    return left < s->chains ? left : s->chains;
}

/// Conditional sampling: rho z + sqrt(1 - rho^2) xi leaves the standard normal distribution as it is, for any rho.
static int propose(simulation *s, const population *p, int level, double spread)
{
    const int d = s->limit->dimension;
    const double rho = sqrt(1.0 - spread * spread);
    int count = 0;
    for (int r = 0; r < p->count; r++) {
        for (int k = 0; k < next_moves(s, p, r); k++, count++) {
            const int i = p->filled[r] + k;
            const double *from = point(s, p, r, i - s->chains);
            double *to = &s->z[(size_t)count * (size_t)d];
            draw(s, p, r, level, i, to);
            for (int j = 0; j < d; j++) to[j] = rho * from[j] + spread * to[j];
        }
    }
    return count;
}

/// A candidate outside the level is refused, and the chain stays where it is. Returns how many were taken.
static int accept(simulation *s, population *p, double bound)
{
    const size_t bytes = (size_t)s->limit->dimension * sizeof *p->z;
    int candidate = 0, taken = 0;
    for (int r = 0; r < p->count; r++) {
        const int moves = next_moves(s, p, r);
        for (int k = 0; k < moves; k++, candidate++) {
            const int i = p->filled[r] + k, from = i - s->chains;
            const bool inside = s->g[candidate] >= bound;
            const double *to = inside ? &s->z[(size_t)candidate * (size_t)s->limit->dimension] : point(s, p, r, from);
            memcpy(point(s, p, r, i), to, bytes);
            p->g[place(s, r, i)] = inside ? s->g[candidate] : p->g[place(s, r, from)];
            taken += inside;
        }
        p->filled[r] += moves;
    }
    return taken;
}

/// Fills level j, whose chains have begun. The spread is adapted where the caller wants to know it.
static pdmc_status fill(simulation *s, population *p, int j, bool adapt)
{
    for (int step = 1;; step++) {
        const int moves = propose(s, p, j + 1, s->spread[j]);
        if (moves == 0) return PDMC_OK;
        const pdmc_status status = evaluate(s, moves, s->z, s->g);
        if (status != PDMC_OK) return status;
        const double acceptance = (double)accept(s, p, s->level[j]) / moves;
        if (adapt) s->spread[j] = fmin(1.0, s->spread[j] * exp((acceptance - best_acceptance) / sqrt(step)));
    }
}

static int count_above_zero(const simulation *s, const population *p, int r, bool unsolved_too)
{
    int count = 0;
    for (int i = 0; i < s->options->samples; i++) {
        const double g = p->g[place(s, r, i)];
        count += g > 0.0 && (unsolved_too || isfinite(g));
    }
    return count;
}

/// Finds the levels, and the spread of the moves in each.
static pdmc_status explore(simulation *s)
{
    const int n = s->options->samples, wanted = s->chains;
    population *p = &s->pilot;
    pdmc_status status = start(s, p);
    while (status == PDMC_OK) {
        s->reached = count_above_zero(s, p, 0, true) >= wanted;
        if (s->reached || s->levels == s->options->most_levels) break;
        const int j = s->levels;
        gsl_sort_largest(s->g, (size_t)wanted, p->g, 1, (size_t)n);
        s->level[j] = s->g[wanted - 1];
        if (find_inside(s, p, 0, s->level[j]) > stagnant * n) break;
        begin_chains(s, p, 0, j);
        s->spread[j] = j > 0 ? s->spread[j - 1] : first_spread;
        s->levels++;
        status = fill(s, p, j, true);
    }
    return status;
}

/// A batch of runs through the pilot's levels.
static pdmc_status take_runs(simulation *s)
{
    const double n = s->options->samples;
    population *p = &s->runs;
    pdmc_status status = start(s, p);
    for (int j = 0; j < s->levels && status == PDMC_OK; j++) {
        for (int r = 0; r < p->count; r++) begin_chains(s, p, r, j);
        status = fill(s, p, j, false);
    }
    for (int r = 0; r < p->count && status == PDMC_OK; r++) {
        const bool alive = p->share[r] > 0.0;
        const double possible = s->reached ? count_above_zero(s, p, r, true) : n;
        pdmc_average_add(&s->events, alive ? p->share[r] * count_above_zero(s, p, r, false) / n : 0.0);
        pdmc_average_add(&s->possible, alive ? p->share[r] * possible / n : 0.0);
    }
    p->first += (uint64_t)p->count;
    return status;
}

static pdmc_status take_enough_runs(simulation *s)
{
    long before;
    do {
        before = s->evaluations;
        const pdmc_status status = take_runs(s);
        if (status != PDMC_OK) return status;
    } while (s->reached && !(pdmc_average_variation(&s->events) <= s->options->variation) &&
             2 * s->evaluations - before <= s->options->most_evaluations);
    return PDMC_OK;
}

static void report(const simulation *s, pdmc_reliability *result)
{
    *result = (pdmc_reliability){
        .evaluations = s->evaluations, .failed = s->failed, .levels = s->levels, .reached = s->reached};
    pdmc_average_report(&s->events, &s->possible, s->options->confidence, result);
    if (!s->reached) result->probability.lower = 0.0;
    result->index = pdmc_reliability_index(result->probability);
    result->converged = s->reached && result->variation <= s->options->variation;
}

static pdmc_status check(const pdmc_limit_state *limit, const pdmc_subset_options *o)
{
    PDMC_REQUIRE(limit->dimension >= 1, "dimension = %d is not positive", limit->dimension);
    PDMC_REQUIRE(o->confidence > 0.0 && o->confidence < 1.0, "confidence = %g not in (0, 1)", o->confidence);
    PDMC_REQUIRE(o->variation > 0.0, "coefficient of variation = %g is not positive", o->variation);
    PDMC_REQUIRE(o->samples >= 10, "%d samples a level are less than 10", o->samples);
    PDMC_REQUIRE(o->runs >= 3, "%d runs are less than 3", o->runs);
    PDMC_REQUIRE(o->level_probability > 0.0 && o->level_probability < stagnant, "level probability = %g not in (0, %g)",
                 o->level_probability, stagnant);
    PDMC_REQUIRE(o->most_levels >= 0 && o->most_levels < MOST_LEVELS, "%d levels not in [0, %d)", o->most_levels,
                 MOST_LEVELS);
    return PDMC_OK;
}

static pdmc_status population_make(const simulation *s, int count, uint64_t first, population *p)
{
    pdmc_status status = PDMC_OK;
    *p = (population){.count = count, .first = first};
    PDMC_NEW(p->z, place(s, count, 0) * (size_t)s->limit->dimension);
    PDMC_NEW(p->g, place(s, count, 0));
    PDMC_NEW(p->filled, count);
    PDMC_NEW(p->share, count);

done:
    return status;
}

static void population_clear(population *p)
{
    pdmc_free(p->z);
    pdmc_free(p->g);
    pdmc_free(p->filled);
    pdmc_free(p->share);
}

pdmc_status pdmc_subset_simulation(const pdmc_limit_state *limit, const pdmc_subset_options *options,
                                   pdmc_reliability *result)
{
    pdmc_status status = check(limit, options);
    if (status != PDMC_OK) return status;
    simulation s = {.limit = limit, .options = options};
    s.chains = (int)ceil(options->level_probability * options->samples);
    PDMC_NEW(s.inside, options->samples);
    PDMC_NEW(s.z, place(&s, options->runs, 0) * (size_t)limit->dimension);
    PDMC_NEW(s.g, place(&s, options->runs, 0));
    PDMC_TRY(population_make(&s, 1, 0, &s.pilot));
    PDMC_TRY(population_make(&s, options->runs, 1, &s.runs));
    PDMC_TRY(explore(&s));
    PDMC_TRY(take_enough_runs(&s));
    report(&s, result);

done:
    population_clear(&s.runs);
    population_clear(&s.pilot);
    pdmc_free(s.g);
    pdmc_free(s.z);
    pdmc_free(s.inside);
    return status;
}
