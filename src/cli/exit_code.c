// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/exit_code.h"

#include <stdio.h>
#include <sysexits.h>

int exit_code(pdmc_status status)
{
    switch (status) {
    case PDMC_OK: return EX_OK;
    case PDMC_ERR_ARG: return EX_USAGE;
    case PDMC_ERR_CONFIG: return EX_CONFIG;
    case PDMC_ERR_NO_INPUT: return EX_NOINPUT;
    case PDMC_ERR_DATA:
    case PDMC_ERR_SINGULAR: return EX_DATAERR;
    case PDMC_ERR_CREATE: return EX_CANTCREAT;
    case PDMC_ERR_IO: return EX_IOERR;
    case PDMC_ERR_INTERRUPTED: return EX_TEMPFAIL;
    case PDMC_ERR_NOMEM:
    case PDMC_ERR_EXTERN: return EX_SOFTWARE;
    }
    return EX_SOFTWARE;
}

int fail(pdmc_status status)
{
    fprintf(stderr, "pdmc: %s\n", pdmc_last_error());
    return exit_code(status);
}
