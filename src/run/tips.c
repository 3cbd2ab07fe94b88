// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/tips.h"

#include <gsl/gsl_interp.h>
#include <math.h>
#include <stdio.h>

int pdmc_tips_of(const pdmc_explicit *study, pdmc_followed_tip tips[])
{
    int count = 0;
    for (int c = 0; c < study->crack_count; c++) {
        const pdmc_planar_crack *crack = &study->cracks[c];
        if (crack->kind != PDMC_CRACK_SEGMENT) continue;
        const double length = hypot(crack->to[0] - crack->from[0], crack->to[1] - crack->from[1]);
        for (int end = 0; tips && end < 2; end++) {
            pdmc_followed_tip *tip = &tips[count + end];
            const double *here = end ? crack->to : crack->from, *there = end ? crack->from : crack->to;
            snprintf(tip->name, sizeof tip->name, "%s.%s", crack->name, end ? "to" : "from");
            for (int k = 0; k < 2; k++) {
                tip->position[k] = here[k];
                tip->direction[k] = (here[k] - there[k]) / length;
            }
        }
        count += 2;
    }
    return count;
}

double pdmc_tip_front(const pdmc_explicit *study, const pdmc_followed_tip *tip, int count, const double x[],
                      const double damage[])
{
    const double band = 2.0 * study->horizon, gap = study->horizon;
    double front = -INFINITY, before;
    do { // until none is near enough to those that are reached
        before = front;
        for (int i = 0; i < count; i++) {
            if (!(damage[i] > study->tip_damage)) continue;
            const pdmc_ahead place = pdmc_ahead_of(tip, &x[PDMC_AXES * i]);
            if (fabs(place.left) <= band && place.ahead <= fmax(0.0, front) + gap) front = fmax(front, place.ahead);
        }
    } while (front > before);
    return front;
}

static double advance_at(const pdmc_explicit_record *r, int tip, double time)
{
    const size_t last = (size_t)r->record_count - 1, tips = (size_t)r->tip_count;
    const size_t i = gsl_interp_bsearch(r->time, time, 0, last);
    const double before = r->tip_advance[i * tips + (size_t)tip];
    const double after = r->tip_advance[(i + 1) * tips + (size_t)tip];
    return before + (after - before) * (time - r->time[i]) / (r->time[i + 1] - r->time[i]);
}

void pdmc_tip_speeds(pdmc_explicit_record *r)
{
    if (r->record_count < 2) return;
    const double end = r->time[r->record_count - 1];
    for (int i = 0; i < r->record_count; i++) {
        const double from = fmax(0.0, r->time[i] - 0.5 * r->speed_window);
        const double to = fmin(end, r->time[i] + 0.5 * r->speed_window);
        for (int t = 0; t < r->tip_count; t++)
            r->tip_speed[(size_t)i * (size_t)r->tip_count + (size_t)t] =
                (advance_at(r, t, to) - advance_at(r, t, from)) / (to - from);
    }
}
