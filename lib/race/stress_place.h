/* stress_place.h -- where fields are looked at: beside the saddle and beside
 * points of its stable manifold. */
#pragma once

#include "law.h"
#include "status.h"

struct stress_place {
    double along; /* 0: the saddle; else where its upper (> 0) or lower (< 0)
                     stable branch is first so far from it, in the chart */
    double aside; /* how far the cells are from there, in ln v and in ln psi (in
                     psi where it is a logarithm) */
};

struct stress_centre {
    bool exists; /* there is such a saddle, and its branch reaches so far */
    double v, psi;
};

/* The place as the program has it.  Only STATUS_NO_MEMORY is an error. */
MUST_CHECK enum status stress_place_find(const struct law *law,
                                         const struct material *m, double alpha,
                                         double along,
                                         struct stress_centre *out);
