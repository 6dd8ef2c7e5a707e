/*
 * many.h -- what several planes, or one, are at points: side by side where they
 * have lanes, with the same bits.
 */
#pragma once

#include "local.h"

/* At z[i] of sys[i], alike (planar.h); without slopes only the field and the
 * rate are set, with which < 0 no rate. */
void many_at(const struct planar *const sys[], size_t n, const struct vec2 z[],
             int which, bool slopes, struct planar_look out[]);

/* The same of one plane. */
void many_along(const struct planar *sys, size_t n, const struct vec2 z[],
                int which, bool slopes, struct planar_look out[]);

/* Whether they are alike. */
bool many_alike(const struct planar *sys, const struct planar *other);

/* Whether both carry the same. */
bool many_carry_alike(const struct carry *carry, const struct carry *other);

/* The only rate that is carried and is an observable's; -1: there is none, or
 * more than one. */
int many_carried(const struct carry *carry);
