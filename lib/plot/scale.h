/* scale.h -- an axis laid on the page: values <-> pixels from its lower end. */
#pragma once

#include "figure.h"

struct scale {
    bool is_log;
    double lo, hi; /* values at the two ends */
    double a, b;   /* the same, log10 where is_log */
    double pixels; /* between the ends */
};

/* The axis must be valid: finite, lo < hi, 0 < lo if is_log. */
struct scale scale_of(const struct figure_axis *axis, double pixels);

/* Not finite where the value cannot be drawn. */
double scale_pixel(const struct scale *s, double value);

/* Exactly lo and hi at the ends. */
double scale_value(const struct scale *s, double pixel);

/* Pixels per unit of the value (of its natural logarithm if is_log). */
double scale_rate(const struct scale *s);
