/*
 * interval_point.h -- e^x, ln x and their kin at a number of 64 bits, enclosed.
 *
 * With u = 2^-64, by which a result of one operation differs from the true one
 * at most, relatively:
 *
 *   e^x = 2^k e^r,  r = x - k ln 2,  |r| < 0.35,
 *
 * where ln 2 = H + L, H of 50 bits, so that k H is exact for |k| < 2^14, and so
 * is x - k H, a multiple of 2^-65 (|x| > 1/4 where k is not 0) below 1/2;
 * |k L| < 2^-36 is known to 2^-98, and r is rounded by 2^-66.
 *
 *   e^r - 1 = q = r + r^2 P(r),  P = sum over j <= 14 of r^j/(j + 2)!.
 *
 * What P lacks is 0.35^16/17!/0.98 < 0.003 u of r.  Of P, Horner's steps have
 * errors e_2 < 0.1 u, e_1 < 0.167 u + 0.35 (e_2 + 0.045 u) + 0.183 u < 0.41 u
 * and e_0 < 0.35 (e_1 + 0.183 u) + 0.57 u < 0.78 u, as |P_0| < 0.57, |P_1| <
 * 0.183, |P_2| < 0.045.  So r^2 P has one of r^2 (0.78 + 2 0.57) u, which is
 * below 0.82 u |q| as |q| > 0.82 |r|, and q, rounded itself, one below 1.9 u.
 * Of 1 + q, in [0.7, 1.42], the error is u (or u/2 below 1) for rounding, 1.9 u
 * |q| and 0.26 u for that of r: less than 1.9 u of it, too.
 *
 * Both ends are 3 u away, rounded: 1.9 u at least, and not above 4.1 u.
 *
 * ln z is proved after the fact: with any y,
 *
 *   ln z = y + ln(1 + d),  d = z e^-y - 1,
 *   ln(1 + z) = y + ln(1 + d),  d = (1 + z) (e^-y - 1) + z,
 *   d - d^2 <= ln(1 + d) <= d  where d >= -1/2
 *
 * (the derivative of ln(1 + d) - d + d^2 is d (1 + 2 d)/(1 + d)); y is that of
 * doubles.
 *
 * Each is exact at 0, or at 1; beyond e^-+11000 an end is 0 or infinite.
 */
#pragma once

#include "interval.h"

struct interval interval_exp_at(long double x);
struct interval interval_expm1_at(long double x);
struct interval interval_ln_at(long double x);   /* of x >= 0 */
struct interval interval_ln1p_at(long double x); /* of x >= -1 */
