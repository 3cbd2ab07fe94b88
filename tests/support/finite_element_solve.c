// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/finite_element_impl.h"

#include "sparse/factor.h"

#include <cholmod.h>
#include <math.h>

enum { UNKNOWNS = 2 * SHAPES, ENTRIES = UNKNOWNS * (UNKNOWNS + 1) / 2, HELD = 3 };

static pdmc_status check(const finite_element_plate *plate)
{
    const double W = plate->width, H = plate->height, *tip = plate->tip;
    const double(*t)[2] = plate->traction;
    PDMC_REQUIRE(W > 0.0 && H > 0.0, "a plate of %g x %g", W, H);
    PDMC_REQUIRE(-0.5 * W < tip[0] && tip[0] < tip[1] && tip[1] < 0.5 * W, "a crack from %g to %g", tip[0], tip[1]);
    PDMC_REQUIRE(plate->refinement >= 2, "refinement = %d < 2", plate->refinement);
    const double moment =
        0.5 * W * H * (t[PDMC_SIDE_RIGHT][1] - t[PDMC_SIDE_LEFT][1] - t[PDMC_SIDE_TOP][0] + t[PDMC_SIDE_BOTTOM][0]);
    double force[2], largest = 0.0;
    for (int d = 0; d < 2; d++) {
        force[d] =
            H * (t[PDMC_SIDE_LEFT][d] + t[PDMC_SIDE_RIGHT][d]) + W * (t[PDMC_SIDE_BOTTOM][d] + t[PDMC_SIDE_TOP][d]);
        for (int side = 0; side < 4; side++) largest = fmax(largest, fabs(t[side][d]));
    }
    const double rounding = 1e-14 * largest * (W + H); // of sums of four tractions
    PDMC_REQUIRE(hypot(force[0], force[1]) <= rounding && fabs(moment) <= rounding * (W + H),
                 "the tractions have the force (%g, %g) and the moment %g", force[0], force[1], moment);
    return PDMC_OK;
}

static void sample_modulus(const finite_element_plate *plate, const finite_element_mesh *mesh, double modulus[])
{
    for (int k = 0; k < mesh->nodes; k++) {
        double x[2];
        finite_element_node(mesh, k, x);
        modulus[k] = plate->modulus ? plate->modulus(plate->context, x) : 1.0;
    }
}

// int M (lambda N_a,i N_b,j + mu N_a,j N_b,i + mu delta_ij N_a,k N_b,k) dA with lambda = mu.
static void add_point(const finite_element_shapes *shapes, double factor, double matrix[UNKNOWNS][UNKNOWNS])
{
    for (int a = 0; a < SHAPES; a++) {
        const double *p = shapes->slope[a];
        for (int b = 0; b <= a; b++) {
            const double *q = shapes->slope[b], dot = p[0] * q[0] + p[1] * q[1];
            for (int i = 0; i < 2; i++)
                for (int j = 0; j < 2; j++)
                    matrix[2 * a + i][2 * b + j] += factor * (p[i] * q[j] + p[j] * q[i] + (i == j ? dot : 0.0));
        }
    }
}

static void element_stiffness(const finite_element *element, double mu, const double modulus[],
                              double matrix[UNKNOWNS][UNKNOWNS])
{
    for (int k = 0; k < UNKNOWNS * UNKNOWNS; k++) matrix[k / UNKNOWNS][k % UNKNOWNS] = 0.0;
    for (int g = 0; g < GAUSS_POINTS; g++) {
        double local[2], M = 0.0;
        const double area = finite_element_gauss(element, g, local);
        const finite_element_shapes shapes = finite_element_shapes_at(element, local);
        for (int k = 0; k < SHAPES; k++) M += shapes.value[k] * modulus[element->node[k]];
        add_point(&shapes, mu * M * area, matrix);
    }
}

static bool is_held(const int held[HELD], int unknown)
{
    for (int k = 0; k < HELD; k++)
        if (held[k] == unknown) return true;
    return false;
}

static void append(cholmod_triplet *out, int row, int column, double value)
{
    const size_t at = out->nnz++;
    ((int64_t *)out->i)[at] = row > column ? row : column;
    ((int64_t *)out->j)[at] = row > column ? column : row;
    ((double *)out->x)[at] = value;
}

static void append_element(const finite_element *element, double matrix[UNKNOWNS][UNKNOWNS], const int held[HELD],
                           cholmod_triplet *out)
{
    for (int a = 0; a < UNKNOWNS; a++)
        for (int b = 0; b <= a; b++) {
            const int row = 2 * element->node[a / 2] + a % 2, column = 2 * element->node[b / 2] + b % 2;
            if (!is_held(held, row) && !is_held(held, column)) append(out, row, column, matrix[a][b]);
        }
}

// The lower left corner, and the lower right one in y: no force acts there.
static void hold(const finite_element_mesh *mesh, int held[HELD])
{
    held[0] = 0;
    held[1] = 1;
    held[2] = 4 * mesh->cells[0] + 1;
}

static void fill(const finite_element_solution *s, cholmod_triplet *out)
{
    int held[HELD];
    double matrix[UNKNOWNS][UNKNOWNS];
    hold(&s->mesh, held);
    for (int row = 0; row < s->mesh.cells[1]; row++)
        for (int column = 0; column < s->mesh.cells[0]; column++) {
            const finite_element element = finite_element_at(&s->mesh, column, row);
            element_stiffness(&element, s->mu, s->modulus, matrix);
            append_element(&element, matrix, held, out);
        }
    for (int k = 0; k < HELD; k++) append(out, held[k], held[k], s->mu);
}

static pdmc_status factor(const finite_element_solution *s, pdmc_sparse_factor **out)
{
    pdmc_status status = PDMC_OK;
    const size_t unknowns = 2 * (size_t)s->mesh.nodes;
    const size_t entries = ENTRIES * (size_t)s->mesh.cells[0] * (size_t)s->mesh.cells[1] + HELD;
    cholmod_common common;
    cholmod_l_start(&common);
    cholmod_sparse *sum = NULL;
    cholmod_triplet *parts = cholmod_l_allocate_triplet(unknowns, unknowns, entries, -1, CHOLMOD_REAL, &common);
    if (!parts) PDMC_FAIL(PDMC_ERR_NOMEM, "no memory for %zu entries", entries);
    fill(s, parts);
    sum = cholmod_l_triplet_to_sparse(parts, 0, &common);
    if (!sum) PDMC_FAIL(PDMC_ERR_NOMEM, "no memory for %zu entries", entries);
    const pdmc_sparse_matrix matrix = {.unknowns = (int)unknowns, .start = sum->p, .row = sum->i, .value = sum->x};
    PDMC_TRY(pdmc_sparse_factor_create(&matrix, NULL, NULL, out));
done:
    cholmod_l_free_sparse(&sum, &common);
    cholmod_l_free_triplet(&parts, &common);
    cholmod_l_finish(&common);
    return status;
}

// Simpson's weights are those of a parabola's nodes.
static void load_edge(const finite_element *element, int axis, int first, int step, const double traction[2],
                      double load[])
{
    for (int k = 0; k < 3; k++)
        for (int d = 0; d < 2; d++)
            load[2 * element->node[first + k * step] + d] +=
                element->half[axis] * (k == 1 ? 4.0 : 1.0) / 3.0 * traction[d];
}

static void load_sides(const finite_element_solution *s, double load[])
{
    const finite_element_mesh *mesh = &s->mesh;
    const double(*traction)[2] = s->plate.traction;
    for (int row = 0; row < mesh->cells[1]; row++) {
        const finite_element left = finite_element_at(mesh, 0, row);
        const finite_element right = finite_element_at(mesh, mesh->cells[0] - 1, row);
        load_edge(&left, 1, 0, 3, traction[PDMC_SIDE_LEFT], load);
        load_edge(&right, 1, 2, 3, traction[PDMC_SIDE_RIGHT], load);
    }
    for (int column = 0; column < mesh->cells[0]; column++) {
        const finite_element bottom = finite_element_at(mesh, column, 0);
        const finite_element top = finite_element_at(mesh, column, mesh->cells[1] - 1);
        load_edge(&bottom, 0, 0, 1, traction[PDMC_SIDE_BOTTOM], load);
        load_edge(&top, 0, 6, 1, traction[PDMC_SIDE_TOP], load);
    }
}

static pdmc_status solve(finite_element_solution *s)
{
    pdmc_status status = PDMC_OK;
    pdmc_sparse_factor *inverse = NULL;
    double *load = NULL;
    int held[HELD];
    PDMC_NEW(load, 2 * s->mesh.nodes);
    load_sides(s, load);
    hold(&s->mesh, held);
    for (int k = 0; k < HELD; k++) load[held[k]] = 0.0;
    PDMC_TRY(factor(s, &inverse));
    PDMC_TRY(pdmc_sparse_factor_solve(inverse, 1, load, s->displacement));
    for (int k = 0; k < 2 * s->mesh.nodes; k++) s->potential_energy -= 0.5 * load[k] * s->displacement[k];
done:
    pdmc_sparse_factor_destroy(&inverse);
    pdmc_free(load);
    return status;
}

pdmc_status finite_element_solve(const finite_element_plate *plate, finite_element_solution **solution)
{
    pdmc_status status = PDMC_OK;
    finite_element_solution *s = NULL;
    pdmc_blas_prepare();
    PDMC_TRY(check(plate));
    PDMC_NEW(s, 1);
    s->plate = *plate;
    // nu = 1/3 in plane stress, 1/4 in plane strain
    s->mu = plate->youngs_modulus * (plate->assumption == PDMC_PLANE_STRESS ? 3.0 / 8.0 : 2.0 / 5.0);
    PDMC_TRY(finite_element_mesh_create(plate, &s->mesh));
    PDMC_NEW(s->modulus, s->mesh.nodes);
    PDMC_NEW(s->displacement, 2 * s->mesh.nodes);
    sample_modulus(plate, &s->mesh, s->modulus);
    PDMC_TRY(solve(s));
    *solution = s;
    s = NULL;
done:
    finite_element_destroy(&s);
    return status;
}

void finite_element_destroy(finite_element_solution **solution)
{
    finite_element_solution *s = *solution;
    if (!s) return;
    finite_element_mesh_clear(&s->mesh);
    pdmc_free(s->modulus);
    pdmc_free(s->displacement);
    pdmc_free(s);
    *solution = NULL;
}

double finite_element_potential_energy(const finite_element_solution *solution)
{
    return solution->potential_energy;
}

double finite_element_radius(const finite_element_solution *solution)
{
    return solution->mesh.radius;
}

// The cell that holds a coordinate; of two, the later one.
static int find(const finite_element_mesh *mesh, int axis, double x)
{
    int low = 0, high = mesh->cells[axis];
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (x >= mesh->line[axis][2 * middle]) low = middle;
        else high = middle;
    }
    return low;
}

void finite_element_displacement(const finite_element_solution *solution, const double x[2], double u[2])
{
    const finite_element_mesh *mesh = &solution->mesh;
    const finite_element element = finite_element_at(mesh, find(mesh, 0, x[0]), find(mesh, 1, x[1]));
    double local[2];
    for (int d = 0; d < 2; d++) local[d] = (x[d] - element.centre[d]) / element.half[d];
    const finite_element_shapes shapes = finite_element_shapes_at(&element, local);
    u[0] = u[1] = 0.0;
    for (int k = 0; k < SHAPES; k++)
        for (int d = 0; d < 2; d++) u[d] += shapes.value[k] * solution->displacement[2 * element.node[k] + d];
}

pdmc_status finite_element_evaluate(const finite_element_plate *plate, finite_element_result *result)
{
    pdmc_status status = PDMC_OK;
    finite_element_solution *solution = NULL;
    PDMC_TRY(finite_element_solve(plate, &solution));
    const double radius = finite_element_radius(solution);
    for (int tip = 0; tip < 2; tip++) {
        result->energy_release_rate[tip] = finite_element_energy_release_rate(solution, tip, radius);
        finite_element_stress_intensity(solution, tip, radius, result->stress_intensity[tip]);
    }
    result->potential_energy = finite_element_potential_energy(solution);
done:
    finite_element_destroy(&solution);
    return status;
}
