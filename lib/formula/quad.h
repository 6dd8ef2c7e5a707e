/*
 * quad.h -- the 113-bit numbers of GCC's libquadmath, for gcc and clang:
 * clang has the type and can link the library but does not find <quadmath.h>,
 * so the few functions used are declared here.
 */
#pragma once

#include <stddef.h>

__extension__ typedef __float128 quad;

quad asinhq(quad x);
quad asinq(quad x);
quad atan2q(quad y, quad x);
quad atanq(quad x);
quad ceilq(quad x);
quad copysignq(quad x, quad y);
quad coshq(quad x);
quad cosq(quad x);
quad expm1q(quad x);
quad expq(quad x);
quad fabsq(quad x);
quad floorq(quad x);
quad hypotq(quad x, quad y);
quad log1pq(quad x);
quad logq(quad x);
quad powq(quad x, quad y);
quad sinhq(quad x);
quad sinq(quad x);
quad sqrtq(quad x);
int quadmath_snprintf(char *text, size_t size, const char *format, ...);
quad strtoflt128(const char *text, char **end);
quad tanhq(quad x);
quad tanq(quad x);
