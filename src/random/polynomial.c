// SPDX-License-Identifier: GPL-3.0-or-later
#include "random/design_impl.h"

int pdmc_polynomial_degree(uint32_t polynomial)
{
    int degree = -1;
    for (; polynomial; polynomial >>= 1) degree++;
    return degree;
}

/// a b modulo the polynomial, where a is of lower degree.
static uint32_t multiply(uint32_t a, uint32_t b, uint32_t polynomial, int degree)
{
    uint32_t product = 0;
    for (; b; b >>= 1) {
        if (b & 1) product ^= a;
        a <<= 1;
        if (a >> degree & 1) a ^= polynomial;
    }
    return product;
}

static uint32_t power_of_x(uint32_t exponent, uint32_t polynomial, int degree)
{
    uint32_t result = 1, square = multiply(1, 2, polynomial, degree);
    for (; exponent; exponent >>= 1) {
        if (exponent & 1) result = multiply(result, square, polynomial, degree);
        square = multiply(square, square, polynomial, degree);
    }
    return result;
}

static uint32_t smallest_factor(uint32_t number)
{
    for (uint32_t factor = 2; factor <= number / factor; factor++)
        if (number % factor == 0) return factor;
    return number;
}

/// The powers of x run through all 2^degree - 1 polynomials of lower degree: they return to 1 there and, for any prime
/// factor q of this number, not at its q-th part.
bool pdmc_polynomial_is_primitive(uint32_t polynomial)
{
    const int degree = pdmc_polynomial_degree(polynomial);
    const uint32_t order = (UINT32_C(1) << degree) - 1;
    if (power_of_x(order, polynomial, degree) != 1) return false;
    for (uint32_t rest = order; rest > 1;) {
        const uint32_t factor = smallest_factor(rest);
        if (power_of_x(order / factor, polynomial, degree) == 1) return false;
        while (rest % factor == 0) rest /= factor;
    }
    return true;
}
