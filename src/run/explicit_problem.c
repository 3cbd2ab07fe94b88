// SPDX-License-Identifier: GPL-3.0-or-later

/// From a problem of explicit dynamics to what the engine takes, and to what it will amount to.

#include "pdmc/explicit.h"

#include "base/base_impl.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

static double poissons_ratio(const pdmc_explicit *problem)
{
    return problem->dimension == 3 ? 0.25 : pdmc_poissons_ratio(problem->assumption);
}

static bool has_modulus(const pdmc_explicit_material *m)
{
    return m->has_micromodulus || m->has_youngs_modulus || m->has_bulk_modulus;
}

static double micromodulus(const pdmc_explicit *p, const pdmc_explicit_material *m)
{
    if (m->has_micromodulus) return m->micromodulus;
    const double youngs =
        m->has_youngs_modulus ? m->youngs_modulus : 3.0 * m->bulk_modulus * (1.0 - 2.0 * poissons_ratio(p));
    return pdmc_brittle_micromodulus(p->dimension, p->assumption, youngs, p->horizon, p->thickness);
}

static double critical_stretch(const pdmc_explicit *p, const pdmc_explicit_material *m)
{
    if (m->has_critical_stretch) return m->critical_stretch;
    if (!m->has_fracture_energy) return INFINITY;
    return pdmc_brittle_critical_stretch(p->dimension, m->fracture_energy, micromodulus(p, m), p->horizon,
                                         p->thickness);
}

pdmc_brittle_material pdmc_explicit_law(const pdmc_explicit *problem, const pdmc_explicit_material *material)
{
    pdmc_brittle_material law = {
        .density = material->density,
        .micromodulus = micromodulus(problem, material),
        .critical_stretch = critical_stretch(problem, material),
        .strengthening = material->strengthening,
        .fibre = {material->fibre[0], material->fibre[1], material->fibre[2]},
        .fibre_ratio = material->fibre_ratio,
    };
    memcpy(law.name, material->name, sizeof law.name);
    return law;
}

// The share of its volume by which a neighbour counts.
static double share_of(const pdmc_explicit *p, double length)
{
    const double beyond = (length - p->horizon) / p->spacing;
    if (p->volume_rule != PDMC_VOLUME_PARTIAL && beyond > 1e-9) return 0.0;
    return p->volume_rule == PDMC_VOLUME_WHOLE ? 1.0 : fmax(0.0, fmin(1.0, 0.5 - beyond));
}

// Over the neighbours of a node inside a body: their number, and the sums of their shares, as they are and over |xi|.
typedef struct {
    double count, shares, inverse_lengths;
} neighbour_sums;

static neighbour_sums sum_neighbours(const pdmc_explicit *p)
{
    const double h = p->spacing;
    const int reach = (int)(p->horizon / h + 0.5 + 1e-9), depth = p->dimension == 3 ? reach : 0;
    neighbour_sums sums = {0};
    for (int k = -depth; k <= depth; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const double length = h * sqrt((double)(i * i + j * j + k * k));
                const double share = length > 0.0 ? share_of(p, length) : 0.0;
                if (share < 1e-9) continue;
                sums.count += 1.0;
                sums.shares += share;
                sums.inverse_lengths += share / length;
            }
    return sums;
}

// By which fibres raise the sum of c over |xi|: beta^2 is 1 / dimension in the mean over a grid.
static double fibres_stiffen(const pdmc_explicit *p, const pdmc_explicit_material *m)
{
    const bool has_fibres = m->fibre[0] != 0.0 || m->fibre[1] != 0.0 || m->fibre[2] != 0.0;
    return has_fibres ? fmax(1.0, 1.0 + (m->fibre_ratio - 1.0) / p->dimension) : 1.0;
}

bool pdmc_explicit_has_joints(const pdmc_explicit *p)
{
    for (int i = 0; i < p->body_count; i++)
        if (p->bodies[i].body.is_part) return true;
    return p->interface_count > 0;
}

// As of eq. 46 with c over the density, and what of c fibres add.
static double step_of(const pdmc_explicit *p, const neighbour_sums *sums, double by_density, double fibres)
{
    const double volume = p->dimension == 3 ? gsl_pow_3(p->spacing) : gsl_pow_2(p->spacing) * p->thickness;
    const double square = 2.0 * volume * by_density * sums->inverse_lengths * fibres;
    const double rate = 2.0 * volume * by_density * p->bond_damping * sums->shares;
    return (sqrt(rate * rate + 4.0 * square) - rate) / square; // see pdmc_particles_stable_step()
}

// Of the stiffest of all bonds on the lightest of all nodes, which may meet at an interface.
static double least_stable_step(const pdmc_explicit *p, const neighbour_sums *sums)
{
    double stiffest = 0.0, lightest = INFINITY, fibres = 1.0;
    for (int i = 0; i < p->material_count; i++) {
        stiffest = fmax(stiffest, micromodulus(p, &p->materials[i]));
        lightest = fmin(lightest, p->materials[i].density);
        fibres = fmax(fibres, fibres_stiffen(p, &p->materials[i]));
    }
    for (int i = 0; i < p->interface_count; i++)
        if (has_modulus(&p->interfaces[i].bonds)) stiffest = fmax(stiffest, micromodulus(p, &p->interfaces[i].bonds));
    return step_of(p, sums, stiffest / lightest, fibres);
}

static double stable_step(const pdmc_explicit *p, const neighbour_sums *sums)
{
    double step = INFINITY;
    if (pdmc_explicit_has_joints(p)) return least_stable_step(p, sums);
    for (int i = 0; i < p->material_count; i++) {
        const pdmc_explicit_material *m = &p->materials[i];
        step = fmin(step, step_of(p, sums, micromodulus(p, m) / m->density, fibres_stiffen(p, m)));
    }
    return step;
}

double pdmc_explicit_stable_step(const pdmc_explicit *problem)
{
    const neighbour_sums sums = sum_neighbours(problem);
    return stable_step(problem, &sums);
}

pdmc_explicit_amounts pdmc_explicit_count(const pdmc_explicit *problem)
{
    double nodes = 0.0;
    for (int i = 0; i < problem->body_count; i++) nodes += pdmc_explicit_nodes(problem, &problem->bodies[i].body);
    const neighbour_sums sums = sum_neighbours(problem);
    if (problem->load_steps > 0)
        return (pdmc_explicit_amounts){.nodes = nodes, .bonds = 0.5 * sums.count * nodes, .steps = problem->load_steps};
    const double step = problem->has_step ? problem->step : problem->safety * stable_step(problem, &sums);
    return (pdmc_explicit_amounts){
        .nodes = nodes, .bonds = 0.5 * sums.count * nodes, .steps = ceil(problem->duration / step * (1.0 - 1e-9))};
}

// What the engine takes, of lists that the study gives in another form.
typedef struct {
    pdmc_brittle_material *materials;
    pdmc_body *bodies;
    pdmc_layer_condition *conditions;
    pdmc_rigid_sphere *spheres;
    pdmc_interface *interfaces;
} lists;

static void drop_lists(lists *l)
{
    pdmc_free(l->materials);
    pdmc_free(l->bodies);
    pdmc_free(l->conditions);
    pdmc_free(l->spheres);
    pdmc_free(l->interfaces);
}

static const pdmc_explicit_sample as_it_is = {
    .load = 1.0, .velocity = 1.0, .youngs_modulus = 1.0, .fracture_energy = 1.0};

static pdmc_brittle_material material_of(const pdmc_explicit *p, const pdmc_explicit_material *m,
                                         const pdmc_explicit_sample *sample)
{
    pdmc_brittle_material law = pdmc_explicit_law(p, m);
    law.micromodulus *= sample->youngs_modulus;
    law.critical_stretch *= sqrt(sample->fracture_energy);
    if (m->has_fracture_energy) law.critical_stretch /= sqrt(sample->youngs_modulus);
    law.strengths = sample->bond_strengths;
    return law;
}

// The materials on both sides of an interface.
static void sides_of(const pdmc_explicit *p, const pdmc_explicit_interface *i, int sides[2])
{
    const bool of_bodies = i->between == PDMC_BETWEEN_BODIES;
    sides[0] = of_bodies ? p->bodies[i->first_body].body.material : i->first_material;
    sides[1] = of_bodies ? p->bodies[i->second_body].body.material : i->second_material;
}

// What the engine takes where an interface has no modulus; see pdmc_interface.
static double mean_micromodulus(const pdmc_explicit *p, const pdmc_explicit_interface *i)
{
    int sides[2];
    sides_of(p, i, sides);
    return 2.0 / (1.0 / micromodulus(p, &p->materials[sides[0]]) + 1.0 / micromodulus(p, &p->materials[sides[1]]));
}

static pdmc_interface interface_of(const pdmc_explicit *p, const pdmc_explicit_interface *i,
                                   const pdmc_explicit_sample *sample)
{
    pdmc_explicit_material bonds = i->bonds;
    const bool of_bodies = i->between == PDMC_BETWEEN_BODIES, has_own = has_modulus(&bonds);
    pdmc_interface interface = {.of_bodies = of_bodies,
                                .first = of_bodies ? i->first_body : i->first_material,
                                .second = of_bodies ? i->second_body : i->second_material};
    if (!has_own) bonds.has_micromodulus = true, bonds.micromodulus = mean_micromodulus(p, i);
    const pdmc_brittle_material law = material_of(p, &bonds, sample);
    if (has_own) interface.micromodulus = law.micromodulus;
    if (isfinite(law.critical_stretch)) interface.critical_stretch = law.critical_stretch;
    memcpy(interface.name, bonds.name, sizeof interface.name);
    return interface;
}

// Without times a condition is constant in a motion, and grows evenly with the load otherwise.
static pdmc_history default_history(const pdmc_explicit *p)
{
    static const double start = 0.0, always = 1.0, ramp[] = {0.0, 1.0};
    if (p->load_steps == 0) return (pdmc_history){1, &start, &always};
    return (pdmc_history){2, p->load_ends, ramp};
}

static pdmc_layer_condition condition_of(const pdmc_explicit *p, const pdmc_explicit_condition *c,
                                         const pdmc_explicit_sample *sample)
{
    pdmc_layer_condition layer = c->layer;
    if (layer.history.count == 0) layer.history = default_history(p);
    for (int k = 0; k < PDMC_AXES; k++) {
        layer.value[k] *= sample->load;
        for (int j = 0; j < PDMC_AXES; j++) layer.gradient[k][j] *= sample->load;
    }
    return layer;
}

// At rest a sphere's velocity is its way in a unit of the load.
static pdmc_rigid_sphere sphere_of(const pdmc_explicit *p, const pdmc_explicit_sphere *s,
                                   const pdmc_explicit_sample *sample)
{
    pdmc_rigid_sphere sphere = s->sphere;
    for (int k = 0; k < PDMC_AXES; k++)
        sphere.velocity[k] = p->load_steps > 0 ? s->displacement[k] / p->load_ends[1] * sample->load
                                               : s->sphere.velocity[k] * sample->velocity;
    if (!s->has_mass) sphere.mass = INFINITY;
    return sphere;
}

static pdmc_status fill_lists(const pdmc_explicit *p, const pdmc_explicit_sample *sample, lists *l)
{
    pdmc_status status = PDMC_OK;
    PDMC_NEW(l->materials, p->material_count);
    PDMC_NEW(l->bodies, p->body_count);
    PDMC_NEW(l->conditions, p->condition_count);
    PDMC_NEW(l->spheres, p->sphere_count);
    PDMC_NEW(l->interfaces, p->interface_count);
    for (int i = 0; i < p->material_count; i++) l->materials[i] = material_of(p, &p->materials[i], sample);
    for (int i = 0; i < p->interface_count; i++) l->interfaces[i] = interface_of(p, &p->interfaces[i], sample);
    for (int i = 0; i < p->condition_count; i++) l->conditions[i] = condition_of(p, &p->conditions[i], sample);
    for (int i = 0; i < p->body_count; i++) {
        l->bodies[i] = p->bodies[i].body;
        for (int k = 0; k < PDMC_AXES; k++) l->bodies[i].velocity[k] *= sample->velocity;
    }
    for (int i = 0; i < p->sphere_count; i++) l->spheres[i] = sphere_of(p, &p->spheres[i], sample);
done:
    return status;
}

static pdmc_particles_options options_of(const pdmc_explicit *p, const pdmc_explicit_sample *sample, const lists *l,
                                         int threads)
{
    return (pdmc_particles_options){
        .dimension = p->dimension,
        .spacing = p->spacing,
        .offset = {p->offset[0], p->offset[1], p->offset[2]},
        .thickness = p->thickness,
        .horizon = p->horizon,
        .volume_rule = p->volume_rule,
        .linear_stretch = p->stretch == PDMC_STRETCH_LINEAR,
        .precision = p->precision,
        .no_fail_count = p->no_fail_count,
        .no_fail = p->no_fail,
        .contact_distance = p->contact_distance,
        .contact_stiffness = p->contact_stiffness,
        .material_count = p->material_count,
        .body_count = p->body_count,
        .crack_count = p->crack_count,
        .condition_count = p->condition_count,
        .sphere_count = p->sphere_count,
        .interface_count = p->interface_count,
        .materials = l->materials,
        .bodies = l->bodies,
        .cracks = p->cracks,
        .conditions = l->conditions,
        .spheres = l->spheres,
        .interfaces = l->interfaces,
        .factor_count = sample->node_count,
        .stiffness_factors = sample->stiffness,
        .strength_factors = sample->strength,
        .seed = sample->seed,
        .sample = sample->sample,
        .damping = p->damping,
        .bond_damping = p->bond_damping,
        .step = p->has_step ? p->step : 0.0,
        .safety = p->load_steps > 0 ? 1.0 : p->safety, // of the steps that nothing at rest takes
        .threads = threads,
    };
}

// By the names of the study's settings; lists have the same ones.
static pdmc_status refuse(const char *message)
{
    const bool is_step = strncmp(message, "step: ", strlen("step: ")) == 0;
    return pdmc_raise(PDMC_ERR_CONFIG, "%s%s", is_step ? "time." : "", message);
}

pdmc_status pdmc_explicit_sample_particles(const pdmc_explicit *problem, const pdmc_explicit_sample *sample,
                                           int threads, pdmc_particles **particles)
{
    pdmc_status status = PDMC_OK;
    lists l = {0};
    *particles = NULL;
    PDMC_TRY(fill_lists(problem, sample, &l));
    const pdmc_particles_options options = options_of(problem, sample, &l, threads);
    status = pdmc_particles_create(&options, particles);
    if (status == PDMC_ERR_ARG) status = refuse(pdmc_last_error());
done:
    drop_lists(&l);
    return status;
}

pdmc_status pdmc_explicit_particles(const pdmc_explicit *problem, int threads, pdmc_particles **particles)
{
    return pdmc_explicit_sample_particles(problem, &as_it_is, threads, particles);
}
