// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/forces.h"

#include "particles/bodies.h"
#include "particles/lattice.h"
#include "particles/scattered.h"

/// How the bonds differ, and whether their nodes are scattered round the points of a grid and have different volumes.
typedef struct {
    double strengthening;
    bool linear, factors, strengths, scattered, fibres;
} variant;

/// Nodes with arrays of their own, moved at random, some of their bonds stretched beyond what they bear.
typedef struct {
    variant kind;
    specimen s;
    pdmc_node *scattered; // NULL: on the grid
    pdmc_nodes nodes;
    pdmc_bond_law law;
    pdmc_forces forces;
    double *position[PDMC_AXES], *velocity[PDMC_AXES], *force[PDMC_AXES], *strength, *next_strength, *stiffness,
        *fracture, *elastic, *contact;
    double strengths[PDMC_STRENGTH_CLASSES];
    uint8_t *bonds; // as they were
} setting;

static double *zeros(size_t count)
{
    double *p = pdmc_calloc(count, sizeof *p);
    assert_non_null(p);
    return p;
}

static void make_strengths(setting *t)
{
    for (int k = 0; k < PDMC_STRENGTH_CLASSES; k++) t->strengths[k] = 0.5 + (k + 0.5) / PDMC_STRENGTH_CLASSES;
    t->forces.key = (pdmc_hash_key){123456789u, 987654321u};
    t->law.strengths = t->strengths;
}

static void set_up(setting *t, variant kind, double amplitude)
{
    unsigned seed = 7;
    *t = (setting){.kind = kind};
    make_box(&t->s, 3, (int[]){11, 9, 6});
    t->s.options.volume_rule = PDMC_VOLUME_TAPERED;
    t->s.options.contact_distance = 0.85;
    if (kind.scattered) {
        t->scattered = scatter_box(&t->s, (int[]){11, 9, 6}, 0.2, &seed);
        CHECK_OK(pdmc_scattered_create(&t->s.options, &t->nodes));
    } else CHECK_OK(pdmc_lattice_create(&t->s.options, &t->nodes));
    const size_t cells = t->nodes.cells + PDMC_LANES, blocks = (size_t)t->nodes.block_count;
    t->law = (pdmc_bond_law){.micromodulus = 2.0, .critical_stretch = 0.05, .strengthening = kind.strengthening};
    if (kind.fibres) t->law.fibre_excess = 2.5, t->law.fibre[0] = 0.6, t->law.fibre[2] = 0.8;
    t->forces = (pdmc_forces){.nodes = &t->nodes,
                              .laws = &t->law,
                              .repulsion = 3.0,
                              .step = 0.1,
                              .linear = kind.linear,
                              .by_node = kind.factors};
    for (int a = 0; a < PDMC_AXES; a++) {
        t->forces.position[a] = t->position[a] = zeros(cells);
        t->forces.velocity[a] = t->velocity[a] = zeros(cells);
        t->forces.force[a] = t->force[a] = zeros(cells);
        memcpy(t->position[a], t->nodes.reference[a], cells * sizeof(double));
        for (int k = 0; k < t->nodes.node_count; k++) t->position[a][t->nodes.cell[k]] += amplitude * scatter(&seed);
        for (int k = 0; k < t->nodes.node_count; k++) t->velocity[a][t->nodes.cell[k]] = scatter(&seed);
    }
    t->forces.strength = t->strength = zeros(cells);
    t->forces.next_strength = t->next_strength = zeros(cells);
    t->stiffness = zeros(cells);
    const bool by_node = kind.strengthening > 0.0 || kind.factors;
    for (size_t c = 0; c < cells; c++) {
        t->strength[c] = 0.05 + (by_node ? 0.02 * scatter(&seed) : 0.0);
        t->stiffness[c] = kind.factors ? 1.0 + 0.5 * scatter(&seed) : 1.0;
    }
    if (kind.factors) t->forces.stiffness = t->stiffness;
    if (kind.factors) t->forces.first_strength = t->strength;
    if (kind.strengths) make_strengths(t);
    t->forces.fracture = t->fracture = zeros(blocks);
    t->forces.elastic = t->elastic = zeros(blocks);
    t->forces.contact = t->contact = zeros(blocks);
    t->bonds = malloc(t->nodes.bond_bytes);
    memcpy(t->bonds, t->nodes.bonds, t->nodes.bond_bytes);
}

static void tear_down(setting *t)
{
    for (int a = 0; a < PDMC_AXES; a++) {
        pdmc_free(t->position[a]);
        pdmc_free(t->velocity[a]);
        pdmc_free(t->force[a]);
    }
    pdmc_free(t->strength);
    pdmc_free(t->next_strength);
    pdmc_free(t->stiffness);
    pdmc_free(t->fracture);
    pdmc_free(t->elastic);
    pdmc_free(t->contact);
    free(t->bonds);
    free(t->scattered);
    pdmc_nodes_clear(&t->nodes);
}

/// What a node should have: its bonds one after the other, as the equations are written.
typedef struct {
    double force[PDMC_AXES], least_stretch, fracture, elastic, contact;
    int whole, touching;
} expected;

static double weight_of(double length)
{
    return fmin(1.0, 0.5 + 3.0 - length);
}

/// c of a bond over that of the law (eq. 10 of the paper), without the factors of nodes.
static double directed(const setting *t, const double along[], double length)
{
    double beta = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) beta += t->law.fibre[a] * along[a] / length;
    return beta * beta * (1.0 + t->law.fibre_excess) + (1.0 - beta * beta);
}

/// s_0 of a bond.
static double bears(const setting *t, size_t i, size_t j)
{
    const double s_0 = fmin(t->strength[i], t->strength[j]);
    if (!t->kind.strengths) return s_0;
    return s_0 * t->strengths[pdmc_hash((uint32_t)(i < j ? i : j), (uint32_t)(i < j ? j : i), &t->forces.key)];
}

static expected node_by_definition(const setting *t, size_t i)
{
    const pdmc_nodes *g = &t->nodes;
    expected e = {.least_stretch = INFINITY};
    for (int k = 0; k < g->node_count; k++) {
        const size_t j = g->cell[k];
        double apart[PDMC_AXES], along[PDMC_AXES], square = 0.0, first = 0.0, slope = 0.0;
        for (int a = 0; a < PDMC_AXES; a++) {
            const double xi = g->reference[a][j] - g->reference[a][i];
            apart[a] = t->position[a][j] - t->position[a][i];
            square += apart[a] * apart[a];
            first += xi * xi;
            slope += (apart[a] - xi) * xi;
            along[a] = xi;
        }
        const double length = sqrt(first), distance = sqrt(square);
        if (i == j || length > 3.0) continue;
        const double s = t->kind.linear ? slope / first : (distance - length) / length,
                     depth = fmin(0.9 * length, 0.85) - distance;
        const double c = t->law.micromodulus * directed(t, along, length) * 0.5 * (t->stiffness[i] + t->stiffness[j]) *
                         weight_of(length) * g->volume[j];
        const double energy = 0.25 * c * s * s * length * g->volume[i];
        double growth = 0.0;
        for (int a = 0; a < PDMC_AXES; a++) {
            const double towards = t->kind.linear ? along[a] / length : apart[a] / distance;
            growth += t->forces.step * (t->velocity[a][j] - t->velocity[a][i]) * towards / length;
            e.force[a] += c * s * towards;
        }
        e.least_stretch = fmin(e.least_stretch, s);
        if (s > bears(t, i, j)) e.fracture += energy + 0.25 * c * s * growth * length * g->volume[i];
        else e.whole++;
        e.elastic += energy;
        const double push = depth > 0.0 ? t->forces.repulsion * g->volume[j] * depth : 0.0;
        if (depth > 0.0) e.contact += 0.25 * push * depth * g->volume[i], e.touching++;
        for (int a = 0; a < PDMC_AXES; a++) e.force[a] -= push * apart[a] / distance;
    }
    return e;
}

static int touching_pairs, broken_bonds;

static void check_block(const setting *t, int b, double rounding)
{
    const pdmc_block *block = &t->nodes.blocks[b];
    int whole[PDMC_LANES];
    double fracture = 0.0;
    pdmc_nodes_whole(&t->nodes, block, whole);
    for (int k = 0; k < PDMC_LANES; k++) {
        if (!(block->nodes >> k & 1)) continue;
        const size_t c = block->cell + (size_t)k;
        const expected e = node_by_definition(t, c);
        for (int a = 0; a < PDMC_AXES; a++) CHECK_NEAR(t->force[a][c], e.force[a], rounding);
        assert_int_equal(whole[k], e.whole);
        fracture += e.fracture;
        touching_pairs += e.touching;
        broken_bonds += t->nodes.family[c] - e.whole;
        if (t->law.strengthening > 0.0)
            CHECK_NEAR(t->next_strength[c],
                       (t->kind.factors ? t->strength[c] : 0.05) - t->law.strengthening * e.least_stretch, rounding);
    }
    CHECK_NEAR(t->fracture[b], fracture, rounding);
}

static void check_kernel(pdmc_forces_kernel *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    kernel(&t.forces, 0, t.nodes.block_count);
    touching_pairs = broken_bonds = 0;
    // About 100 bonds of 0.2 to 1 a node, each to a few roundings of 1e-16 and its stretch to one of 1e-16 of 1 / |xi|.
    for (int b = 0; b < t.nodes.block_count; b++) check_block(&t, b, 1e-13);
    assert_true(touching_pairs > 20 && broken_bonds > 1000); // or nothing would be tested
    tear_down(&t);
}

static void check_energies(pdmc_forces_kernel *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    t.forces.energies = true;
    kernel(&t.forces, 0, t.nodes.block_count);
    for (int b = 0; b < t.nodes.block_count; b++) {
        double elastic = 0.0, contact = 0.0;
        for (unsigned left = t.nodes.blocks[b].nodes; left; left &= left - 1) {
            const expected e = node_by_definition(&t, t.nodes.blocks[b].cell + (size_t)__builtin_ctz(left));
            elastic += e.elastic, contact += e.contact;
        }
        CHECK_NEAR(t.elastic[b], elastic, 1e-13);
        CHECK_NEAR(t.contact[b], contact, 1e-13);
    }
    assert_memory_equal(t.bonds, t.nodes.bonds, t.nodes.bond_bytes);
    tear_down(&t);
}

/// The sum of all forces, and of their moments, to rounding: both directions of a bond agree. Linear forces act along the
/// bonds as they were.
static void check_balance(pdmc_forces_kernel *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    double sum[PDMC_AXES] = {0}, moment[PDMC_AXES] = {0}, *const *place = kind.linear ? t.nodes.reference : t.position;
    if (kind.linear) t.forces.repulsion = 0.0;
    kernel(&t.forces, 0, t.nodes.block_count);
    for (int k = 0; k < t.nodes.node_count; k++) {
        const size_t c = t.nodes.cell[k];
        for (int a = 0; a < PDMC_AXES; a++) {
            const int b = (a + 1) % 3, d = (a + 2) % 3;
            const double volume = t.nodes.volume[c];
            sum[a] += volume * t.force[a][c];
            moment[a] += volume * (place[b][c] * t.force[d][c] - place[d][c] * t.force[b][c]);
        }
    }
    for (int a = 0; a < PDMC_AXES; a++) {
        CHECK_NEAR(sum[a], 0.0, 1e-12);    // 600 nodes, forces up to 5
        CHECK_NEAR(moment[a], 0.0, 1e-11); // lever arms up to 11
    }
    tear_down(&t);
}

static void check(pdmc_forces_kernel *kernel)
{
    static const variant kinds[] = {
        {0},
        {.strengthening = 0.25},
        {.strengthening = 0.25, .factors = true, .strengths = true},
        {.strengths = true},
        {.factors = true},
        {.linear = true},
        {.linear = true, .strengthening = 0.25, .factors = true, .strengths = true},
        {.fibres = true},
        {.linear = true, .factors = true, .fibres = true},
        {.scattered = true},
        {.scattered = true, .strengthening = 0.25, .fibres = true},
        {.scattered = true, .strengthening = 0.25, .factors = true, .strengths = true},
        {.scattered = true, .linear = true, .strengthening = 0.25, .factors = true, .strengths = true},
    };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        check_kernel(kernel, kinds[k]);
        check_energies(kernel, kinds[k]);
        check_balance(kernel, kinds[k]);
    }
}

static void portable(void **state)
{
    (void)state;
    check(pdmc_forces_portable);
}

static void avx2(void **state)
{
    (void)state;
#ifdef PDMC_HAVE_X86
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        check(pdmc_forces_avx2);
        return;
    }
#endif
    skip();
}

static void avx512(void **state)
{
    (void)state;
#ifdef PDMC_HAVE_X86
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
        check(pdmc_forces_avx512);
        return;
    }
#endif
    skip();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(portable), cmocka_unit_test(avx2), cmocka_unit_test(avx512)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
