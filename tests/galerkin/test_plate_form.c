// SPDX-License-Identifier: GPL-3.0-or-later
#include "galerkin/cracked_plate.h"

#include "pdmc/geometry.h"

#include <gsl/gsl_math.h>
#include <string.h>

// A plate's form, and what a test does with it.
typedef struct {
    pdmc_mesh mesh;
    pdmc_space space;
    pdmc_plate_form form;
    double *u, *force; // [2 count]
} plate_form;

static void form_create(const pdmc_problem *problem, int parts, int planes, int threads, plate_form *f)
{
    *f = (plate_form){0};
    CHECK_OK(pdmc_plate_mesh(problem, &f->mesh));
    CHECK_OK(pdmc_space_create(&f->mesh, problem->solver.space, &f->space));
    CHECK_OK(pdmc_plate_form_create(problem, &f->space, parts, planes, threads, &f->form));
    f->u = pdmc_calloc(2 * (size_t)f->space.count, sizeof *f->u);
    f->force = pdmc_calloc(2 * (size_t)f->space.count, sizeof *f->force);
}

static void form_clear(plate_form *f)
{
    pdmc_free(f->u);
    pdmc_free(f->force);
    pdmc_plate_form_clear(&f->form);
    pdmc_space_clear(&f->space);
    pdmc_mesh_clear(&f->mesh);
}

typedef void motion(const double x[2], double middle, double u[2]);

// The displacement of every corner by its place and the height of its element's middle.
static void move(plate_form *f, motion *by)
{
    for (int e = 0; e < f->mesh.element_count; e++) {
        double middle = 0.0;
        for (int k = 3 * e; k < 3 * e + 3; k++) middle += f->mesh.x[2 * f->mesh.corner[k] + 1] / 3.0;
        for (int k = 3 * e; k < 3 * e + 3; k++)
            by(&f->mesh.x[2 * f->mesh.corner[k]], middle, &f->u[2 * f->space.value[k]]);
    }
    double weight[PDMC_PLATE_PLANES];
    for (int p = 0; p < f->form.planes; p++) weight[p] = 1.0;
    pdmc_plate_form_multiply(&f->form, weight, f->u, f->force);
}

static double energy(const plate_form *f)
{
    double sum = 0.0;
    for (int k = 0; k < 2 * f->space.count; k++) sum += f->u[k] * f->force[k];
    return sum;
}

static double largest(const plate_form *f)
{
    double most = 0.0;
    for (int k = 0; k < 2 * f->space.count; k++) most = fmax(most, fabs(f->force[k]));
    return most;
}

static void turned(const double x[2], double middle, double u[2])
{
    (void)middle;
    u[0] = 0.3 - 0.7 * x[1];
    u[1] = -0.2 + 0.7 * x[0];
}

static void stretched(const double x[2], double middle, double u[2])
{
    (void)middle;
    u[0] = x[0];
    u[1] = x[1];
}

static void strained(const double x[2], double middle, double u[2])
{
    (void)middle;
    u[0] = 0.3 * x[0] - 0.5 * x[1];
    u[1] = 0.8 * x[0] + 0.1 * x[1];
}

// Above the line of the crack one rigid motion, below it another one.
static void torn(const double x[2], double middle, double u[2])
{
    u[0] = middle > 0.0 ? 0.1 - 0.5 * x[1] : 0.0;
    u[1] = middle > 0.0 ? 1.0 + 0.5 * x[0] : 0.3;
}

static void lifted(const double x[2], double middle, double u[2])
{
    (void)x;
    u[0] = 0.0;
    u[1] = middle > 0.0 ? 1.0 : 0.0;
}

// No bond of a rigid motion is stretched, in any space, past a crack or not.
static void rigid_motions_have_no_energy(void **state)
{
    (void)state;
    for (int space = PDMC_SPACE_CONTINUOUS; space <= PDMC_SPACE_MIXED; space++) {
        cracked c;
        plate_form f;
        describe(1.0, 0.8, 0.21, 0.3, 0.11, &c);
        c.problem.solver.space = (pdmc_space_kind)space;
        form_create(&c.problem, 1, 2, 1, &f);
        move(&f, turned);
        CHECK_NEAR(largest(&f), 0.0, 1e-14); // of entries of 1
        form_clear(&f);
    }
}

// All pairs of points of a rectangle of sides W and H within the horizon, by its covariogram:
// c / 2 int r (W - |x|) (H - |y|) dA = c / 2 (2 pi d^3 / 3 W H - d^4 (W + H) + 2 d^5 / 5).
static double energy_of_stretch(const pdmc_problem *p)
{
    const double d = p->solver.horizon, w = p->plate.width, h = p->plate.height;
    return 0.5 * pdmc_micromodulus(&p->material, d) *
           (2.0 * M_PI / 3.0 * gsl_pow_3(d) * w * h - gsl_pow_4(d) * (w + h) + 0.4 * gsl_pow_5(d));
}

// The outer integral is what is left of the error, from the points whose discs the edges cut.
static void a_stretch_has_the_energy_of_all_bonds(void **state)
{
    (void)state;
    double error[2];
    cracked c;
    describe(1.1, 0.9, 0.2, 0.25, 0.15, &c);
    c.problem.crack_count = 0;
    for (int fine = 0; fine < 2; fine++) {
        plate_form f;
        form_create(&c.problem, fine ? 4 : 1, 3, 1, &f);
        move(&f, stretched);
        error[fine] = energy(&f) / energy_of_stretch(&c.problem) - 1.0;
        form_clear(&f);
    }
    print_message("energy to %.2g with one part, %.2g with four\n", error[0], error[1]);
    CHECK_NEAR(error[0], 0.0, 1e-4);
    CHECK_NEAR(error[1], 0.0, 1e-6);
}

// Farther from the edges than any bond of its neighbours a node feels nothing of a uniform strain: the cells are alike, so
// that what the outer points miss on one side of it they miss on the other.
static void a_uniform_strain_is_in_balance(void **state)
{
    (void)state;
    cracked c;
    plate_form f;
    int inside = 0;
    describe(1.4, 1.2, 0.2, 0.25, 0.1, &c);
    c.problem.crack_count = 0;
    form_create(&c.problem, 1, 1, 1, &f);
    move(&f, strained);
    for (int k = 0; k < f.space.count; k++) {
        if (fabs(f.space.x[2 * k]) > 0.7 - 0.45 || fabs(f.space.x[2 * k + 1]) > 0.6 - 0.45) continue;
        inside++;
        for (int i = 0; i < 2; i++) CHECK_NEAR(f.force[2 * k + i], 0.0, 1e-14);
    }
    assert_int_equal(inside, 5 * 3);
    assert_true(largest(&f) > 0.01); // at the edges
    form_clear(&f);
}

// Through the whole plate: nothing holds its halves together.
static void halves_that_a_crack_parts_move_freely(void **state)
{
    (void)state;
    cracked c;
    plate_form f;
    describe(1.0, 0.8, 0.6, 0.3, 0.13, &c);
    form_create(&c.problem, 1, 1, 1, &f);
    move(&f, torn);
    CHECK_NEAR(largest(&f), 0.0, 1e-14);
    form_clear(&f);
}

// Lifting all that is above a line takes 2 c d^2 / 3 for a unit of its length that is whole: int r sin^3 over half of the disc.
static void a_crack_frees_the_bonds_of_its_length(void **state)
{
    (void)state;
    cracked c;
    double whole = 0.0, error[2];
    describe(1.4, 0.8, 0.25, 0.3, 0.15, &c);
    c.problem.solver.space = PDMC_SPACE_DISCONTINUOUS;
    const double want = 0.5 * 2.0 / 3.0 * pdmc_micromodulus(&c.problem.material, 0.3) * 0.09;
    for (int fine = 0; fine < 2; fine++)
        for (int cracks = 0; cracks < 2; cracks++) {
            plate_form f;
            c.crack.from[1] = c.crack.to[1] = cracks ? 0.0 : 5.0; // out of the plate, with the lines of its ends
            form_create(&c.problem, fine ? 3 : 1, 1, 1, &f);
            move(&f, lifted);
            if (cracks) error[fine] = (whole - energy(&f)) / want - 1.0;
            whole = energy(&f);
            form_clear(&f);
        }
    print_message("energy of the crack to %.2g with one part, %.2g with three\n", error[0], error[1]);
    CHECK_NEAR(error[0], 0.0, 1e-2);
    CHECK_NEAR(error[1], 0.0, 1e-3);
}

static void forms_have_the_same_bits_on_any_number_of_threads(void **state)
{
    (void)state;
    cracked c;
    plate_form one, three;
    describe(1.0, 0.8, 0.21, 0.3, 0.11, &c);
    form_create(&c.problem, 1, 3, 1, &one);
    form_create(&c.problem, 1, 3, 3, &three);
    assert_memory_equal(one.form.value, three.form.value,
                        (size_t)one.form.start[one.form.count] * 9 * sizeof *one.form.value);
    form_clear(&one);
    form_clear(&three);
}

// Lines go through the ends of cracks, faces have nodes of their own, and a crack through a side has an open mouth.
static void meshes_follow_cracks(void **state)
{
    (void)state;
    cracked c;
    pdmc_mesh mesh;
    const double from[2] = {-0.33, 0.07}, to[2] = {0.8, 0.07};
    describe(1.2, 1.0, 0.2, 0.2, 0.1, &c);
    memcpy(c.crack.from, from, sizeof from);
    memcpy(c.crack.to, to, sizeof to);
    CHECK_OK(pdmc_plate_mesh(&c.problem, &mesh));
    int on_crack = 0, at_tip = 0;
    for (int n = 0; n < mesh.node_count; n++) {
        const double distance = pdmc_point_segment_distance(&mesh.x[2 * n], from, to);
        on_crack += distance < 1e-12;
        at_tip += hypot(mesh.x[2 * n] - from[0], mesh.x[2 * n + 1] - from[1]) < 1e-12;
    }
    assert_int_equal(at_tip, 1);
    assert_int_equal(on_crack, 1 + 2 * 11); // 0.93 long, in eleven cells: all columns and rows are even
    for (int e = 0; e < mesh.element_count; e++) {
        double low = INFINITY, high = -INFINITY;
        for (int k = 3 * e; k < 3 * e + 3; k++) {
            low = fmin(low, mesh.x[2 * mesh.corner[k] + 1]);
            high = fmax(high, mesh.x[2 * mesh.corner[k] + 1]);
        }
        assert_true(low >= 0.07 - 1e-12 || high <= 0.07 + 1e-12);
    }
    CHECK_NEAR(pdmc_mesh_spacing(&mesh), hypot(0.27 / 3, 0.57 / 6), 1e-12); // the diagonal of the largest cells
    pdmc_mesh_clear(&mesh);
    c.crack.to[1] = 0.1;
    CHECK_STATUS(pdmc_plate_mesh(&c.problem, &mesh), PDMC_ERR_CONFIG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rigid_motions_have_no_energy),
        cmocka_unit_test(a_stretch_has_the_energy_of_all_bonds),
        cmocka_unit_test(a_uniform_strain_is_in_balance),
        cmocka_unit_test(halves_that_a_crack_parts_move_freely),
        cmocka_unit_test(a_crack_frees_the_bonds_of_its_length),
        cmocka_unit_test(forms_have_the_same_bits_on_any_number_of_threads),
        cmocka_unit_test(meshes_follow_cracks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
