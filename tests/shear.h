/*
 * shear.h -- polynomial maps of the plane that are undone exactly,
 *
 *     (x, y) -> (x + p(y), y)    or    (x, y) -> (x, y + p(x)),
 *
 * and what becomes of a vector field, its Jacobian, a gradient and a Taylor
 * series when the plane is moved by one.
 */
#pragma once

#include "jet.h"
#include "plane.h"

enum { SHEAR_DEGREE_MAX = 4 };

struct shear {
    bool vertical; /* moves y by p(x); otherwise x by p(y) */
    size_t degree; /* 1 .. SHEAR_DEGREE_MAX */
    double coef[SHEAR_DEGREE_MAX + 1];
};

struct vec2 shear_apply(const struct shear *s, struct vec2 z);
struct vec2 shear_undo(const struct shear *s, struct vec2 z);

/* The same map for offsets, from `at` to its image: p(t) becomes
 * p(c + t) - p(c), and offset zero stays exactly zero. */
struct shear shear_about(const struct shear *s, struct vec2 at);

/* At one point z of the plane: a vector field's value and derivative, and the
 * gradient of a scalar. */
struct shear_frame {
    struct vec2 z, value;
    struct mat2 slope;
    struct vec2 gradient;
};

/* All of it as seen after the map. */
void shear_carry(const struct shear *s, struct shear_frame *f);

/* Series, called for k = 0, 1, 2, ... with the slots of w in the same order.
 * Undo: the two series z[] are replaced by those before the map; returns the
 * series of p' along the curve.  Carry: the field's two series v[] before the
 * map are replaced by those after it, given what undo returned. */
const jet_pair *shear_jet_undo(const struct shear *s, struct jet_work *w,
                               size_t k, const jet_pair *z[2]);
void shear_jet_carry(const struct shear *s, struct jet_work *w, size_t k,
                     const jet_pair *slope, const jet_pair *v[2]);
