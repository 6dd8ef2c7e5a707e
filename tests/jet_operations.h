/* jet_operations.h -- products and integrals of series (jet.h), an operation at
 * a time, of which the fixtures' fields are made. */
#pragma once

#include "jet.h"

/* The next free series; forget them all with w->used = 0. */
static inline jet_pair *jet_slot(struct jet_work *w)
{
    return w->slot[w->used++];
}

/* sum_{j=0}^{k} u[j] v[k-j] */
static inline jet_pair jet_product(size_t k, const jet_pair u[],
                                   const jet_pair v[])
{
    if (k == 0)
        return u[0] * v[0];
    return jet_sum(k - 1, u + 1, v + k - 1) + (u[0] * v[k] + u[k] * v[0]);
}

/* Coefficient k of the integral of u' v, k > 0, given du[j] = j u[j]; one term
 * where u is w->linear. */
static inline jet_pair jet_chain(const struct jet_work *w, size_t k,
                                 const jet_pair u[], const jet_pair du[],
                                 const jet_pair v[])
{
    if (u == w->linear)
        return u[1] * v[k - 1] * jet_inverse[k];
    return jet_sum(k - 1, du + 1, v + k - 1) * jet_inverse[k] + u[k] * v[0];
}
