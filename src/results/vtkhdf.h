// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/h5.h"

/// Lets ParaView and VTK (9.3 and later) open the result file of an explicit study: adds the group /VTKHDF of the VTKHDF
/// file format, version 2.0 (docs.vtk.org, "VTKHDF format specification"), an unstructured grid with a vertex for every node
/// and the snapshots as its steps in time. Nodes and snapshots are links to the file's own datasets.
pdmc_status pdmc_vtkhdf_write(hid_t file, const pdmc_explicit_record *record);
