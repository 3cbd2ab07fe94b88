// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "particles/lattice.h"
#include "particles/particles_impl.h"
#include "particles/scattered.h"
#include "particles/stable.h"

#include <math.h>
#include <string.h>

static pdmc_status check(const pdmc_particles_options *o)
{
    PDMC_REQUIRE(o, "options: NULL");
    PDMC_REQUIRE(o->dimension == 2 || o->dimension == 3, "dimension: %d, needs to be 2 or 3", o->dimension);
    PDMC_REQUIRE(o->spacing > 0.0 && isfinite(o->spacing), "spacing: %g, needs to be > 0", o->spacing);
    PDMC_REQUIRE(o->horizon >= o->spacing && o->horizon <= 100.0 * o->spacing,
                 "horizon: %g, needs to be between 1 and 100 spacings of %g", o->horizon, o->spacing);
    PDMC_REQUIRE(o->dimension == 3 || o->thickness > 0.0, "thickness: %g, needs to be > 0", o->thickness);
    PDMC_REQUIRE(o->contact_distance >= 0.0 && o->contact_stiffness >= 0.0,
                 "contact: a negative distance or stiffness");
    PDMC_REQUIRE(o->damping >= 0.0 && o->bond_damping >= 0.0, "damping: it is negative");
    PDMC_REQUIRE(o->material_count > 0 && o->body_count > 0, "bodies: there is none, or no material");
    PDMC_REQUIRE(o->threads >= 1, "threads: %d, needs to be >= 1", o->threads);
    for (int m = 0; m < o->material_count; m++)
        PDMC_REQUIRE(o->materials[m].density > 0.0 && o->materials[m].micromodulus > 0.0 &&
                         o->materials[m].critical_stretch > 0.0,
                     "materials[%d]: density, micromodulus and critical stretch need to be > 0", m);
    for (int m = 0; m < o->material_count; m++)
        PDMC_REQUIRE(o->materials[m].fibre_ratio >= 0.0, "materials[%d]: fibre_ratio: %g, needs to be >= 0", m,
                     o->materials[m].fibre_ratio);
    for (int b = 0; b < o->body_count; b++)
        PDMC_REQUIRE(o->bodies[b].material >= 0 && o->bodies[b].material < o->material_count,
                     "bodies[%d]: material %d, there are %d", b, o->bodies[b].material, o->material_count);
    for (int b = 0; b < o->body_count; b++)
        PDMC_REQUIRE(!pdmc_shape_has_nodes(o->bodies[b].shape.kind) || o->bodies[b].nodes, "bodies[%d]: nodes: NULL",
                     b);
    for (int s = 0; s < o->sphere_count; s++)
        PDMC_REQUIRE(o->spheres[s].radius > 0.0 && o->spheres[s].mass > 0.0 && o->spheres[s].stiffness > 0.0,
                     "spheres[%d]: radius, mass and stiffness need to be > 0", s);
    return PDMC_OK;
}

/// The stiffness of the repulsion is that of the softest material.
static double repulsion_of(const pdmc_particles_options *o)
{
    double least = INFINITY;
    for (int m = 0; m < o->material_count; m++) least = fmin(least, o->materials[m].micromodulus);
    return o->contact_stiffness * least / o->horizon;
}

static void lay_fibres(const pdmc_brittle_material *material, pdmc_brittle_law *law)
{
    const double *g = material->fibre, length = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    if (length == 0.0) return;
    for (int a = 0; a < PDMC_AXES; a++) law->fibre[a] = g[a] / length;
    law->fibre_excess = material->fibre_ratio - 1.0;
}

static pdmc_status copy_materials(const pdmc_particles_options *o, pdmc_particles *p)
{
    pdmc_status status = PDMC_OK;
    p->material_count = o->material_count;
    PDMC_NEW(p->density, o->material_count);
    PDMC_NEW(p->laws, o->material_count);
    for (int m = 0; m < o->material_count; m++) {
        const pdmc_brittle_material *material = &o->materials[m];
        p->density[m] = material->density;
        p->laws[m] = (pdmc_brittle_law){.micromodulus = material->micromodulus,
                                        .critical_stretch = material->critical_stretch,
                                        .strengthening = material->strengthening};
        lay_fibres(material, &p->laws[m]);
    }
done:
    return status;
}

static pdmc_status make_room(const pdmc_particles_options *o, pdmc_particles *p)
{
    pdmc_status status = PDMC_OK;
    const size_t cells = p->nodes.cells + PDMC_LANES, blocks = (size_t)p->nodes.block_count;
    for (int a = 0; a < PDMC_AXES; a++) {
        PDMC_NEW(p->position[a], cells);
        PDMC_NEW(p->velocity[a], cells);
        PDMC_NEW(p->force[a], cells);
        memcpy(p->position[a], p->nodes.reference[a], cells * sizeof(double));
    }
    PDMC_NEW(p->held, cells);
    PDMC_NEW(p->strength, cells);
    PDMC_NEW(p->next_strength, cells);
    PDMC_NEW(p->fracture, blocks);
    PDMC_NEW(p->elastic, blocks);
    PDMC_NEW(p->contact_energy, blocks);
    PDMC_NEW(p->share, 4 * blocks);
    PDMC_NEW(p->layers, o->condition_count);
    PDMC_NEW(p->spheres, o->sphere_count);
    PDMC_NEW(p->sphere_force, PDMC_AXES * (size_t)o->sphere_count);
    PDMC_NEW(p->sphere_energy, o->sphere_count);
done:
    return status;
}

static void start_nodes(const pdmc_particles_options *o, pdmc_particles *p)
{
    for (int b = 0; b < p->nodes.block_count; b++) {
        const pdmc_block *block = &p->nodes.blocks[b];
        const pdmc_body *body = &o->bodies[pdmc_whole_body(o, block->body)];
        const double *first = p->variation.first_strength;
        for (unsigned left = block->nodes; left; left &= left - 1) {
            const size_t c = block->cell + (size_t)__builtin_ctz(left);
            for (int a = 0; a < o->dimension; a++) p->velocity[a][c] = body->velocity[a];
            const double s_0 = first ? first[c] : p->laws[block->material].critical_stretch;
            p->strength[c] = p->next_strength[c] = s_0;
            if (p->is_single) p->single.strength[c] = p->single.next_strength[c] = (float)s_0;
        }
    }
}

static void hold_nodes(pdmc_particles *p)
{
    for (int l = 0; l < p->layer_count; l++) {
        const pdmc_layer *layer = &p->layers[l];
        unsigned axes = 0;
        for (int a = 0; a < PDMC_AXES; a++)
            axes |= (unsigned)(pdmc_layer_holds(layer) && layer->condition.along[a]) << a;
        for (int k = 0; k < layer->count; k++) p->held[layer->cell[k]] |= (uint8_t)axes;
    }
}

static void start_spheres(const pdmc_particles_options *o, pdmc_particles *p)
{
    p->sphere_count = o->sphere_count;
    if (o->sphere_count > 0) memcpy(p->spheres, o->spheres, (size_t)o->sphere_count * sizeof *p->spheres);
}

static pdmc_status choose_step(const pdmc_particles_options *o, pdmc_particles *p)
{
    p->stable_step =
        pdmc_bonds_stable_step(&p->nodes, &p->variation, p->material_count, p->laws, p->density, o->bond_damping);
    p->step = o->step > 0.0 ? o->step : o->safety * p->stable_step;
    PDMC_REQUIRE(p->step > 0.0 && p->step <= p->stable_step,
                 "step: %g is too large, must be at most %g, the largest stable one", p->step, p->stable_step);
    return PDMC_OK;
}

static bool has_scattered(const pdmc_particles_options *o)
{
    for (int b = 0; b < o->body_count; b++)
        if (pdmc_shape_has_nodes(o->bodies[b].shape.kind)) return true;
    return false;
}

static bool has_node(const pdmc_nodes *g, int body)
{
    for (int b = 0; b < g->block_count; b++)
        if (g->blocks[b].body == body) return true;
    return false;
}

static pdmc_status check_nodes(const pdmc_particles_options *o, const pdmc_nodes *g)
{
    for (int b = 0; b < o->body_count; b++) {
        const pdmc_body *body = &o->bodies[b];
        PDMC_REQUIRE(has_node(g, b) || !body->is_part, "bodies[%d]: holds no node of bodies[%d]", b, body->host);
        PDMC_REQUIRE(has_node(g, b), "bodies[%d]: holds no node", b);
    }
    return PDMC_OK;
}

static pdmc_status count_interfaces(const pdmc_particles_options *o, pdmc_particles *p)
{
    pdmc_status status = PDMC_OK;
    p->interface_count = o->interface_count;
    PDMC_NEW(p->interface_bonds, o->interface_count);
    pdmc_joints_count(&p->variation.joints, &p->nodes, o->interface_count, p->interface_bonds);
    for (int i = 0; i < o->interface_count; i++)
        if (p->interface_bonds[i] == 0) PDMC_FAIL(PDMC_ERR_ARG, "interfaces[%d]: no bond is between the two", i);
done:
    return status;
}

static pdmc_status create(const pdmc_particles_options *o, pdmc_particles *p)
{
    pdmc_status status = PDMC_OK;
    p->threads = o->threads;
    p->linear = o->linear_stretch;
    PDMC_TRY(copy_materials(o, p));
    PDMC_TRY(pdmc_joints_create(o, p->laws, &p->variation.joints));
    PDMC_TRY(has_scattered(o) ? pdmc_scattered_create(o, &p->variation.joints, &p->nodes)
                              : pdmc_lattice_create(o, &p->variation.joints, &p->nodes));
    PDMC_TRY(check_nodes(o, &p->nodes));
    PDMC_TRY(count_interfaces(o, p));
    PDMC_TRY(pdmc_variation_create(o, &p->nodes, p->laws, &p->variation));
    PDMC_TRY(choose_step(o, p));
    PDMC_TRY(make_room(o, p));
    PDMC_TRY(pdmc_nodes_cut(&p->nodes, o->crack_count, o->cracks));
    PDMC_TRY(pdmc_damping_create(o, &p->nodes, &p->damping));
    p->repulsion = repulsion_of(o);
    PDMC_TRY(pdmc_contact_create(o, &p->nodes, p->repulsion, &p->contact));
    for (int c = 0; c < o->condition_count; c++) {
        p->layer_count++;
        PDMC_TRY(pdmc_layer_create(&o->conditions[c], &p->nodes, p->density, &p->layers[c]));
        if (p->layers[c].count == 0) PDMC_FAIL(PDMC_ERR_ARG, "conditions[%d]: holds no node", c);
    }
    p->kernels = pdmc_forces_choose();
    p->is_single = o->precision == PDMC_PRECISION_SINGLE;
    if (p->is_single) PDMC_TRY(pdmc_single_create(&p->nodes, p->variation.stiffness, &p->single));
    hold_nodes(p);
    start_nodes(o, p);
    start_spheres(o, p);
    PDMC_TRY(pdmc_particles_start(p));
done:
    return status;
}

pdmc_status pdmc_particles_create(const pdmc_particles_options *options, pdmc_particles **particles)
{
    pdmc_status status = PDMC_OK;
    pdmc_particles *p = NULL;
    PDMC_REQUIRE(particles, "particles: NULL");
    *particles = NULL;
    status = check(options);
    if (status != PDMC_OK) return status;
    PDMC_NEW(p, 1);
    PDMC_TRY(create(options, p));
    *particles = p;
    p = NULL;
done:
    pdmc_particles_destroy(p);
    return status;
}

void pdmc_particles_destroy(pdmc_particles *p)
{
    if (!p) return;
    pdmc_nodes_clear(&p->nodes);
    pdmc_contact_clear(&p->contact);
    pdmc_damping_clear(&p->damping);
    pdmc_rest_clear(&p->rest);
    pdmc_variation_clear(&p->variation);
    pdmc_single_clear(&p->single);
    for (int k = 0; k < p->layer_count; k++) pdmc_layer_clear(&p->layers[k]);
    for (int a = 0; a < PDMC_AXES; a++) {
        pdmc_free(p->position[a]);
        pdmc_free(p->velocity[a]);
        pdmc_free(p->force[a]);
    }
    void *const others[] = {p->density,  p->laws,         p->held,           p->strength,       p->next_strength,
                            p->fracture, p->elastic,      p->contact_energy, p->share,          p->layers,
                            p->spheres,  p->sphere_force, p->sphere_energy,  p->interface_bonds};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) pdmc_free(others[k]);
    pdmc_free(p);
}
