/* normal.h -- the normal law and its quantile function. */
#pragma once

/* z with P(Z < z) = p, 0 < p < 1, to 1e-15 of it. */
double normal_quantile(double p);

/* P(Z < z), to 1e-15. */
double normal_below(double z);
