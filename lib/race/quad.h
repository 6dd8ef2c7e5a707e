/*
 * quad.h -- the 113-bit numbers of GCC's libquadmath, for gcc and clang:
 * clang has the type and can link the library but does not find <quadmath.h>,
 * so the few functions used are declared here.
 */
#ifndef RACE_QUAD_H
#define RACE_QUAD_H

typedef __float128 quad;

quad asinhq(quad x);
quad copysignq(quad x, quad y);
quad coshq(quad x);
quad expm1q(quad x);
quad expq(quad x);
quad fabsq(quad x);
quad log1pq(quad x);
quad logq(quad x);
quad powq(quad x, quad y);
quad sinhq(quad x);
quad sqrtq(quad x);
quad strtoflt128(const char *text, char **end);

#endif
