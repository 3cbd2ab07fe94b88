// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/base_impl.h"
#include "results/whole_file.h"
#include "views/views_impl.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

const char *pdmc_measure_title(pdmc_measure measure)
{
    return measure == PDMC_MEASURE_BOND ? "bond" : "Griffith";
}

int pdmc_nearest_angle(const pdmc_results *results, double angle)
{
    int best = -1;
    for (int k = 0; k < results->angle_count; k++)
        if (best < 0 || cos(results->angles[k] - angle) > cos(results->angles[best] - angle)) best = k;
    return best;
}

size_t pdmc_place(const pdmc_results *results, int tip, int angle)
{
    return (size_t)tip * (size_t)results->angle_count + (size_t)angle;
}

double pdmc_degrees_around(double angle, double centre)
{
    const double turn = remainder((angle - centre) * pdmc_degrees, 360.0);
    return centre * pdmc_degrees + (turn <= -180.0 ? 180.0 : turn);
}

double pdmc_balance_error(const pdmc_motion_record *m)
{
    double error = 0.0, work = 0.0;
    for (int i = 0; i < m->time_count; i++) {
        error = fmax(error, fabs(m->work[i] - m->kinetic[i] - m->elastic[i] - m->dissipated[i]));
        work = fmax(work, fabs(m->work[i]));
    }
    return work > 0.0 ? error / work : NAN;
}

const char *pdmc_face_name(int face)
{
    static const char *const names[] = {
        [PDMC_FACE_NONE] = "none", [PDMC_FACE_LEFT] = "left", [PDMC_FACE_RIGHT] = "right"};
    return names[face];
}

const double *pdmc_probe_displacement(const pdmc_motion_record *motion, int time, int probe)
{
    return &motion->displacement[2 * ((size_t)time * (size_t)motion->probe_count + (size_t)probe)];
}

pdmc_status pdmc_locale_plain(pdmc_locale *locale)
{
    *locale = (pdmc_locale){.plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0)};
    if (!locale->plain) return pdmc_raise(PDMC_ERR_NOMEM, "out of memory for a locale");
    locale->before = uselocale(locale->plain);
    return PDMC_OK;
}

void pdmc_locale_restore(pdmc_locale *locale)
{
    if (!locale->plain) return;
    uselocale(locale->before);
    freelocale(locale->plain);
    *locale = (pdmc_locale){0};
}

pdmc_status pdmc_folder_make(const char *folder)
{
    struct stat properties;
    if (stat(folder, &properties) == 0)
        return S_ISDIR(properties.st_mode) ? PDMC_OK
                                           : pdmc_raise(PDMC_ERR_CREATE, "%s: is a file, not a folder", folder);
    return mkdir(folder, 0777) == 0 ? PDMC_OK : pdmc_raise_errno(folder, errno);
}

char *pdmc_folder_path(const char *folder, const char *name)
{
    const size_t size = strlen(folder) + strlen(name) + 2;
    char *path = pdmc_calloc(size, 1);
    if (path) snprintf(path, size, "%s/%s", folder, name);
    return path;
}
