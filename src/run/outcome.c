// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/outcome.h"

#include "run/tips.h"

#include <math.h>

double pdmc_tip_reach(const pdmc_explicit *study, const pdmc_followed_tip *tip, int count, const double x[])
{
    double reach = -INFINITY;
    for (int i = 0; i < count; i++) {
        const pdmc_ahead place = pdmc_ahead_of(tip, &x[PDMC_AXES * i]);
        if (fabs(place.left) <= 2.0 * study->horizon) reach = fmax(reach, place.ahead);
    }
    return reach;
}

// The offset at a station; NaN where there is no damage near the offset before.
static double find_offset(const pdmc_explicit *study, const pdmc_explicit_record *r, const pdmc_followed_tip *tip,
                          const double damage[], double station, double before)
{
    const double half = 0.5 * r->spacing * (1.0 + 1e-9); // a node between two stations is at both
    double weight = 0.0, sum = 0.0;
    for (int i = 0; i < r->node_count; i++) {
        if (!(damage[i] > study->tip_damage)) continue;
        const pdmc_ahead place = pdmc_ahead_of(tip, &r->node_position[PDMC_AXES * i]);
        if (fabs(place.ahead - station) > half || fabs(place.left - before) > study->horizon) continue;
        weight += damage[i];
        sum += damage[i] * place.left;
    }
    return weight > 0.0 ? sum / weight : NAN;
}

int pdmc_tip_path(const pdmc_explicit *study, const pdmc_explicit_record *record, const pdmc_followed_tip *tip,
                  const double damage[], int stations, double offset[])
{
    int count = 0;
    for (int j = 0; j < stations; j++) offset[j] = NAN;
    for (double before = 0.0; count < stations; count++) {
        before = find_offset(study, record, tip, damage, count * record->spacing, before);
        if (isnan(before)) break;
        offset[count] = before;
    }
    return count;
}

pdmc_outcome pdmc_tip_outcome(const pdmc_explicit *study, const pdmc_explicit_record *r, int tip, double reach,
                              double front)
{
    const pdmc_tip_growth g = pdmc_results_growth(r, tip);
    const double end = r->time[r->record_count - 1];
    if (!(g.growth > 0.0)) return PDMC_OUTCOME_STILL;
    if (front >= reach - study->horizon) return PDMC_OUTCOME_THROUGH;
    const double window = study->load_steps > 0 ? 0.5 * study->load_ends[1] / study->load_steps : study->speed_window;
    return g.end > end - window ? PDMC_OUTCOME_RUNNING : PDMC_OUTCOME_ARRESTED;
}
