#include "scale.h"

#include <math.h>

struct scale scale_of(const struct figure_axis *axis, double pixels)
{
    struct scale s = { axis->is_log, axis->lo, axis->hi,
                       axis->lo,     axis->hi, pixels };
    if (s.is_log) {
        s.a = log10(s.lo);
        s.b = log10(s.hi);
    }
    return s;
}

double scale_pixel(const struct scale *s, double value)
{
    if (s->is_log && !(value > 0))
        return NAN;
    const double t = s->is_log ? log10(value) : value;
    return (t / 2 - s->a / 2) / (s->b / 2 - s->a / 2) * s->pixels;
}

double scale_value(const struct scale *s, double pixel)
{
    if (pixel <= 0)
        return s->lo;
    if (pixel >= s->pixels)
        return s->hi;
    const double f = pixel / s->pixels;
    const double t = s->a * (1 - f) + s->b * f;
    return s->is_log ? pow(10, t) : t;
}

double scale_rate(const struct scale *s)
{
    const double per_unit = s->pixels / 2 / (s->b / 2 - s->a / 2);
    return s->is_log ? per_unit / log(10) : per_unit;
}
