// SPDX-License-Identifier: GPL-3.0-or-later

/// The comparison of rules for integrals over the horizon, and its defaults that rest on other settings.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

enum { MOST_RATIOS = 100 };

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_QUADRATURE, -1, key};
}

static bool is_given(const pdmc_study_reader *reader, const char *key)
{
    const config_setting_t *group =
        config_setting_get_member(reader->root, pdmc_study_sections[SECTION_QUADRATURE].name);
    return group && config_setting_get_member(group, key);
}

static pdmc_status default_ratios(pdmc_horizon_study *q)
{
    static const double ratios[] = {3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    q->ratios = pdmc_calloc(sizeof ratios / sizeof ratios[0], sizeof *q->ratios);
    if (!q->ratios) return PDMC_ERR_NOMEM;
    memcpy(q->ratios, ratios, sizeof ratios);
    q->ratio_count = (int)(sizeof ratios / sizeof ratios[0]);
    return PDMC_OK;
}

static pdmc_status check_stress(const pdmc_study_reader *reader)
{
    const pdmc_horizon_study *q = reader->quadrature;
    static const char *const out_of_plane[] = {"zz", "yz", "zx"};
    bool is_zero = true;
    for (int c = 0; c < PDMC_STRESS_COMPONENTS; c++) is_zero &= q->stress[c] == 0.0;
    if (is_zero)
        return pdmc_study_refuse(reader, at(NULL), "has no stress, one of xx, yy, zz, yz, zx, xy must not be zero");
    for (int c = 0; c < 3 && q->dimension == 2; c++)
        if (q->stress[2 + c] != 0.0)
            return pdmc_study_refuse(reader, at(out_of_plane[c]), "is %g, must be 0 in two dimensions",
                                     q->stress[2 + c]);
    return PDMC_OK;
}

pdmc_status pdmc_study_check_quadrature(const pdmc_study_reader *reader)
{
    pdmc_horizon_study *q = reader->quadrature;
    pdmc_status status = q->ratio_count == 0 ? default_ratios(q) : PDMC_OK;
    if (status != PDMC_OK) return status;
    if (q->ratio_count > MOST_RATIOS)
        return pdmc_study_refuse(reader, at("ratios"), "has %d, must have at most %d", q->ratio_count, MOST_RATIOS);
    for (int i = 1; i < q->ratio_count; i++)
        if (q->ratios[i] <= q->ratios[i - 1])
            return pdmc_study_refuse(reader, at("ratios"), "%g follows %g, must ascend", q->ratios[i],
                                     q->ratios[i - 1]);
    if (q->integral == PDMC_INTEGRAL_STRESS && !is_given(reader, "start")) q->start = 2;
    if (q->start > q->most)
        return pdmc_study_refuse(reader, at("start"), "%d is too large, must be at most %d, the most", q->start,
                                 q->most);
    return q->integral == PDMC_INTEGRAL_STRESS ? check_stress(reader) : PDMC_OK;
}
