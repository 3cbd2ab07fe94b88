// SPDX-License-Identifier: GPL-3.0-or-later

/// Bonds between materials and between bodies.

#include "study/study_impl.h"

static pdmc_status refuse(const pdmc_study_reader *reader, int index, const char *key, const char *what)
{
    return pdmc_study_refuse(reader, (pdmc_study_address){SECTION_INTERFACES, index, key}, "%s", what);
}

static bool are_alike(int a, int b, int c, int d)
{
    return (a == c && b == d) || (a == d && b == c);
}

static bool is_between_the_same(const pdmc_explicit_interface *i, const pdmc_explicit_interface *j)
{
    if (i->between != j->between) return false;
    if (i->between == PDMC_BETWEEN_BODIES)
        return are_alike(i->first_body, i->second_body, j->first_body, j->second_body);
    return are_alike(i->first_material, i->second_material, j->first_material, j->second_material);
}

static pdmc_status check_interface(const pdmc_study_reader *reader, int index)
{
    const pdmc_explicit_interface *interfaces = reader->motion->interfaces, *i = &interfaces[index];
    if (i->between == PDMC_BETWEEN_BODIES && i->first_body == i->second_body)
        return refuse(reader, index, "second_body", "is the first body too, must be another");
    for (int j = 0; j < index; j++)
        if (is_between_the_same(i, &interfaces[j]))
            return refuse(reader, index, NULL, "is between the same two as an earlier one, must be between others");
    if (i->bonds.has_youngs_modulus && i->bonds.has_micromodulus)
        return refuse(reader, index, "micromodulus", "is given beside youngs_modulus, must be one of the two or none");
    if (i->bonds.has_fracture_energy && i->bonds.has_critical_stretch)
        return refuse(reader, index, "critical_stretch",
                      "is given beside fracture_energy, must be one of the two or none");
    return PDMC_OK;
}

pdmc_status pdmc_study_check_interfaces(const pdmc_study_reader *reader)
{
    pdmc_status status = pdmc_study_check_names(reader, SECTION_INTERFACES, "interface");
    for (int i = 0; i < reader->motion->interface_count && status == PDMC_OK; i++) status = check_interface(reader, i);
    return status;
}
