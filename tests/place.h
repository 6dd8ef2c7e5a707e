/* place.h -- a slope with its slow curve. */
#pragma once

#include "slope.h"
#include "slow_curve.h"

static const char *const steady_only[] = { "products=[equilibria]", NULL };

struct place {
    struct slope s;
    struct slow_curve c;
};

static void place_make(struct place *p, const char *law, const char *alpha)
{
    slope_make(&p->s, law, NULL, alpha, steady_only);
    assert_int_equal(slow_curve_init(&p->c, &p->s.study.slider, NULL),
                     STATUS_OK);
}

static void place_drop(struct place *p)
{
    slow_curve_free(&p->c);
    slope_free(&p->s);
}
