// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/table.h"

#include "views/explicit.h"

#include <math.h>

static void print_loads(const pdmc_explicit_record *p, FILE *stream)
{
    double residual = 0.0, breakages = 0.0;
    for (int i = 0; i < p->record_count; i++) {
        residual = fmax(residual, p->residual[i]);
        breakages += p->breakages[i];
    }
    fprintf(stream,
            "  %d loads, residuals up to %.2g; %.0f steps of relaxation; bonds broke %.0f times\n  forces by %.12s\n",
            p->record_count - 1, residual, p->steps, breakages, p->kernel);
}

static void print_grid(const pdmc_results *r, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[3][PDMC_BRIEF_SIZE], length[PDMC_LINE_SIZE], time[PDMC_LINE_SIZE];
    fprintf(stream, "  %d nodes and %.0f bonds in %s, spacing %s, horizon %s %.20s\n", p->node_count, p->bonds,
            p->dimension == 2 ? "the plane" : "space", pdmc_brief(n[0], p->spacing), pdmc_brief(n[1], p->horizon),
            pdmc_one_line(length, r->length_unit));
    if (pdmc_is_at_rest(p)) {
        print_loads(p, stream);
        return;
    }
    fprintf(stream, "  %.0f steps of %s %.20s, %.3g of the largest stable one; forces by %.12s\n", p->steps,
            pdmc_brief(n[2], p->step), pdmc_one_line(time, r->time_unit), p->step / p->stable_step, p->kernel);
}

static void print_energies(const pdmc_results *r, int last, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char unit[PDMC_UNIT_SIZE], n[6][PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    fprintf(stream, "\nat %s %.20s\n", pdmc_brief(n[0], p->time[last]),
            pdmc_is_at_rest(p) ? "of the load" : pdmc_one_line(text[0], r->time_unit));
    fprintf(stream, "  first %s + work %s = kinetic %s + elastic %s + fracture %s + contact %s %.20s\n",
            pdmc_brief(n[0], p->first), pdmc_brief(n[1], p->work[last]), pdmc_brief(n[2], p->kinetic[last]),
            pdmc_brief(n[3], p->elastic[last]), pdmc_brief(n[4], p->fracture[last]), pdmc_brief(n[5], p->contact[last]),
            pdmc_one_line(text[1], unit));
    if (p->dissipated[last] != 0.0)
        fprintf(stream, "  and dissipated %s%s\n", pdmc_brief(n[0], p->dissipated[last]),
                pdmc_is_at_rest(p) ? ", where bonds broke" : " by damping");
    fprintf(stream, "  the balance of energy is off by %s of the largest energy at most\n",
            pdmc_brief(n[0], pdmc_explicit_balance_error(p)));
    if (p->compared_count > 0)
        fprintf(stream, "  single precision changes no force by more than %s of the largest one\n",
                pdmc_brief(n[0], pdmc_explicit_force_error(p)));
    fprintf(stream, "  %.0f bonds are broken, the mean damage is %.6g\n", p->broken[last], p->mean_damage[last]);
}

static void print_fragments(const pdmc_results *r, int last, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[PDMC_BRIEF_SIZE], unit[PDMC_UNIT_SIZE], text[PDMC_LINE_SIZE];
    if (p->fragments[last] + p->loose_nodes[last] < 2.0) return;
    pdmc_results_unit(r, PDMC_UNIT_MASS, sizeof unit, unit);
    fprintf(stream, "  %.0f pieces of two nodes or more, the largest of %s %.20s; %.0f nodes without bonds\n",
            p->fragments[last], pdmc_brief(n, p->largest_fragment[last]), pdmc_one_line(text, unit),
            p->loose_nodes[last]);
}

static void print_tips_at_rest(const pdmc_results *r, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[5][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    fprintf(stream, "\ntips, in %.20s; a tip is where the damage exceeds %.3g; begin and end are loads\n",
            pdmc_one_line(text, r->length_unit), p->tip_damage);
    fprintf(stream, "  %-20s %10s %10s %10s %10s %10s\n", "", "x", "y", "growth", "begins", "ends");
    for (int t = 0; t < p->tip_count; t++) {
        const pdmc_tip_growth g = pdmc_results_growth(p, t);
        fprintf(stream, "  %-20.20s %10s %10s %10s %10s %10s\n", pdmc_one_line(text, p->tips[t].name),
                pdmc_brief(n[0], p->tips[t].position[0]), pdmc_brief(n[1], p->tips[t].position[1]),
                pdmc_brief(n[2], g.growth), pdmc_brief(n[3], g.begin), pdmc_brief(n[4], g.end));
    }
}

static void print_tips(const pdmc_results *r, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[7][PDMC_BRIEF_SIZE], length[PDMC_LINE_SIZE], time[PDMC_LINE_SIZE];
    if (p->tip_count == 0) return;
    if (pdmc_is_at_rest(p)) {
        print_tips_at_rest(r, stream);
        return;
    }
    fprintf(stream, "\ntips, in %.20s and %.20s; a tip is where the damage exceeds %.3g; speeds over %s\n",
            pdmc_one_line(length, r->length_unit), pdmc_one_line(time, r->time_unit), p->tip_damage,
            pdmc_brief(n[0], p->speed_window));
    fprintf(stream, "  %-20s %10s %10s %10s %10s %10s %11s %10s\n", "", "x", "y", "growth", "begins", "ends",
            "mean speed", "most");
    for (int t = 0; t < p->tip_count; t++) {
        const pdmc_tip_growth g = pdmc_results_growth(p, t);
        fprintf(stream, "  %-20.20s %10s %10s %10s %10s %10s %11s %10s\n", pdmc_one_line(length, p->tips[t].name),
                pdmc_brief(n[0], p->tips[t].position[0]), pdmc_brief(n[1], p->tips[t].position[1]),
                pdmc_brief(n[2], g.growth), pdmc_brief(n[3], g.begin), pdmc_brief(n[4], g.end),
                pdmc_brief(n[5], g.mean_speed), pdmc_brief(n[6], g.most_speed));
    }
}

static void print_spheres(const pdmc_results *r, int last, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[6][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    if (p->sphere_count == 0) return;
    const bool rests = pdmc_is_at_rest(p);
    fprintf(stream, "\nspheres %32s %32s\n", "centre", rests ? "force" : "velocity");
    for (int s = 0; s < p->sphere_count; s++) {
        const double *x = pdmc_of_sphere(p, p->sphere_centre, last, s);
        const double *v = pdmc_of_sphere(p, rests ? p->sphere_force : p->sphere_velocity, last, s);
        fprintf(stream, "  %-15.15s %10s %10s %10s %12s %10s %10s\n", pdmc_one_line(text, p->spheres[s].name),
                pdmc_brief(n[0], x[0]), pdmc_brief(n[1], x[1]), pdmc_brief(n[2], x[2]), pdmc_brief(n[3], v[0]),
                pdmc_brief(n[4], v[1]), pdmc_brief(n[5], v[2]));
    }
}

static void print_largest_force(const pdmc_explicit_record *p, int c, FILE *stream)
{
    char n[4][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    double force;
    const int at = pdmc_results_largest_force(p, c, &force);
    const double between = pdmc_results_force_between(p, c);
    fprintf(stream, "  %-15.15s largest force %s at the displacement %s, load %s",
            pdmc_one_line(text, p->conditions[c].name), pdmc_brief(n[0], force),
            pdmc_brief(n[1], pdmc_norm_of(pdmc_of_condition(p, p->condition_displacement, at, c))),
            pdmc_brief(n[2], p->time[at]));
    if (between > force * (1.0 + 1e-6)) fprintf(stream, "; between loads up to %s", pdmc_brief(n[3], between));
    fputc('\n', stream);
}

static void print_conditions(const pdmc_results *r, int last, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    char n[6][PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    if (p->condition_count == 0) return;
    fprintf(stream, "\nconditions, %.20s and %.20s %16s %32s\n", pdmc_one_line(text[0], r->force_unit),
            pdmc_one_line(text[1], r->length_unit), "force", "mean displacement");
    for (int c = 0; c < p->condition_count; c++) {
        const double *f = pdmc_of_condition(p, p->condition_force, last, c);
        const double *u = pdmc_of_condition(p, p->condition_displacement, last, c);
        fprintf(stream, "  %-15.15s %10s %10s %10s %12s %10s %10s\n", pdmc_one_line(text[0], p->conditions[c].name),
                pdmc_brief(n[0], f[0]), pdmc_brief(n[1], f[1]), pdmc_brief(n[2], f[2]), pdmc_brief(n[3], u[0]),
                pdmc_brief(n[4], u[1]), pdmc_brief(n[5], u[2]));
    }
    for (int c = 0; c < p->condition_count && pdmc_is_at_rest(p); c++) print_largest_force(p, c, stream);
}

static void print_interfaces(const pdmc_explicit_record *p, int last, FILE *stream)
{
    char n[PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    if (p->interface_count == 0) return;
    fprintf(stream, "\ninterfaces %21s %12s %12s\n", "bonds", "broken", "a share of");
    for (int k = 0; k < p->interface_count; k++) {
        const double broken = pdmc_of_interface(p, p->interface_broken, last, k), bonds = p->interfaces[k].bonds;
        fprintf(stream, "  %-15.15s %14.0f %12.0f %12s\n", pdmc_one_line(text, p->interfaces[k].name), bonds, broken,
                pdmc_brief(n, broken / bonds));
    }
}

void pdmc_table_explicit(const pdmc_results *r, FILE *stream)
{
    const pdmc_explicit_record *p = &r->particles;
    const int last = p->record_count - 1;
    print_grid(r, stream);
    if (last >= 0) {
        print_energies(r, last, stream);
        print_fragments(r, last, stream);
        print_tips(r, stream);
        print_spheres(r, last, stream);
        print_conditions(r, last, stream);
        print_interfaces(p, last, stream);
    }
    fprintf(stream, "\nkept     %d records, %d snapshots of all nodes\n", p->record_count, p->snapshot_count);
    fprintf(stream, pdmc_is_at_rest(p) ? "seconds  loads %.2f, output %.2f\n" : "seconds  steps %.2f, output %.2f\n",
            r->runtime.motion, r->runtime.output);
}
