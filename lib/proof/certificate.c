#include "certificate.h"

#include "interval_math.h"
#include "number.h"

json_t *certificate_decimal(double x)
{
    return json_string(number_shortest(x).text);
}

json_t *certificate_interval(struct interval u)
{
    const struct interval_double out = interval_outward(u);

    return json_pack("[f, f]", out.lo, out.hi);
}

static json_t *piece_json(const struct proof_branch *b,
                          const struct proof_piece *p)
{
    json_t *coef = json_array(), *cells = json_array();

    for (size_t k = 0; k <= p->degree; k++)
        json_array_append_new(coef, json_real(p->coef[k]));
    for (size_t k = p->first; k < p->first + p->cells; k++)
        json_array_append_new(
            cells, json_pack("[f, f, f, o]", b->cell[k].to, b->cell[k].radius,
                             b->cell[k].after,
                             certificate_interval(b->cell[k].excess)));
    return json_pack("{s:s, s:f, s:f, s:o, s:o}", "independent",
                     p->ind == 0 ? "x" : "y", "start", p->start, "step",
                     p->step, "coef", coef, "cells", cells);
}

json_t *certificate_tube(const struct proof_branch *b)
{
    json_t *pieces = json_array();

    for (size_t i = 0; i < b->pieces && (i == 0 || b->piece[i].cells); i++)
        json_array_append_new(pieces, piece_json(b, &b->piece[i]));
    return json_pack("{s:{s:f, s:f, s:o}, s:o}", "cone", "reach", b->cone.reach,
                     "slope", b->cone.slope, "excess",
                     certificate_interval(b->cone.excess), "pieces", pieces);
}
