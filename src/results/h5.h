// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What we need of HDF5, with its failures carried into ours.

#include "results/layout.h"

#include <hdf5.h>

/// HDF5's own printing of errors, as it was before we switched it off.
typedef struct {
    H5E_auto2_t function;
    void *data;
} pdmc_h5_printing;

void pdmc_h5_silence(pdmc_h5_printing *before);
void pdmc_h5_restore(const pdmc_h5_printing *before);

/// Records "<what>: <the innermost message of HDF5>" and returns the status.
pdmc_status pdmc_h5_raise(pdmc_status status, const char *what);

/// Jumps to `done:` if a call of HDF5 failed.
#define PDMC_H5_TRY(call, code, what)                                                                                  \
    do {                                                                                                               \
        if ((call) < 0) {                                                                                              \
            status = pdmc_h5_raise((code), (what));                                                                    \
            goto done;                                                                                                 \
        }                                                                                                              \
    } while (0)

/// Closes whatever it is; H5I_INVALID_HID is allowed.
void pdmc_h5_close(hid_t id);

hid_t pdmc_h5_memory_type(pdmc_kind kind); // to be closed
hid_t pdmc_h5_file_type(pdmc_kind kind);   // to be closed

/// An attribute of `count` numbers, or one number where count = 0.
pdmc_status pdmc_h5_write_numbers(hid_t object, const char *name, hid_t file_type, hid_t memory_type, size_t count,
                                  const void *numbers);

/// An attribute that is a text of less than 64 kB, where the header of its object ends.
pdmc_status pdmc_h5_write_text(hid_t object, const char *name, const char *text);

/// A text of any length, so not an attribute but a dataset of its own.
pdmc_status pdmc_h5_write_document(hid_t group, const char *name, const char *text);

/// An attribute of `count` texts of variable length, as HDF5's tools want labels; we do not read them.
pdmc_status pdmc_h5_write_labels(hid_t object, const char *name, size_t count, const char *const labels[]);

/// Reads an attribute of exactly max(count, 1) numbers.
pdmc_status pdmc_h5_read_numbers(hid_t object, const char *name, hid_t memory_type, size_t count, void *numbers);

/// Reads an attribute, or a dataset, that is a text; free with pdmc_free(). NULL on failure.
pdmc_status pdmc_h5_read_text(hid_t object, const char *name, char **text);
pdmc_status pdmc_h5_read_document(hid_t group, const char *name, char **text);
