// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/table.h"

#include <math.h>

// When a probe is farthest from where it is at rest.
static int farthest(const pdmc_motion_record *m, int probe)
{
    int best = 0;
    double most = -1.0;
    for (int i = 0; i < m->time_count; i++) {
        const double *u = pdmc_probe_displacement(m, i, probe), distance = hypot(u[0], u[1]);
        if (distance > most) most = distance, best = i;
    }
    return best;
}

static void print_probe(const pdmc_motion_record *m, int p, FILE *stream)
{
    char n[8][PDMC_BRIEF_SIZE], text[PDMC_LINE_SIZE];
    const pdmc_probe_record *probe = &m->probes[p];
    const int most = farthest(m, p);
    const double *end = pdmc_probe_displacement(m, m->time_count - 1, p), *far = pdmc_probe_displacement(m, most, p);
    fprintf(stream, "  %-15.15s %-6s %9s %9s %10s %10s %10s %10s %9s\n", pdmc_one_line(text, probe->name),
            probe->face == PDMC_FACE_NONE ? "" : pdmc_face_name(probe->face), pdmc_brief(n[0], probe->position[0]),
            pdmc_brief(n[1], probe->position[1]), pdmc_brief(n[2], end[0]), pdmc_brief(n[3], end[1]),
            pdmc_brief(n[4], far[0]), pdmc_brief(n[5], far[1]), pdmc_brief(n[6], m->time[most]));
}

static void print_probes(const pdmc_results *r, FILE *stream)
{
    char length[PDMC_LINE_SIZE], time[PDMC_LINE_SIZE];
    if (r->motion.probe_count == 0) return;
    fprintf(stream, "\nprobes, in %.20s and %.20s\n", pdmc_one_line(length, r->length_unit),
            pdmc_one_line(time, r->time_unit));
    fprintf(stream, "  %-15s %-6s %9s %9s %10s %10s %10s %10s %9s\n", "", "face", "x", "y", "last u_x", "last u_y",
            "most u_x", "most u_y", "at time");
    for (int p = 0; p < r->motion.probe_count; p++) print_probe(&r->motion, p, stream);
}

void pdmc_table_motion(const pdmc_results *r, FILE *stream)
{
    char unit[PDMC_UNIT_SIZE], n[6][PDMC_BRIEF_SIZE], text[2][PDMC_LINE_SIZE];
    const pdmc_motion_record *m = &r->motion;
    const int last = m->time_count - 1;
    pdmc_results_unit(r, PDMC_UNIT_WORK, sizeof unit, unit);
    fprintf(stream, "  a motion of %d time steps\n", last < 0 ? 0 : last);
    if (last < 0) return;
    fprintf(stream, "\nat %s %.20s, load factor %s\n", pdmc_brief(n[0], m->time[last]),
            pdmc_one_line(text[0], r->time_unit), pdmc_brief(n[1], m->load_factor[last]));
    fprintf(stream, "  work %s = kinetic %s + elastic %s + dissipated %s %.20s\n", pdmc_brief(n[2], m->work[last]),
            pdmc_brief(n[3], m->kinetic[last]), pdmc_brief(n[4], m->elastic[last]),
            pdmc_brief(n[5], m->dissipated[last]), pdmc_one_line(text[1], unit));
    fprintf(stream, "  the balance of energy is off by %s of the largest work at most\n",
            pdmc_brief(n[0], pdmc_balance_error(m)));
    print_probes(r, stream);
}
