// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Random fields over a rectangle and processes over a radius, expanded by Karhunen & Loeve:
///     M(x) = 1 + sum_k xi_k(z) psi_k(x),   z independent standard normal.
/// A normal field has xi_k = z_k and psi_k = v sqrt(lambda_k) phi_k with the eigenpairs of the covariance. A lognormal one is
/// the exponential exp(s g - s^2 var g / 2), s^2 = log(1 + v^2), of a normal one g, with the variance that its modes retain at
/// each point, so that the mean is 1; it is expanded once more in the eigenfunctions psi_k of its own covariance
/// exp(s^2 Cov g) - 1, with uncorrelated xi_k of variance 1.

#include "pdmc/distribution.h"

/// Correlation at a distance r, with l the correlation length: exponential exp(-r / l), Gaussian exp(-r^2 / l^2),
/// Matern 2^(1-nu) / Gamma(nu) s^nu K_nu(s) with s = sqrt(2 nu) r / l.
typedef enum { PDMC_COVARIANCE_EXPONENTIAL, PDMC_COVARIANCE_GAUSSIAN, PDMC_COVARIANCE_MATERN } pdmc_covariance_kind;

typedef struct {
    pdmc_covariance_kind kind;
    double length;     // l > 0
    double smoothness; // nu > 0, of Matern's
} pdmc_covariance;

/// The correlation at distance r >= 0; 1 at 0.
PDMC_API double pdmc_covariance_at(const pdmc_covariance *covariance, double r);

typedef struct {
    pdmc_covariance covariance;          // of the normal field
    pdmc_distribution_kind distribution; // PDMC_NORMAL or PDMC_LOGNORMAL, of M at a point
    double variation;                    // coefficient of variation v of M at a point, mean 1; > 0 if lognormal
    int modes;                           // number of normal variables z, >= 1
} pdmc_field_request;

/// A linear functional of the field that matters, sum_j weight_j M(x_j): the modes begin with the directions C s of these,
/// so that their variances are kept in full, and go on with those of the covariance that remains.
typedef struct {
    int points;
    const double *x;      // [points, 2]; the same array as of the functional before costs no more covariances
    const double *weight; // [points]
} pdmc_field_functional;

typedef struct pdmc_field pdmc_field;

/// The same functions for every discretisation: eigenfunctions by Galerkin's method in Legendre polynomials, of a degree
/// that leaves < 1e-8 of the modes' variance in the highest ones. Signs are fixed; of eigenvalues that are equal in one
/// class of symmetry (a Gaussian covariance on a square has them) the functions are not unique.
/// @param[in]  width, height  of the rectangle, centred at the origin
/// @param[in]  functional     [functionals], may be none, at most `modes`; copied
/// @param[in]  threads        >= 1; the field does not depend on it
/// @param[out] field          destroy with pdmc_field_destroy()
/// @return PDMC_OK, PDMC_ERR_ARG (also for more modes than the method can resolve), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_field_create(const pdmc_field_request *request, double width, double height,
                                                      int functionals, const pdmc_field_functional functional[],
                                                      int threads, pdmc_field **field);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_field_destroy(pdmc_field **field);

PDMC_API int pdmc_field_modes(const pdmc_field *field); // number of z
PDMC_API int pdmc_field_terms(const pdmc_field *field); // number of xi

/// The share of the normal field's variance, averaged over the rectangle, that the modes hold.
PDMC_API double pdmc_field_retained(const pdmc_field *field);

/// The root mean square over the rectangle and over samples of what the terms leave out of the exponential, measured on
/// points and samples of its own; about 1e-3 v. 0 of a normal field.
PDMC_API double pdmc_field_expansion_error(const pdmc_field *field);

/// psi at any points of the rectangle.
/// @param[in]  x      [points, 2]
/// @param[out] value  [points, terms]
/// @return PDMC_OK, PDMC_ERR_ARG where a point is outside of the rectangle, or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_field_terms_at(const pdmc_field *field, int points, const double x[],
                                                        double value[]);

/// xi of samples. A sample has the same bits in any call; PDMC_BLOCK samples cost as much as one.
/// @param[in]  z   [count, modes]
/// @param[out] xi  [count, terms]
/// @return PDMC_OK or PDMC_ERR_NOMEM
PDMC_API PDMC_NODISCARD pdmc_status pdmc_field_coefficients(const pdmc_field *field, int count, const double z[],
                                                            double xi[]);

/// Factors of a process over a radius that is constant in each of `bins` equal bins of [0, radius]: eta = F z has the
/// correlation of the bins' middles, F = the `modes` leading eigenvectors times the roots of their eigenvalues.
/// @param[out] factor    [bins, modes]
/// @param[out] retained  the share of the variance that the modes hold
/// @return PDMC_OK, PDMC_ERR_ARG, PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_radial_modes(const pdmc_covariance *covariance, double radius, int bins,
                                                      int modes, double factor[], double *retained);

/// A stationary normal process g along a line of mean 0, in its leading modes: v g(x) = sum_k z_k psi_k(x), psi_k = v
/// sqrt(lambda_k) phi_k with the eigenpairs of the covariance on [-length / 2, length / 2], z independent standard normal.
typedef struct pdmc_process pdmc_process;

/// By Galerkin's method in Legendre polynomials, as a field.
/// @param[in]  variation  v >= 0
/// @param[in]  modes      >= 1
/// @param[out] process    destroy with pdmc_process_destroy()
/// @return PDMC_OK, PDMC_ERR_ARG (also for more modes than the method can resolve), PDMC_ERR_NOMEM, or PDMC_ERR_EXTERN
PDMC_API PDMC_NODISCARD pdmc_status pdmc_process_create(const pdmc_covariance *covariance, double length,
                                                        double variation, int modes, pdmc_process **process);

/// NULL is allowed; sets the pointer to NULL.
PDMC_API void pdmc_process_destroy(pdmc_process **process);

/// The share of the variance, averaged over the line, that the modes hold.
PDMC_API double pdmc_process_retained(const pdmc_process *process);

/// psi_mode(x).
PDMC_API double pdmc_process_mode(const pdmc_process *process, int mode, double x);
