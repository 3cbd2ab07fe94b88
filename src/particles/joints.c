// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/nodes.h"

#include "base/base_impl.h"

#include <math.h>

int pdmc_whole_body(const pdmc_particles_options *o, int body)
{
    return o->bodies[body].is_part ? o->bodies[body].host : body;
}

int16_t pdmc_part_at(const pdmc_particles_options *o, int body, const double x[PDMC_AXES])
{
    const double slack = 1e-9 * o->spacing; // where the edge runs through nodes
    for (int b = o->body_count - 1; b > body; b--)
        if (o->bodies[b].is_part && o->bodies[b].host == body && pdmc_shape_holds(&o->bodies[b].shape, x, slack))
            return (int16_t)b;
    return (int16_t)body;
}

static bool names(const pdmc_interface *interface, int a, int b)
{
    return (interface->first == a && interface->second == b) || (interface->first == b && interface->second == a);
}

/// The interface that names both bodies, or else their materials; -1 where there is none.
static int find_interface(const pdmc_particles_options *o, bool of_bodies, int a, int b)
{
    const int first = of_bodies ? a : o->bodies[a].material, second = of_bodies ? b : o->bodies[b].material;
    for (int i = 0; i < o->interface_count; i++)
        if (o->interfaces[i].of_bodies == of_bodies && names(&o->interfaces[i], first, second)) return i;
    return -1;
}

static double harmonic_mean(double a, double b)
{
    return 2.0 / (1.0 / a + 1.0 / b);
}

/// What bonds inside a body are.
static void join_alike(const pdmc_brittle_law *law, size_t at, pdmc_joints *j)
{
    j->bonded[at] = true;
    j->micromodulus[at] = law->micromodulus;
    j->fibre_excess[at] = law->fibre_excess;
}

/// Bonds between two bodies: by the interface, and where that does not say it by the materials of both.
static void join(const pdmc_particles_options *o, const pdmc_brittle_law laws[], int a, int b, size_t at,
                 pdmc_joints *j)
{
    const bool is_alike = o->bodies[a].material == o->bodies[b].material;
    const pdmc_brittle_law *law = &laws[o->bodies[a].material], *other = &laws[o->bodies[b].material];
    const int by_bodies = find_interface(o, true, a, b);
    if (by_bodies < 0 && pdmc_whole_body(o, a) != pdmc_whole_body(o, b)) return;
    const int i = by_bodies >= 0 ? by_bodies : find_interface(o, false, a, b);
    const pdmc_interface *interface = i >= 0 ? &o->interfaces[i] : &(pdmc_interface){.name = ""};
    join_alike(law, at, j);
    j->interface[at] = i;
    if (!is_alike) j->micromodulus[at] = harmonic_mean(law->micromodulus, other->micromodulus);
    if (interface->micromodulus > 0.0) j->micromodulus[at] = interface->micromodulus;
    if (!is_alike || interface->micromodulus > 0.0) j->fibre_excess[at] = 0.0;
    if (interface->critical_stretch > 0.0) j->strength[at] = interface->critical_stretch, j->by_nodes[at] = INFINITY;
}

static pdmc_status make_room(int bodies, pdmc_joints *j)
{
    pdmc_status status = PDMC_OK;
    const size_t pairs = (size_t)bodies * ((size_t)bodies + 1);
    *j = (pdmc_joints){.bodies = bodies};
    PDMC_NEW(j->bonded, pairs);
    PDMC_NEW(j->interface, pairs);
    PDMC_NEW(j->micromodulus, pairs);
    PDMC_NEW(j->fibre_excess, pairs);
    PDMC_NEW(j->strength, pairs);
    PDMC_NEW(j->by_nodes, pairs);
    for (size_t k = 0; k < pairs; k++) j->strength[k] = INFINITY, j->interface[k] = -1;
done:
    return status;
}

static bool any_joints(const pdmc_particles_options *o)
{
    for (int b = 0; b < o->body_count; b++)
        if (o->bodies[b].is_part) return true;
    return o->interface_count > 0;
}

static pdmc_status check_part(const pdmc_particles_options *o, int b)
{
    const pdmc_body *body = &o->bodies[b];
    if (!body->is_part) return PDMC_OK;
    PDMC_REQUIRE(body->host >= 0 && body->host < b && !o->bodies[body->host].is_part,
                 "bodies[%d]: its host needs to be an earlier body that is no part of another", b);
    PDMC_REQUIRE(!pdmc_shape_has_nodes(body->shape.kind), "bodies[%d]: a part of another body has no nodes of its own",
                 b);
    return PDMC_OK;
}

static pdmc_status check_interface(const pdmc_particles_options *o, int i)
{
    const pdmc_interface *interface = &o->interfaces[i];
    const int count = interface->of_bodies ? o->body_count : o->material_count;
    PDMC_REQUIRE(
        interface->first >= 0 && interface->first < count && interface->second >= 0 && interface->second < count,
        "interfaces[%d]: it is between %d and %d, there are %d", i, interface->first, interface->second, count);
    PDMC_REQUIRE(!interface->of_bodies || interface->first != interface->second,
                 "interfaces[%d]: it is between a body and itself", i);
    PDMC_REQUIRE(interface->micromodulus >= 0.0 && interface->critical_stretch >= 0.0,
                 "interfaces[%d]: micromodulus and critical stretch need to be > 0, or 0 for that of the materials", i);
    return PDMC_OK;
}

/// Both directions of a bond draw the same strength.
static pdmc_status check_strengths(const pdmc_particles_options *o)
{
    for (int m = 1; m < o->material_count; m++)
        PDMC_REQUIRE(o->materials[m].strengths == o->materials[0].strengths,
                     "materials[%d]: where bodies have bonds, all materials need the same strengths", m);
    return PDMC_OK;
}

static pdmc_status check(const pdmc_particles_options *o)
{
    pdmc_status status = check_strengths(o);
    for (int b = 0; b < o->body_count && status == PDMC_OK; b++) status = check_part(o, b);
    for (int i = 0; i < o->interface_count && status == PDMC_OK; i++) status = check_interface(o, i);
    return status;
}

pdmc_status pdmc_joints_create(const pdmc_particles_options *o, const pdmc_brittle_law laws[], pdmc_joints *j)
{
    pdmc_status status = PDMC_OK;
    if (!any_joints(o)) return PDMC_OK;
    PDMC_TRY(check(o));
    PDMC_TRY(make_room(o->body_count, j));
    for (int a = 0; a < o->body_count; a++) {
        const size_t row = pdmc_joints_row(j, a) + 1;
        for (int b = 0; b < o->body_count; b++)
            if (a != b) join(o, laws, a, b, row + (size_t)b, j);
        join_alike(&laws[o->bodies[a].material], row + (size_t)a, j);
    }
done:
    return status;
}

void pdmc_joints_clear(pdmc_joints *j)
{
    pdmc_free(j->bonded);
    pdmc_free(j->interface);
    pdmc_free(j->micromodulus);
    pdmc_free(j->fibre_excess);
    pdmc_free(j->strength);
    pdmc_free(j->by_nodes);
    *j = (pdmc_joints){0};
}

/// Adds a block's bonds to one of its list to those of their interfaces, in this direction.
static void count_neighbour(const pdmc_joints *j, const pdmc_nodes *g, const pdmc_block *block, int listed,
                            uint64_t whole[])
{
    const size_t row = pdmc_joints_row(j, block->body) + 1;
    for (unsigned left = g->bonds[block->bonds + (size_t)listed]; left; left &= left - 1) {
        const size_t other = pdmc_nodes_neighbour(g, block, listed, __builtin_ctz(left));
        const int i = j->interface[row + (size_t)g->body[other]];
        if (i >= 0) whole[i]++;
    }
}

void pdmc_joints_count(const pdmc_joints *j, const pdmc_nodes *g, int interfaces, uint64_t whole[])
{
    for (int i = 0; i < interfaces; i++) whole[i] = 0;
    for (int b = 0; b < g->block_count; b++)
        for (int n = 0; n < g->blocks[b].listed && g->blocks[b].joined; n++)
            count_neighbour(j, g, &g->blocks[b], n, whole);
    for (int i = 0; i < interfaces; i++) whole[i] /= 2;
}
