// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/forces.h"

#include "particles/bodies.h"
#include "particles/lattice.h"
#include "particles/scattered.h"

/// How the bonds differ, and whether their nodes are scattered round the points of a grid and have different volumes.
typedef struct {
    double strengthening;
    bool linear, factors, strengths, scattered, fibres, joined;
} variant;

/// Of the first material: the whole, a part that has nothing of its own, and one behind an interface; and a part of a softer
/// material without fibres.
enum { WHOLE, ALIKE, OTHER, BEHIND, BODIES };
static const double softer = 0.5, interface_micromodulus = 3.0, interface_stretch = 0.03;

/// Nodes with arrays of their own, moved at random, some of their bonds stretched beyond what they bear.
typedef struct {
    variant kind;
    specimen s;
    pdmc_node *scattered; // NULL: on the grid
    pdmc_nodes nodes;
    pdmc_brittle_material materials[2];
    pdmc_body bodies[BODIES];
    pdmc_interface interface;
    pdmc_joints joints;
    pdmc_brittle_law law[2];
    pdmc_forces forces;
    double *position[PDMC_AXES], *velocity[PDMC_AXES], *force[PDMC_AXES], *strength, *next_strength, *stiffness,
        *relative, *fracture, *elastic, *contact;
    double strengths[PDMC_STRENGTH_CLASSES];
    pdmc_single single;
    uint8_t *bonds; // as they were
} setting;

/// A kernel and how far its numbers may be from those by definition: of forces, of sums of all forces and of their moments.
typedef struct {
    pdmc_forces_kernel *find;
    bool is_single;
    double rounding, balance, moment;
} subject;

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
    t->law[0].strengths = t->law[1].strengths = t->strengths;
}

static void make_laws(setting *t)
{
    t->law[0] = (pdmc_brittle_law){.micromodulus = 2.0, .critical_stretch = 0.05, .strengthening = t->kind.strengthening};
    t->law[1] = t->law[0];
    t->law[1].micromodulus *= softer;
    if (t->kind.fibres) t->law[0].fibre_excess = 2.5, t->law[0].fibre[0] = 0.6, t->law[0].fibre[2] = 0.8;
}

static void make_parts(setting *t)
{
    const pdmc_shape places[] = {[ALIKE] = {.kind = PDMC_SHAPE_BALL, .centre = {3, 2, 2}, .radius = 2.2},
                                 [OTHER] = {.from = {6.5, -9, -9}, .to = {20, 20, 20}},
                                 [BEHIND] = {.from = {-9, 5.5, -9}, .to = {9, 20, 20}}};
    if (!t->kind.joined) return;
    for (int b = 0; b < BODIES; b++) t->bodies[b] = t->s.body;
    for (int b = ALIKE; b < BODIES; b++)
        t->bodies[b] = (pdmc_body){.shape = places[b], .is_part = true, .host = WHOLE, .material = b == OTHER};
    t->interface = (pdmc_interface){.of_bodies = true,
                                    .first = BEHIND,
                                    .second = WHOLE,
                                    .micromodulus = interface_micromodulus,
                                    .critical_stretch = interface_stretch};
    t->materials[0] = t->materials[1] = t->s.material;
    t->s.options.materials = t->materials, t->s.options.material_count = 2;
    t->s.options.bodies = t->bodies, t->s.options.body_count = BODIES;
    t->s.options.interfaces = &t->interface, t->s.options.interface_count = 1;
    CHECK_OK(pdmc_joints_create(&t->s.options, t->law, &t->joints));
}

/// What kernels of single precision look at.
static void make_single(setting *t)
{
    CHECK_OK(pdmc_single_create(&t->nodes, t->forces.stiffness, &t->single));
    for (int b = 0; b < t->nodes.block_count; b++)
        pdmc_single_follow(&t->single, &t->nodes, &t->nodes.blocks[b], t->position);
    for (size_t c = 0; c < t->nodes.cells; c++) t->single.strength[c] = (float)t->strength[c];
    t->forces.single = &t->single;
}

static void set_up_box(setting *t, variant kind, const int size[], double amplitude)
{
    unsigned seed = 7;
    *t = (setting){.kind = kind};
    make_box(&t->s, 3, size);
    t->s.options.volume_rule = PDMC_VOLUME_TAPERED;
    t->s.options.contact_distance = 0.85;
    make_laws(t);
    if (kind.scattered) t->scattered = scatter_box(&t->s, size, 0.2, &seed);
    make_parts(t);
    if (kind.scattered) {
        CHECK_OK(pdmc_scattered_create(&t->s.options, &t->joints, &t->nodes));
    } else CHECK_OK(pdmc_lattice_create(&t->s.options, &t->joints, &t->nodes));
    const size_t cells = t->nodes.cells + PDMC_LANES, blocks = (size_t)t->nodes.block_count;
    t->forces = (pdmc_forces){.nodes = &t->nodes,
                              .laws = t->law,
                              .joints = &t->joints,
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
    t->relative = zeros(cells);
    const bool by_node = kind.strengthening > 0.0 || kind.factors;
    for (size_t c = 0; c < cells; c++) {
        t->strength[c] = 0.05 + (by_node ? 0.02 * scatter(&seed) : 0.0);
        t->stiffness[c] = kind.factors ? 1.0 + 0.5 * scatter(&seed) : 1.0;
        t->relative[c] = kind.factors ? 1.0 + 0.5 * scatter(&seed) : 1.0;
    }
    if (kind.factors) t->forces.stiffness = t->stiffness;
    if (kind.factors) t->forces.relative_strength = t->relative;
    if (kind.factors) t->forces.first_strength = t->strength;
    if (kind.strengths) make_strengths(t);
    t->forces.fracture = t->fracture = zeros(blocks);
    t->forces.elastic = t->elastic = zeros(blocks);
    t->forces.contact = t->contact = zeros(blocks);
    make_single(t);
    t->bonds = malloc(t->nodes.bond_bytes);
    memcpy(t->bonds, t->nodes.bonds, t->nodes.bond_bytes);
}

/// Rows of three blocks, of which the first two have the same neighbours.
static void set_up(setting *t, variant kind, double amplitude)
{
    set_up_box(t, kind, (int[]){19, 7, 4}, amplitude);
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
    pdmc_free(t->relative);
    pdmc_free(t->fracture);
    pdmc_free(t->elastic);
    pdmc_free(t->contact);
    pdmc_single_clear(&t->single);
    free(t->bonds);
    free(t->scattered);
    pdmc_nodes_clear(&t->nodes);
    pdmc_joints_clear(&t->joints);
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
static double directed(const pdmc_brittle_law *law, const double along[], double length)
{
    double beta = 0.0;
    for (int a = 0; a < PDMC_AXES; a++) beta += law->fibre[a] * along[a] / length;
    return beta * beta * (1.0 + law->fibre_excess) + (1.0 - beta * beta);
}

static bool have(int a, int b, int first, int second)
{
    return (a == first && b == second) || (a == second && b == first);
}

/// c of a bond without the factors of nodes. Of two halves of different materials in series it is 2 / (1 / c_1 + 1 / c_2).
static double stiff(const setting *t, size_t i, size_t j, const double along[], double length)
{
    const int a = t->nodes.body[i], b = t->nodes.body[j];
    const double c = t->law[0].micromodulus;
    if (!t->kind.joined) return c * directed(t->law, along, length);
    if (have(a, b, WHOLE, BEHIND)) return interface_micromodulus;
    if (a == OTHER && b == OTHER) return softer * c;
    if (a == OTHER || b == OTHER) return 2.0 / (1.0 / c + 1.0 / (softer * c));
    return c * directed(t->law, along, length);
}

/// s_0 of a bond.
static double bears(const setting *t, size_t i, size_t j)
{
    double s_0 = fmin(t->strength[i], t->strength[j]);
    if (t->kind.joined && have(t->nodes.body[i], t->nodes.body[j], WHOLE, BEHIND))
        s_0 = interface_stretch * fmin(t->relative[i], t->relative[j]);
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
        const double c = stiff(t, i, j, along, length) * 0.5 * (t->stiffness[i] + t->stiffness[j]) * weight_of(length) *
                         g->volume[j];
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
        if (t->law[0].strengthening > 0.0)
            CHECK_NEAR(t->next_strength[c],
                       (t->kind.factors ? t->strength[c] : 0.05) - t->law[0].strengthening * e.least_stretch, rounding);
    }
    CHECK_NEAR(t->fracture[b], fracture, rounding);
}

static void check_kernel(const subject *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    kernel->find(&t.forces, 0, t.nodes.block_count);
    for (size_t c = 0; kernel->is_single && c < t.nodes.cells; c++)
        t.next_strength[c] = (double)t.single.next_strength[c];
    touching_pairs = broken_bonds = 0;
    for (int b = 0; b < t.nodes.block_count; b++) check_block(&t, b, kernel->rounding);
    assert_true(touching_pairs > 20 && broken_bonds > 1000); // or nothing would be tested
    tear_down(&t);
}

static void check_energies(const subject *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    t.forces.energies = true;
    kernel->find(&t.forces, 0, t.nodes.block_count);
    for (int b = 0; b < t.nodes.block_count; b++) {
        double elastic = 0.0, contact = 0.0;
        for (unsigned left = t.nodes.blocks[b].nodes; left; left &= left - 1) {
            const expected e = node_by_definition(&t, t.nodes.blocks[b].cell + (size_t)__builtin_ctz(left));
            elastic += e.elastic, contact += e.contact;
        }
        CHECK_NEAR(t.elastic[b], elastic, kernel->rounding);
        CHECK_NEAR(t.contact[b], contact, kernel->rounding);
    }
    assert_memory_equal(t.bonds, t.nodes.bonds, t.nodes.bond_bytes);
    tear_down(&t);
}

/// The sum of all forces, and of their moments, to rounding: both directions of a bond agree. Linear forces act along the
/// bonds as they were.
static void check_balance(const subject *kernel, variant kind)
{
    setting t;
    set_up(&t, kind, 0.15);
    double sum[PDMC_AXES] = {0}, moment[PDMC_AXES] = {0}, *const *place = kind.linear ? t.nodes.reference : t.position;
    if (kind.linear) t.forces.repulsion = 0.0;
    kernel->find(&t.forces, 0, t.nodes.block_count);
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
        CHECK_NEAR(sum[a], 0.0, kernel->balance);
        CHECK_NEAR(moment[a], 0.0, kernel->moment);
    }
    tear_down(&t);
}

/// Two nodes alone, from close together to far apart: the force on one is that on the other to the bit.
static void check_pair(const subject *kernel, variant kind)
{
    unsigned seed = 3;
    setting t;
    set_up_box(&t, kind, (int[]){1, 2, 1}, 0.0);
    const size_t i = t.nodes.cell[0], j = t.nodes.cell[1];
    t.forces.unbreakable = true;
    for (int k = 0; k < 200; k++) {
        for (int a = 0; a < PDMC_AXES; a++) t.position[a][j] = t.nodes.reference[a][j] + 1.5 * scatter(&seed);
        for (int b = 0; b < t.nodes.block_count; b++)
            pdmc_single_follow(&t.single, &t.nodes, &t.nodes.blocks[b], t.position);
        kernel->find(&t.forces, 0, t.nodes.block_count);
        for (int a = 0; a < PDMC_AXES; a++) assert_true(t.force[a][i] == -t.force[a][j]);
        assert_true(t.force[1][i] != 0.0);
    }
    tear_down(&t);
}

/// Two nodes alone break their bond just beyond s_0, and not just before.
static void check_limit(const subject *kernel, variant kind)
{
    const double s_0 = 1e-3, around[] = {1.0 - 1e-4, 1.0 + 1e-4};
    for (int k = 0; k < 2; k++) {
        setting t;
        set_up_box(&t, kind, (int[]){1, 2, 1}, 0.0);
        const size_t i = t.nodes.cell[0], j = t.nodes.cell[1];
        t.law[0].critical_stretch = s_0;
        t.strength[i] = t.strength[j] = s_0;
        t.single.strength[i] = t.single.strength[j] = (float)s_0;
        t.position[1][j] = t.nodes.reference[1][j] + around[k] * s_0;
        for (int b = 0; b < t.nodes.block_count; b++)
            pdmc_single_follow(&t.single, &t.nodes, &t.nodes.blocks[b], t.position);
        kernel->find(&t.forces, 0, t.nodes.block_count);
        int whole[PDMC_LANES];
        for (int b = 0; b < t.nodes.block_count; b++) {
            pdmc_nodes_whole(&t.nodes, &t.nodes.blocks[b], whole);
            assert_int_equal(whole[0], k == 0);
        }
        tear_down(&t);
    }
}

static void check(const subject *kernel)
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
        {.joined = true},
        {.joined = true, .strengthening = 0.25, .factors = true, .strengths = true, .fibres = true},
        {.joined = true, .linear = true, .factors = true},
        {.joined = true, .scattered = true},
        {.joined = true, .scattered = true, .strengthening = 0.25, .factors = true, .strengths = true, .fibres = true},
    };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        check_kernel(kernel, kinds[k]);
        check_energies(kernel, kinds[k]);
        check_balance(kernel, kinds[k]);
    }
    check_pair(kernel, (variant){0});
    check_pair(kernel, (variant){.linear = true});
    check_limit(kernel, (variant){0});
    check_limit(kernel, (variant){.strengthening = 0.25});
    check_limit(kernel, (variant){.linear = true});
}

/// About 100 bonds of 0.2 to 1 a node, each to a few roundings of 1e-16 and its stretch to one of 1e-16 of 1 / |xi|; 500 nodes with
/// forces up to 5, and lever arms up to 19.
static void check_double(pdmc_forces_kernel *find)
{
    check(&(subject){find, false, 1e-13, 1e-12, 1e-11});
}

/// The same with roundings of 6e-8, which are more where the places of scattered nodes are rounded too.
static void check_single(pdmc_forces_kernel *find)
{
    check(&(subject){find, true, 2e-5, 1e-4, 1e-3});
}

static void portable(void **state)
{
    (void)state;
    check_double(pdmc_forces_portable);
    check_single(pdmc_forces_portable_single);
}

static void avx2(void **state)
{
    (void)state;
#ifdef PDMC_HAVE_X86
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        check_double(pdmc_forces_avx2);
        check_single(pdmc_forces_avx2_single);
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
        check_double(pdmc_forces_avx512);
        check_single(pdmc_forces_avx512_single);
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
