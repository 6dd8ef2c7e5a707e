/*
 * quad.h -- 113-bit numbers for gcc and clang: the type with the functions of
 * glibc's f128 (TS 18661-3, which clang 14 does not declare), under the names
 * of GCC's libquadmath.  That library is not linked: loading it hooks printf,
 * after which every number that is printed takes glibc's slow path.
 */
#pragma once

#include <stddef.h>

__extension__ typedef __float128 quad;

#define QUAD_UNARY(f)  quad f##q(quad x) __asm__(#f "f128")
#define QUAD_BINARY(f) quad f##q(quad x, quad y) __asm__(#f "f128")

QUAD_UNARY(acos);
QUAD_UNARY(asin);
QUAD_UNARY(asinh);
QUAD_BINARY(atan2);
QUAD_UNARY(atan);
QUAD_UNARY(atanh);
QUAD_UNARY(ceil);
QUAD_UNARY(cosh);
QUAD_UNARY(cos);
QUAD_UNARY(expm1);
QUAD_UNARY(floor);
QUAD_BINARY(hypot);
QUAD_UNARY(log10);
QUAD_UNARY(log1p);
QUAD_UNARY(log);
QUAD_BINARY(pow);
QUAD_UNARY(sinh);
QUAD_UNARY(sin);
QUAD_UNARY(sqrt);
QUAD_UNARY(tanh);
QUAD_UNARY(tan);
quad expq(quad x) __asm__("quad_exp"); /* quad_exp.c */
quad quad_libm_exp(quad x) __asm__("expf128");
quad strtof128(const char *text, char **end);
int strfromf128(char *text, size_t size, const char *format, quad x);

static inline quad copysignq(quad x, quad y)
{
    return __builtin_copysignf128(x, y);
}

static inline quad fabsq(quad x)
{
    return __builtin_fabsf128(x);
}
