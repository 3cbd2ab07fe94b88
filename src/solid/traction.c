// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid_impl.h"

#include "base/base_impl.h"
#include "pdmc/quadrature.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

enum { RADII = 12, ANGLES = 8, DEPTHS = 4, MAX_BREAKS = 18 };

/// A face of the body as the point at a depth below it sees it: a rectangle about the point's foot, and the traction's
/// size over it.
typedef struct {
    double strain[3][3]; // of a uniform body under the traction, in directions along, along, outwards
    double micromodulus, horizon;
    double below[2], above[2];  // distances of the foot from the rectangle's sides
    double factor, gradient[2]; // of the traction at the foot, and along the face
} face_view;

/// The strain of a uniform body under a stress whose traction on the third plane is t, nu = 1/4: the plane's normal and shear stresses and no others.
static void strain_of_traction(double youngs_modulus, const double t[3], double strain[3][3])
{
    const double nu = 0.25;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) strain[i][j] = 0.0;
    for (int k = 0; k < 2; k++) {
        strain[k][k] = -nu * t[2] / youngs_modulus;
        strain[k][2] = strain[2][k] = (1.0 + nu) * t[k] / youngs_modulus;
    }
    strain[2][2] = t[2] / youngs_modulus;
}

/// How far a ray along the face runs within the horizon's disc and the face.
static double ray_end(const face_view *view, double radius, double angle)
{
    const double direction[2] = {cos(angle), sin(angle)};
    double end = radius;
    for (int k = 0; k < 2; k++) {
        const double side = direction[k] > 0.0 ? view->above[k] : view->below[k];
        if (fabs(direction[k]) * end > side) end = side / fabs(direction[k]);
    }
    return end;
}

/// Angles at which a ray's end passes from one side, or the circle, to another: the rule is smooth between them.
static size_t break_angles(const face_view *view, double radius, double angle[MAX_BREAKS])
{
    size_t count = 0;
    angle[count++] = -M_PI;
    for (int quadrant = 0; quadrant < 4; quadrant++) {
        const double sign[2] = {quadrant & 1 ? -1.0 : 1.0, quadrant & 2 ? -1.0 : 1.0};
        const double side[2] = {quadrant & 1 ? view->below[0] : view->above[0],
                                quadrant & 2 ? view->below[1] : view->above[1]};
        const double across[2] = {fmin(side[0], radius), fmin(side[1], radius)};
        angle[count++] = atan2(sign[1] * sqrt(radius * radius - across[0] * across[0]), sign[0] * across[0]);
        angle[count++] = atan2(sign[1] * across[1], sign[0] * sqrt(radius * radius - across[1] * across[1]));
        angle[count++] = atan2(sign[1] * side[1], sign[0] * side[0]);
    }
    angle[count++] = M_PI;
    gsl_sort(angle, 1, count);
    return count;
}

/// Adds int f_L dS over one ray of the rule, weighted.
static void add_ray(const face_view *view, double depth, double angle, double end, double weight,
                    const double radius[RADII], const double share[RADII], double force[3])
{
    for (int i = 0; i < RADII; i++) {
        const double r = radius[i] * end, across[2] = {r * cos(angle), r * sin(angle)};
        const double size = view->factor + view->gradient[0] * across[0] + view->gradient[1] * across[1];
        double line[3];
        pdmc_line_to_point_force(view->strain, view->horizon, depth, across, line);
        for (int k = 0; k < 3; k++) force[k] += weight * share[i] * end * r * size * view->micromodulus * line[k];
    }
}

/// int_S f_L dS at a depth below the face (Yu 2011, eq. 4.48): polar about the foot, Gauss in both directions between the
/// angles where the region's edge has corners.
static pdmc_status face_force(const face_view *view, double depth, double force[3])
{
    pdmc_status status = PDMC_OK;
    double angle[MAX_BREAKS], radius[RADII], share[RADII];
    force[0] = force[1] = force[2] = 0.0;
    if (depth >= view->horizon) return PDMC_OK;
    const double disc = sqrt(view->horizon * view->horizon - depth * depth);
    const size_t breaks = break_angles(view, disc, angle);
    PDMC_TRY(pdmc_gauss_legendre(RADII, 0.0, 1.0, radius, share));
    for (size_t b = 0; b + 1 < breaks; b++) {
        double at[ANGLES], weight[ANGLES];
        if (angle[b + 1] - angle[b] < 1e-14) continue;
        PDMC_TRY(pdmc_gauss_legendre(ANGLES, angle[b], angle[b + 1], at, weight));
        for (int i = 0; i < ANGLES; i++)
            add_ray(view, depth, at[i], ray_end(view, disc, at[i]), weight[i], radius, share, force);
    }
done:
    return status;
}

/// The mean over the depths of a cell, so that the force on a column of cells is the traction whatever the spacing.
static pdmc_status cell_force(const face_view *view, double near, double far, double force[3])
{
    pdmc_status status = PDMC_OK;
    double depth[DEPTHS], weight[DEPTHS];
    force[0] = force[1] = force[2] = 0.0;
    PDMC_TRY(pdmc_gauss_legendre(DEPTHS, near, fmin(far, view->horizon), depth, weight));
    for (int i = 0; i < DEPTHS; i++) {
        double at[3];
        PDMC_TRY(face_force(view, depth[i], at));
        for (int k = 0; k < 3; k++) force[k] += weight[i] / (far - near) * at[k];
    }
done:
    return status;
}

/// Directions of a face's own axes: along, along, outwards.
static void axes_of(int face, int axis[3])
{
    axis[2] = face / 2;
    axis[0] = (axis[2] + 1) % 3;
    axis[1] = (axis[2] + 2) % 3;
}

/// A node's view of a face with one component of its traction, along the face's own axes.
static void look(const pdmc_solid *solid, int face, const int axis[3], size_t node, int component, double traction,
                 face_view *view)
{
    const pdmc_solid_options *o = &solid->options;
    int index[3];
    double x[3], own[3] = {0.0, 0.0, 0.0};
    own[component] = traction;
    solid_indices(solid, node, index);
    pdmc_solid_position(solid, node, x);
    *view = (face_view){.micromodulus = solid->micromodulus, .horizon = o->horizon, .factor = 1.0};
    strain_of_traction(o->youngs_modulus, own, view->strain);
    for (int k = 0; k < 2; k++) {
        view->below[k] = (index[axis[k]] + 0.5) * o->spacing;
        view->above[k] = (o->nodes[axis[k]] - index[axis[k]] - 0.5) * o->spacing;
        view->gradient[k] = o->load[face].gradient[axis[k]];
        view->factor += view->gradient[k] * x[axis[k]];
    }
}

/// The cells under one place of a face: what each feels of it, [layers], and the areal force density (eq. 4.9).
static pdmc_status forces_under(const face_view *view, double spacing, int component, int layers, double (*force)[3],
                                double *density)
{
    pdmc_status status = PDMC_OK;
    *density = 0.0;
    for (int layer = 0; layer < layers; layer++) {
        PDMC_TRY(cell_force(view, layer * spacing, (layer + 1) * spacing, force[layer]));
        *density += spacing * force[layer][component];
    }
done:
    return status;
}

/// Adds the force of one component to the cells under one place of a face. Where the face's sides cut S, the areal force
/// density is not the traction; a part of the uniform traction's force is added that makes it so (eq. 4.14) everywhere.
/// What points outwards below the body points against the axis: mirrored, and back.
static pdmc_status add_under(pdmc_solid *solid, int face, const int axis[3], int component, const int top[3])
{
    pdmc_status status = PDMC_OK;
    const double h = solid->options.spacing, outwards = face % 2 ? 1.0 : -1.0;
    const double traction = solid->options.load[face].traction[axis[component]] * (component == 2 ? outwards : 1.0);
    const int layers = (int)ceil(solid->options.horizon / h);
    double(*given)[3] = NULL, (*uniform)[3] = NULL, given_density, uniform_density;
    face_view view;
    int index[3] = {top[0], top[1], top[2]};
    if (traction == 0.0) return PDMC_OK;
    PDMC_NEW(given, layers);
    PDMC_NEW(uniform, layers);
    look(solid, face, axis, solid_node(solid, top), component, traction, &view);
    const double wanted = view.factor * traction;
    PDMC_TRY(forces_under(&view, h, component, layers, given, &given_density));
    view.factor = 1.0;
    view.gradient[0] = view.gradient[1] = 0.0;
    PDMC_TRY(forces_under(&view, h, component, layers, uniform, &uniform_density));
    for (int layer = 0; layer < layers && layer < solid->options.nodes[axis[2]]; layer++) {
        const double missing = (wanted - given_density) / uniform_density;
        for (int k = 0; k < 3; k++)
            solid->traction[(size_t)axis[k] * solid->nodes + solid_node(solid, index)] +=
                (k == 2 ? outwards : 1.0) * (given[layer][k] + missing * uniform[layer][k]);
        index[axis[2]] -= (int)outwards;
    }
done:
    pdmc_free(given);
    pdmc_free(uniform);
    return status;
}

static pdmc_status add_face(pdmc_solid *solid, int face)
{
    pdmc_status status = PDMC_OK;
    int axis[3], top[3];
    axes_of(face, axis);
    const int *n = solid->options.nodes;
    top[axis[2]] = face % 2 ? n[axis[2]] - 1 : 0;
    for (top[axis[0]] = 0; top[axis[0]] < n[axis[0]]; top[axis[0]]++)
        for (top[axis[1]] = 0; top[axis[1]] < n[axis[1]]; top[axis[1]]++)
            for (int component = 0; component < 3; component++) PDMC_TRY(add_under(solid, face, axis, component, top));
done:
    return status;
}

pdmc_status solid_add_tractions(pdmc_solid *solid)
{
    pdmc_status status = PDMC_OK;
    for (int face = 0; face < PDMC_SOLID_FACES; face++) {
        if (solid->loaded[face]) PDMC_TRY(add_face(solid, face));
    }
done:
    return status;
}
