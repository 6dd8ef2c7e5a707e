/* normal.h -- the quantile function of the normal law. */
#pragma once

/* z with P(Z < z) = p, 0 < p < 1, to 1e-15 of it. */
double normal_quantile(double p);
