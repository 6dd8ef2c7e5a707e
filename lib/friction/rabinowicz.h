/*
 * rabinowicz.h -- Rabinowicz's impact experiment (Putelat & Dawes 2015, 4.1):
 * a ball rolls down the slope over a distance l, hits the block at rest and
 * gives it a velocity.  The block slides on where l exceeds the critical
 * release distance l_k.
 *
 * Lengths in one unit, whichever; the friction laws' are in units of L.
 */
#pragma once

#include "law.h"

/* K = (5/7)(1 + e)^2 (m_b/m)^2, (22), of block and ball in one unit of mass. */
double rabinowicz_K(double block_mass, double ball_mass, double restitution);

/* l/L for which the block starts with the slip rate v (in units of V_star):
 * eps^2 v^2/(2 K sin alpha), from (20) and (21). */
double rabinowicz_release(double eps2, double v, double K, double tan_alpha);

/* l_k of a fracture energy G in units of L, (32): G/(K tan alpha). */
double rabinowicz_release_of_energy(double G, double K, double tan_alpha);

/* mu_ss(V_star/2) = mu_star + (b - a) ln 2: the smaller root of (33). */
double rabinowicz_mu_half(const struct material *m);

/* eta L/(K (b - a)) in m, the factor of (33), for b > a. */
double rabinowicz_factor(const struct law *law, const struct material *m,
                         double K);

/* l_k of (33): factor (mu_s - tan alpha)(mu_half - tan alpha)/tan alpha. */
double rabinowicz_release_33(double factor, double mu_s, double mu_half,
                             double tan_alpha);
