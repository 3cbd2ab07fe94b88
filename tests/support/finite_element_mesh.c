// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/finite_element_impl.h"

#include <math.h>

// Element boundaries at radius (i / n)^GRADING from the tip. Quadratic elements then resolve sqrt(r) as well as a smooth
// function, error of the energy ~ n^-4, if GRADING > 2 / (1/2) (I. Babuska, R. B. Kellogg, J. Pitkaranta, Numerische
// Mathematik 33 (1979) 447-471).
static const double grading = 4.5;

static double graded(const finite_element_mesh *mesh, int refinement, int i)
{
    return mesh->radius * pow((double)i / refinement, grading);
}

// Beyond the graded box, elements are as long as its last one.
static int plain_count(const finite_element_mesh *mesh, int refinement, double length)
{
    const double last = mesh->radius - graded(mesh, refinement, refinement - 1);
    return (int)ceil((length - mesh->radius) / last - 1e-9);
}

static int count(const finite_element_mesh *mesh, int refinement, double length)
{
    return refinement + plain_count(mesh, refinement, length);
}

// Lattice lines from a tip, at line[0], to `end`; direction +1 or -1 in memory as in space.
static void place(const finite_element_mesh *mesh, int refinement, double end, int direction, double *line)
{
    const double tip = line[0], length = fabs(end - tip);
    const int plain = plain_count(mesh, refinement, length);
    for (int i = 1; i <= refinement + plain; i++) {
        const double distance = i <= refinement ? graded(mesh, refinement, i)
                                                : mesh->radius + (length - mesh->radius) * (i - refinement) / plain;
        line[2 * i * direction] = i == refinement + plain ? end : tip + direction * distance;
        line[(2 * i - 1) * direction] = 0.5 * (line[2 * i * direction] + line[(2 * i - 2) * direction]);
    }
}

static void place_columns(const finite_element_plate *plate, finite_element_mesh *mesh)
{
    const int n = plate->refinement;
    const double centre = 0.5 * (plate->tip[0] + plate->tip[1]);
    for (int t = 0; t < 2; t++) {
        double *line = &mesh->line[0][mesh->tip[t]];
        *line = plate->tip[t];
        place(mesh, n, centre, t ? -1 : 1, line);
        place(mesh, n, t ? 0.5 * plate->width : -0.5 * plate->width, t ? 1 : -1, line);
    }
}

static void place_rows(const finite_element_plate *plate, finite_element_mesh *mesh)
{
    for (int direction = -1; direction <= 1; direction += 2)
        place(mesh, plate->refinement, 0.5 * direction * plate->height, direction, &mesh->line[1][mesh->middle]);
}

pdmc_status finite_element_mesh_create(const finite_element_plate *plate, finite_element_mesh *mesh)
{
    pdmc_status status = PDMC_OK;
    const double half = 0.5 * (plate->tip[1] - plate->tip[0]);
    const double outside[2] = {plate->tip[0] + 0.5 * plate->width, 0.5 * plate->width - plate->tip[1]};
    *mesh = (finite_element_mesh){
        .radius = fmin(fmin(half, 0.5 * plate->height), fmin(outside[0], outside[1])),
    };
    const int n = plate->refinement, inside = 2 * count(mesh, n, half);
    const int left = count(mesh, n, outside[0]), right = count(mesh, n, outside[1]);
    mesh->cells[0] = left + inside + right;
    mesh->cells[1] = 2 * count(mesh, n, 0.5 * plate->height);
    mesh->tip[0] = 2 * left;
    mesh->tip[1] = 2 * (left + inside);
    mesh->middle = mesh->cells[1];
    mesh->nodes = (2 * mesh->cells[0] + 1) * (2 * mesh->cells[1] + 1) + mesh->tip[1] - mesh->tip[0] - 1;
    for (int axis = 0; axis < 2; axis++) PDMC_NEW(mesh->line[axis], 2 * mesh->cells[axis] + 1);
    place_columns(plate, mesh);
    place_rows(plate, mesh);
done:
    if (status != PDMC_OK) finite_element_mesh_clear(mesh);
    return status;
}

void finite_element_mesh_clear(finite_element_mesh *mesh)
{
    for (int axis = 0; axis < 2; axis++) pdmc_free(mesh->line[axis]);
    *mesh = (finite_element_mesh){0};
}

static int lattice_columns(const finite_element_mesh *mesh)
{
    return 2 * mesh->cells[0] + 1;
}

static int lattice_nodes(const finite_element_mesh *mesh)
{
    return lattice_columns(mesh) * (2 * mesh->cells[1] + 1);
}

finite_element finite_element_at(const finite_element_mesh *mesh, int column, int row)
{
    finite_element e;
    const int corner[2] = {2 * column, 2 * row};
    for (int axis = 0; axis < 2; axis++) {
        const double *line = &mesh->line[axis][corner[axis]];
        e.centre[axis] = line[1];
        e.half[axis] = 0.5 * (line[2] - line[0]);
    }
    for (int k = 0; k < SHAPES; k++) {
        const int i = corner[0] + k % 3, j = corner[1] + k / 3;
        const bool upper_face = k < 3 && j == mesh->middle && mesh->tip[0] < i && i < mesh->tip[1];
        e.node[k] = upper_face ? lattice_nodes(mesh) + i - mesh->tip[0] - 1 : j * lattice_columns(mesh) + i;
    }
    return e;
}

void finite_element_node(const finite_element_mesh *mesh, int node, double x[2])
{
    const int extra = node - lattice_nodes(mesh);
    x[0] = mesh->line[0][extra >= 0 ? mesh->tip[0] + 1 + extra : node % lattice_columns(mesh)];
    x[1] = mesh->line[1][extra >= 0 ? mesh->middle : node / lattice_columns(mesh)];
}

static void parabolas(double s, double value[3], double slope[3])
{
    value[0] = 0.5 * s * (s - 1.0);
    value[1] = 1.0 - s * s;
    value[2] = 0.5 * s * (s + 1.0);
    slope[0] = s - 0.5;
    slope[1] = -2.0 * s;
    slope[2] = s + 0.5;
}

finite_element_shapes finite_element_shapes_at(const finite_element *element, const double local[2])
{
    finite_element_shapes shapes;
    double value[2][3], slope[2][3];
    for (int axis = 0; axis < 2; axis++) parabolas(local[axis], value[axis], slope[axis]);
    for (int k = 0; k < SHAPES; k++) {
        const int i = k % 3, j = k / 3;
        shapes.value[k] = value[0][i] * value[1][j];
        shapes.slope[k][0] = slope[0][i] * value[1][j] / element->half[0];
        shapes.slope[k][1] = value[0][i] * slope[1][j] / element->half[1];
    }
    return shapes;
}

// Four points integrate sigma : epsilon of a parabolic M exactly.
double finite_element_gauss(const finite_element *element, int k, double local[2])
{
    static const double point[2] = {0.33998104358485626, 0.86113631159405258};
    static const double weight[2] = {0.65214515486254614, 0.34785484513745386};
    double share = 1.0;
    for (int axis = 0; axis < 2; axis++) {
        const int i = axis ? k / 4 : k % 4;
        local[axis] = i < 2 ? -point[1 - i] : point[i - 2];
        share *= element->half[axis] * weight[i < 2 ? 1 - i : i - 2];
    }
    return share;
}
