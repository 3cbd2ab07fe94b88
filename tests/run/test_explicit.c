// SPDX-License-Identifier: GPL-3.0-or-later

/// Explicit studies: what is recorded, against motion in closed form; symmetry; and what an early stop keeps.

#include "run/studies.h"

#include "pdmc/results.h"
#include "run/tips.h"

#define GRID "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; };\n"
#define GLASS "materials = ( { density = 2.0; youngs_modulus = 3.0; critical_stretch = 0.02; } );\n"

static void read_explicit(const char *settings, pdmc_study *study)
{
    char text[4096];
    snprintf(text, sizeof text, "kind = \"explicit\";\n%s\n", settings);
    CHECK_OK(read_text(text, study));
}

static void run_explicit(const char *settings, const pdmc_run_options *options, pdmc_results *results)
{
    pdmc_study study;
    read_explicit(settings, &study);
    CHECK_OK(pdmc_run(&study, options, results));
    pdmc_study_clear(&study);
}

// A plate with a crack in its middle whose upper and lower strips are torn apart, then held.
static const char torn[] = GRID GLASS
    "bodies = ( { from = [-20, -20]; to = [20, 20]; } );\n"
    "cracks = ( { name = \"c\"; from = [-5, 0]; to = [5, 0]; } );\n"
    "conditions = ( { from = [-20, 17]; to = [20, 20]; y = 0.01; times = [20, 20]; factors = [1, 0]; },\n"
    "               { from = [-20, -20]; to = [20, -17]; y = -0.01; times = [20, 20]; factors = [1, 0]; } );\n"
    "time = { duration = 60; }; record = { interval = 2; snapshots = 4; speed_window = 8; };";

// Free flight: 6 x 4 nodes of mass 2 * 1 * 1 * 0.25; a sphere far away that keeps its velocity.
static void a_free_body_flies_on(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r;
    run_explicit(GRID GLASS "bodies = ( { name = \"b\"; from = [0, 0]; to = [6, 4]; velocity = [0.0, -0.5]; } );\n"
                            "spheres = ( { radius = 1; centre = [0, 100]; velocity = [2, 0]; stiffness = 1; } );\n"
                            "time = { duration = 8; step = 0.3; }; record = { interval = 0.6; snapshots = 2; };",
                 &options, &r);
    const pdmc_explicit_record *p = &r.particles;
    assert_int_equal(r.status, PDMC_RUN_COMPLETE);
    assert_int_equal(p->node_count, 24);
    CHECK_NEAR(p->steps, 27.0, 0.0);       // 26.7
    assert_int_equal(p->record_count, 15); // the start, every second step, and the last one
    assert_int_equal(p->snapshot_count, 2);
    CHECK_NEAR(p->time[14], 27 * 0.3, 1e-14);
    CHECK_NEAR(p->snapshot_time[0], 7 * 0.6, 1e-14);
    CHECK_NEAR(p->snapshot_time[1], 27 * 0.3, 1e-14);
    CHECK_NEAR(p->first, 0.5 * 12.0 * 0.25, 1e-14);
    for (int i = 0; i < p->record_count; i++) { // rounding of positions makes forces of 1e-15
        CHECK_NEAR(p->kinetic[i], 1.5, 1e-13);
        CHECK_NEAR(p->elastic[i] + p->fracture[i] + p->contact[i] + p->work[i], 0.0, 1e-13);
        CHECK_NEAR(p->momentum[3 * i], 0.0, 1e-13);
        CHECK_NEAR(p->momentum[3 * i + 1], -6.0, 1e-13);
        CHECK_NEAR(p->sphere_centre[3 * i], 2.0 * p->time[i], 1e-13);
        CHECK_NEAR(p->sphere_velocity[3 * i], 2.0, 0.0);
        CHECK_NEAR(p->broken[i], 0.0, 0.0);
    }
    for (int i = 0; i < p->node_count; i++) {
        CHECK_NEAR(p->displacement[3 * (24 + i) + 1], -0.5 * 27 * 0.3, 1e-12);
        CHECK_NEAR(p->damage[i], 0.0, 0.0);
        assert_int_equal(p->node_body[i], 0);
    }
    assert_string_equal(p->bodies[0].name, "b");
    assert_true(isinf(p->spheres[0].mass));
    pdmc_results_clear(&r);
}

// A plate that is torn, once as a box and once by a file of its nodes: the same records, and nodes in the order of the file.
static void nodes_of_a_file_are_those_of_a_grid(void **state)
{
    (void)state;
#define BESIDE                                                                                                         \
    "cracks = ( { from = [2.8, 0.0]; to = [3.2, 4.0]; } );\n"                                                          \
    "conditions = ( { prescribed = \"force\"; from = [0, 0]; to = [3, 9]; x = -0.01; },\n"                             \
    "               { prescribed = \"force\"; from = [9, 0]; to = [12, 9]; x = 0.01; } );\n"                           \
    "time = { duration = 18; step = 0.3; }; record = { interval = 3; snapshots = 2; };"
    const pdmc_run_options options = {.threads = 2};
    pdmc_results box, file;
    FILE *nodes = fopen("nodes.txt", "w");
    assert_non_null(nodes);
    for (int k = 0; k < 108; k++) fprintf(nodes, "%g %g 0.25\n", 0.5 + k / 9, 0.5 + k % 9);
    assert_int_equal(fclose(nodes), 0);
    run_explicit(GRID GLASS "bodies = ( { from = [0, 0]; to = [12, 9]; } );\n" BESIDE, &options, &box);
    run_explicit(GRID GLASS "bodies = ( { shape = \"nodes\"; file = \"nodes.txt\"; } );\n" BESIDE, &options, &file);
    const pdmc_explicit_record *a = &box.particles, *b = &file.particles;
    assert_int_equal(b->node_count, a->node_count);
    CHECK_NEAR(b->bonds, a->bonds, 0.0);
    assert_true(a->broken[a->record_count - 1] > a->broken[0] + 100.0);
    for (int i = 0; i < a->record_count; i++) {
        CHECK_NEAR(b->broken[i], a->broken[i], 0.0);
        CHECK_NEAR(b->kinetic[i], a->kinetic[i], 1e-12 * a->kinetic[a->record_count - 1]);
        CHECK_NEAR(b->elastic[i], a->elastic[i], 1e-12 * a->elastic[a->record_count - 1]);
        CHECK_NEAR(b->work[i], a->work[i], 1e-12 * a->work[a->record_count - 1]);
    }
    for (int k = 0; k < 108; k++) { // along y first in the file
        const int other = k % 9 * 12 + k / 9;
        CHECK_NEAR(b->node_position[3 * k], a->node_position[3 * other], 0.0);
        CHECK_NEAR(b->node_position[3 * k + 1], a->node_position[3 * other + 1], 0.0);
        CHECK_NEAR(b->damage[108 + k], a->damage[108 + other], 0.0);
        CHECK_NEAR(b->displacement[3 * (108 + k)], a->displacement[3 * (108 + other)], 1e-12);
    }
    pdmc_results_clear(&box);
    pdmc_results_clear(&file);
}

// Nodes of mass 0.5: 16 of them right of a crack, 8 left of it, and a body of one node that flies away.
static void pieces_are_recorded(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r;
    run_explicit(GRID GLASS "bodies = ( { from = [0, 0]; to = [6, 4]; velocity = [0.0, 1.0]; },\n"
                            "           { from = [9, 0]; to = [10, 1]; velocity = [0.5, 0.0]; } );\n"
                            "cracks = ( { from = [2, -1]; to = [2, 5]; } );\n"
                            "time = { duration = 4; }; record = { interval = 1; snapshots = 2; };",
                 &options, &r);
    const pdmc_explicit_record *p = &r.particles;
    for (int i = 0; i < p->record_count; i++) {
        CHECK_NEAR(p->fragments[i], 2.0, 0.0);
        CHECK_NEAR(p->loose_nodes[i], 1.0, 0.0);
        CHECK_NEAR(p->largest_fragment[i], 8.0, 0.0);
    }
    const double end = p->time[p->record_count - 1];
    assert_int_equal(p->fragment_count, 3);
    assert_int_equal(p->fragment_list[1].nodes, 8);
    CHECK_NEAR(p->fragment_list[0].centre[0], 4.0, 1e-12);
    CHECK_NEAR(p->fragment_list[1].centre[1], 2.0 + end, 1e-12);
    CHECK_NEAR(p->fragment_list[2].centre[0], 9.5 + 0.5 * end, 1e-12);
    CHECK_NEAR(p->fragment_list[2].velocity[0], 0.5, 1e-12);
    for (int s = 0; s < 2; s++) { // the first row: 2 nodes on the left, 4 on the right, the single one
        static const int row[] = {1, 1, 0, 0, 0, 0, 2};
        assert_memory_equal(&p->fragment[s * p->node_count], row, sizeof row);
    }
    pdmc_results_clear(&r);
}

// The plate is its own mirror image, so both tips grow alike; and what goes in is accounted for.
static void both_tips_of_a_crack_grow_alike(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r;
    run_explicit(torn, &options, &r);
    const pdmc_explicit_record *p = &r.particles;
    const int last = p->record_count - 1;
    assert_int_equal(p->tip_count, 2);
    assert_string_equal(p->tips[0].name, "c.from");
    CHECK_NEAR(p->tips[0].direction[0], -1.0, 0.0);
    for (int i = 0; i <= last; i++) {
        CHECK_NEAR(p->tip_advance[2 * i], p->tip_advance[2 * i + 1], 0.0);
        CHECK_NEAR(p->tip_speed[2 * i], p->tip_speed[2 * i + 1], 0.0);
        if (i > 0) assert_true(p->tip_advance[2 * i] >= p->tip_advance[2 * i - 2]);
        CHECK_NEAR(p->momentum[3 * i], 0.0, 1e-10);
        CHECK_NEAR(p->momentum[3 * i + 1], 0.0, 1e-10);
    }
    assert_true(p->tip_advance[2 * last] >= 3.0);
    assert_true(p->fracture[last] > 0.0 && p->work[last] > 0.0);
    pdmc_results_clear(&r);
}

// In single precision the same bonds break and the tips go as far; what that makes of the forces is recorded.
static void single_precision_is_like_double(void **state)
{
    (void)state;
    pdmc_study study;
    pdmc_results exact, rounded;
    run_explicit(torn, &(pdmc_run_options){.threads = 1}, &exact);
    read_explicit(torn, &study);
    study.motion.precision = PDMC_PRECISION_SINGLE;
    CHECK_OK(pdmc_run(&study, &(pdmc_run_options){.threads = 1}, &rounded));
    const pdmc_explicit_record *a = &exact.particles, *b = &rounded.particles;
    const int last = a->record_count - 1;
    assert_int_equal(a->compared_count, 0);
    assert_int_equal(b->compared_count, b->record_count);
    for (int i = 0; i <= last; i++) assert_true(b->force_error[i] < 1e-4 && (i == 0 || b->force_error[i] > 1e-8));
    CHECK_NEAR(b->broken[last], a->broken[last], 2.0);
    CHECK_NEAR(b->tip_advance[2 * last], a->tip_advance[2 * last], 1.0);
    CHECK_NEAR(b->fracture[last], a->fracture[last], 1e-3 * a->fracture[last]);
    CHECK_NEAR(b->elastic[last], a->elastic[last], 1e-3 * a->elastic[last]);
    assert_true(b->elastic[last] != a->elastic[last]);
    pdmc_study_clear(&study);
    pdmc_results_clear(&exact);
    pdmc_results_clear(&rounded);
}

static void check_same(const pdmc_explicit_record *a, const pdmc_explicit_record *b, int records, int snapshots)
{
    const size_t n = (size_t)records * sizeof(double), s = (size_t)(snapshots * a->node_count) * sizeof(double);
    assert_int_equal(a->node_count, b->node_count);
    assert_same("time", a->time, b->time, n);
    assert_same("kinetic", a->kinetic, b->kinetic, n);
    assert_same("elastic", a->elastic, b->elastic, n);
    assert_same("work", a->work, b->work, n);
    assert_same("fracture", a->fracture, b->fracture, n);
    assert_same("broken", a->broken, b->broken, n);
    assert_same("momentum", a->momentum, b->momentum, 3 * n);
    assert_same("tip_advance", a->tip_advance, b->tip_advance, 2 * n);
    assert_same("displacement", a->displacement, b->displacement, 3 * s);
    assert_same("velocity", a->velocity, b->velocity, 3 * s);
    assert_same("damage", a->damage, b->damage, s);
    assert_same("fragments", a->fragments, b->fragments, n);
    assert_same("largest_fragment", a->largest_fragment, b->largest_fragment, n);
    assert_same("fragment", a->fragment, b->fragment, (size_t)(snapshots * a->node_count) * sizeof(int));
}

static void results_do_not_depend_on_threads(void **state)
{
    (void)state;
    pdmc_results one, more;
    run_explicit(torn, &(pdmc_run_options){.threads = 1}, &one);
    for (int threads = 2; threads <= 3; threads++) {
        run_explicit(torn, &(pdmc_run_options){.threads = threads}, &more);
        assert_int_equal(more.particles.record_count, one.particles.record_count);
        check_same(&one.particles, &more.particles, one.particles.record_count, one.particles.snapshot_count);
        pdmc_results_clear(&more);
    }
    pdmc_results_clear(&one);
}

static bool stop_at(void *context, int done, int total)
{
    assert_true(done <= total);
    return done < *(const int *)context;
}

static void a_stopped_run_is_a_prefix(void **state)
{
    (void)state;
    int limit = 25;
    pdmc_results full, stopped;
    run_explicit(torn, &(pdmc_run_options){.threads = 1}, &full);
    run_explicit(torn, &(pdmc_run_options){.threads = 2, .progress = stop_at, .context = &limit}, &stopped);
    const pdmc_explicit_record *p = &stopped.particles;
    const int last = p->record_count - 1;
    assert_int_equal(stopped.status, PDMC_RUN_INTERRUPTED);
    assert_in_range((int)p->steps, limit, limit + 8);
    assert_true(last < full.particles.record_count - 1);
    check_same(&full.particles, p, last, 0); // the last record is of where it stopped
    CHECK_NEAR(p->snapshot_time[p->snapshot_count - 1], p->time[last], 0.0);
    CHECK_OK(pdmc_results_write(&stopped, "stopped.h5", true)); // arrays longer than the counts
    pdmc_results_clear(&stopped);
    CHECK_OK(pdmc_results_read("stopped.h5", &stopped));
    check_same(&full.particles, &stopped.particles, last, 0);
    limit = 0;
    pdmc_study study;
    read_explicit(torn, &study);
    const pdmc_run_options none = {.threads = 1, .progress = stop_at, .context = &limit};
    pdmc_results_clear(&stopped);
    CHECK_STATUS(pdmc_run(&study, &none, &stopped), PDMC_ERR_INTERRUPTED);
    pdmc_study_clear(&study);
    pdmc_results_clear(&full);
}

// A node of this speed leaves its family in one step.
static void a_step_that_cannot_be_taken_keeps_what_was(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 2};
    pdmc_results r;
    run_explicit(GRID GLASS
                 "bodies = ( { from = [0, 0]; to = [6, 4]; } );\n"
                 "conditions = ( { from = [0, 0]; to = [6, 1]; y = 1e9; times = [2, 3]; factors = [0, 1]; } );\n"
                 "time = { duration = 8; step = 0.3; }; record = { interval = 0.6; snapshots = 2; };",
                 &options, &r);
    const pdmc_explicit_record *p = &r.particles;
    assert_int_equal(r.status, PDMC_RUN_NOT_FINITE);
    assert_non_null(strstr(p->stop, "step"));
    assert_true(p->record_count > 3 && p->time[p->record_count - 1] < 3.0);
    assert_int_equal(p->snapshot_count, 1);
    for (int i = 0; i < 3 * p->node_count; i++) assert_true(isfinite(p->displacement[i]) && isfinite(p->velocity[i]));
    CHECK_OK(pdmc_results_write(&r, "lost.h5", true));
    pdmc_results_clear(&r);
    CHECK_OK(pdmc_results_read("lost.h5", &r));
    assert_int_equal(r.status, PDMC_RUN_NOT_FINITE);
    assert_non_null(strstr(r.particles.stop, "step"));
    pdmc_results_clear(&r);
}

static void what_the_engine_refuses_is_a_bad_study(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    static const char *const settings[] = {
        GRID GLASS "bodies = ( { from = [0.6, 0.6]; to = [0.7, 0.7]; } ); time = { duration = 1; };", // no node
        GRID GLASS "bodies = ( { from = [0, 0]; to = [9, 9]; } ); time = { duration = 9; };\n"
                   "no_fail = ( { from = [10, 0]; to = [12, 9]; } );", // nor here
    };
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        pdmc_study study;
        pdmc_results r;
        read_explicit(settings[i], &study);
        CHECK_STATUS(pdmc_run(&study, &options, &r), PDMC_ERR_CONFIG);
        pdmc_study_clear(&study);
    }
}

// In a zone without failure nothing breaks that was not cut, and energies of linear stretch are those of full stretch to a
// few strains, and not the same.
static void bonds_are_those_of_the_study(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    static const char zone[] = "no_fail = ( { from = [-20, -20]; to = [20, 20]; } );\n";
    static const char linear[] = "grid = { dimension = 2; spacing = 1.0; offset = [0.5, 0.5]; thickness = 0.25; "
                                 "stretch = \"linear\"; };\n";
    pdmc_results torn_apart, spared, straight;
    char text[2048];
    run_explicit(torn, &options, &torn_apart);
    snprintf(text, sizeof text, "%s%s", zone, torn);
    run_explicit(text, &options, &spared);
    snprintf(text, sizeof text, "%s%s%s", linear, zone, &torn[sizeof GRID - 1]);
    run_explicit(text, &options, &straight);
    const pdmc_explicit_record *p = &torn_apart.particles, *q = &spared.particles, *l = &straight.particles;
    const int last = p->record_count - 1;
    assert_true(p->broken[last] > p->broken[0] && q->broken[0] == p->broken[0]);
    assert_true(q->broken[last] == q->broken[0] && l->broken[last] == q->broken[0]);
    CHECK_NEAR(q->fracture[last], 0.0, 0.0);
    assert_true(l->elastic[last] != q->elastic[last]);
    CHECK_NEAR(l->elastic[last], q->elastic[last], 0.1 * q->elastic[last]);
    pdmc_results_clear(&torn_apart);
    pdmc_results_clear(&spared);
    pdmc_results_clear(&straight);
}

// Moduli of one material: E = 3 k (1 - 2 nu), with nu = 1/3, 1/4, 1/4.
static void moduli_say_the_same(void **state)
{
    (void)state;
    const struct {
        int dimension;
        pdmc_assumption assumption;
        double bulk_over_youngs;
    } cases[] = {{2, PDMC_PLANE_STRESS, 1.0}, {2, PDMC_PLANE_STRAIN, 2.0 / 3.0}, {3, PDMC_PLANE_STRESS, 2.0 / 3.0}};
    for (size_t i = 0; i < 3; i++) {
        const pdmc_explicit p = {
            .dimension = cases[i].dimension, .assumption = cases[i].assumption, .horizon = 1.5, .thickness = 0.2};
        pdmc_explicit_material m = {.density = 2.0, .has_youngs_modulus = true, .youngs_modulus = 6.0};
        const pdmc_brittle_material by_youngs = pdmc_explicit_law(&p, &m);
        assert_true(isinf(by_youngs.critical_stretch));
        m = (pdmc_explicit_material){.density = 2.0,
                                     .has_bulk_modulus = true,
                                     .has_fracture_energy = true,
                                     .bulk_modulus = 6.0 * cases[i].bulk_over_youngs,
                                     .fracture_energy = 0.1};
        const pdmc_brittle_material by_bulk = pdmc_explicit_law(&p, &m);
        CHECK_NEAR(by_bulk.micromodulus, by_youngs.micromodulus, 1e-14 * by_youngs.micromodulus);
        CHECK_NEAR(by_bulk.critical_stretch,
                   pdmc_brittle_critical_stretch(p.dimension, 0.1, by_youngs.micromodulus, 1.5, 0.2), 1e-14);
    }
}

// The counts are of whole families: exact for nodes in the middles of cells and for the stable step of a body that has
// one, above the engine's for bonds.
static void counts_bound_those_of_the_engine(void **state)
{
    (void)state;
    static const char *const rules[] = {"whole", "partial", "tapered"};
    static const char *const glass[] = {
        GLASS, GLASS,
        "materials = ( { density = 2.0; youngs_modulus = 3.0; fibre = [1, 2, 0]; fibre_ratio = 9; } );\n"};
    for (size_t i = 0; i < 3; i++) {
        pdmc_study study;
        pdmc_particles *particles;
        char text[1024];
        snprintf(text, sizeof text,
                 "grid = { dimension = 3; spacing = 0.5; offset = [0.25, 0.25, 0.25]; volume = \"%s\"; };\n%s"
                 "bodies = ( { from = [0, 0, 0]; to = [6, 5, 4]; } ); time = { duration = 10; safety = 0.5; };",
                 rules[i], glass[i]);
        read_explicit(text, &study);
        CHECK_OK(pdmc_explicit_particles(&study.motion, 1, &particles));
        const pdmc_explicit_amounts amounts = pdmc_explicit_count(&study.motion);
        const double bonds = (double)pdmc_particles_bonds(particles);
        CHECK_NEAR(amounts.nodes, pdmc_particles_count(particles), 1e-9);
        CHECK_NEAR(amounts.steps, ceil(10.0 / pdmc_particles_step_size(particles)), 0.0);
        if (i == 0) CHECK_NEAR(amounts.bonds, 61.0 * 960.0, 1e-6); // 122 neighbours within 3 spacings
        assert_true(0.5 * amounts.bonds < bonds && bonds < amounts.bonds);
        pdmc_particles_destroy(particles);
        pdmc_study_clear(&study);
    }
}

// A bar that is held at one end and pulled at the other, 8 nodes of volume 0.25 by 0.02 each, comes to rest: the reaction is
// the force, and half of its work is elastic and the other half damped away, but for what small strains are of first order.
static void a_damped_bar_comes_to_rest(void **state)
{
    (void)state;
    const pdmc_run_options options = {.threads = 1};
    for (int relative = 0; relative < 2; relative++) {
        char text[1024];
        snprintf(text, sizeof text,
                 GRID GLASS
                 "bodies = ( { from = [0, 0]; to = [12, 4]; } ); damping = { %s; };\n"
                 "conditions = ( { name = \"wall\"; prescribed = \"displacement\"; from = [0, 0]; to = [2, 4];\n"
                 "                 x = 0; y = 0; },\n"
                 "               { name = \"hand\"; prescribed = \"force\"; from = [10, 0]; to = [12, 4];\n"
                 "                 x = 2e-5; } );\n"
                 "time = { duration = 1000; }; record = { interval = 100; snapshots = 1; };",
                 relative ? "relative = 6.0" : "absolute = 0.12");
        pdmc_results r;
        run_explicit(text, &options, &r);
        const pdmc_explicit_record *p = &r.particles;
        const int last = p->record_count - 1;
        const double *force = &p->condition_force[6 * last], *displacement = &p->condition_displacement[6 * last];
        assert_string_equal(p->conditions[1].name, "hand");
        CHECK_NEAR(force[3], 8 * 0.25 * 2e-5, 1e-18);
        CHECK_NEAR(force[0], -force[3], 1e-6 * force[3]);
        CHECK_NEAR(displacement[0], 0.0, 1e-15);
        CHECK_NEAR(p->work[last], force[3] * displacement[3], 0.01 * p->work[last]);
        CHECK_NEAR(p->elastic[last], 0.5 * p->work[last], 0.01 * p->work[last]);
        CHECK_NEAR(p->dissipated[last], 0.5 * p->work[last], 0.01 * p->work[last]);
        pdmc_results_clear(&r);
    }
}

static void fronts_are_of_nodes_near_the_crack(void **state)
{
    (void)state;
    const pdmc_explicit study = {.horizon = 1.0, .tip_damage = 0.3};
    const pdmc_followed_tip tip = {.position = {3.0, 4.0}, .direction = {0.6, 0.8}};
    // 1.5 and 0.75 beyond the tip; 2 beyond, but 2.1 beside the line; 1.75 beyond, but hardly damaged; 2.6 beyond, a gap off
    const double x[] = {3.9, 5.2, 0, 3.45, 4.6, 9.9, 4.2 + 1.68, 5.6 - 1.26, 0, 4.05, 5.4, 0, 4.56, 6.08, 0};
    double damage[] = {0.31, 0.9, 1.0, 0.3, 0.8};
    CHECK_NEAR(pdmc_tip_front(&study, &tip, 5, x, damage), 1.5, 1e-14);
    damage[3] = 0.31;
    CHECK_NEAR(pdmc_tip_front(&study, &tip, 5, x, damage), 2.6, 1e-14);
    damage[1] = 0.0; // then the rest is more than a horizon away
    assert_true(isinf(pdmc_tip_front(&study, &tip, 5, x, damage)));
}

// Of a straight line the slope, everywhere; of a kink half of it, where the window is half on each side.
static void speeds_are_central_differences(void **state)
{
    (void)state;
    enum { N = 9 };
    double time[N], advance[2 * N], speed[2 * N];
    pdmc_explicit_record r = {.record_count = N,
                              .tip_count = 2,
                              .time = time,
                              .tip_advance = advance,
                              .tip_speed = speed,
                              .speed_window = 1.0};
    for (int i = 0; i < N; i++) {
        time[i] = 0.5 * i;
        advance[2 * i] = 3.0 * time[i];
        advance[2 * i + 1] = fmax(0.0, 4.0 * (time[i] - 2.0));
    }
    pdmc_tip_speeds(&r);
    for (int i = 0; i < N; i++) {
        CHECK_NEAR(speed[2 * i], 3.0, 1e-14);
        CHECK_NEAR(speed[2 * i + 1], i < 4 ? 0.0 : i == 4 ? 2.0 : 4.0, 1e-14);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_body_flies_on),
        cmocka_unit_test(nodes_of_a_file_are_those_of_a_grid),
        cmocka_unit_test(pieces_are_recorded),
        cmocka_unit_test(both_tips_of_a_crack_grow_alike),
        cmocka_unit_test(single_precision_is_like_double),
        cmocka_unit_test(results_do_not_depend_on_threads),
        cmocka_unit_test(a_stopped_run_is_a_prefix),
        cmocka_unit_test(a_step_that_cannot_be_taken_keeps_what_was),
        cmocka_unit_test(what_the_engine_refuses_is_a_bad_study),
        cmocka_unit_test(bonds_are_those_of_the_study),
        cmocka_unit_test(moduli_say_the_same),
        cmocka_unit_test(counts_bound_those_of_the_engine),
        cmocka_unit_test(a_damped_bar_comes_to_rest),
        cmocka_unit_test(fronts_are_of_nodes_near_the_crack),
        cmocka_unit_test(speeds_are_central_differences),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
