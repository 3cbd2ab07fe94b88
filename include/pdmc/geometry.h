// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Points and segments in the plane. Pure functions, no state.

#include "pdmc/base.h"

/// True if the closed segments pq and ab share a point; touching, collinear overlap and segments of zero length count.
PDMC_API bool pdmc_segments_cross(const double p[2], const double q[2], const double a[2], const double b[2]);

/// Distance from the point p to the closed segment ab, in the unit of the coordinates.
PDMC_API double pdmc_point_segment_distance(const double p[2], const double a[2], const double b[2]);
