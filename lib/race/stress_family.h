/*
 * stress_family.h -- the compact table behind the catalogue: a family is a
 * list of laws, a parameter with its extreme values and a list of slopes.
 */
#pragma once

#include "law.h"
#include "status.h"
#include "stress_case.h"

/* Where fields are looked at: beside the saddle and beside points of its stable
 * manifold. */
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

struct stress_values {
    const double *at; /* static */
    size_t count;
};

/* The parameter that a family drives to extremes. */
enum stress_knob {
    STRESS_NOTHING,
    STRESS_EPS2,     /* eps^2 times the value, by gravity */
    STRESS_R,        /* R */
    STRESS_C,        /* c as a part of the cusp's, where the folds merge */
    STRESS_B_OVER_A, /* b/a - 1 at Table 2's a */
    STRESS_A,        /* a at Table 2's b/a */
    STRESS_MU_STAR,  /* mu_star */
    STRESS_V_C       /* V_c of Kato and Tullis */
};

/* What a family's slopes are. */
enum stress_slope {
    STRESS_ALPHA,   /* alpha */
    STRESS_STEEP,   /* pi/2 - alpha */
    STRESS_LN_V,    /* ln v of a steady state */
    STRESS_MAXIMUM, /* alpha less that of the maximum of mu_ss */
    STRESS_MINIMUM, /* the same of the minimum */
    STRESS_BETWEEN  /* where mu_ss lies between them, 0 to 1 */
};

struct stress_family {
    const char *name;
    const char *laws; /* presets; "presets": all; "compositions": all; those
                         named THETA.PSI_SS.TIMESCALE.KINETICS */
    enum friction_form last_form; /* from FRICTION_ASINH to this */
    enum stress_knob knob;
    struct stress_values value;
    enum stress_slope slope;
    struct stress_values at;
    enum stress_kind kind;
    const struct scene_start *start; /* STRESS_START; psi of laws whose psi is
                                        a logarithm: its ln */
    size_t starts;
    const struct stress_place *place; /* STRESS_FIELD */
    size_t places;
};

/* NULL past the end. */
const struct stress_family *stress_family_at(size_t i);

/* The material with the family's parameter at `value`; false where the law
 * does not use it. */
bool stress_material(const struct law *law, enum stress_knob knob, double value,
                     struct material *m);

/* alpha of the slope; false where there is none in (0, pi/2). */
bool stress_alpha(const struct law *law, const struct material *m,
                  enum stress_slope slope, double at, double *alpha);
