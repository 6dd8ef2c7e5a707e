/* Every composition as formulas, lowered to a tape: its field against the same
 * in 113 bits, and its series against those of the components. */
#include "law_tape.h"

#include <math.h>
#include <string.h>

#include "condition.h"

static struct tape_plane plane;

static void name_leaves(struct formula *f, const struct formula_value leaf[])
{
    formula_init(f);
    for (; leaf->name; leaf++)
        formula_leaf(f, leaf->name,
                     leaf->value >= 0 ? FORMULA_POSITIVE_PARAMETER
                                      : FORMULA_PARAMETER);
}

/* The setting's law in doubles, from its formulas. */
static void make_plane(const struct setting *s, bool equilibrium)
{
    static struct tape_lowered lowered;
    const struct material *m = &s->m;
    const struct formula_value leaf[] = {
        { "tan_alpha", s->exact_tan },
        { "mu_star", m->mu_star },
        { "a", m->a },
        { "b", m->b },
        { "c", m->c },
        { "R", m->R },
        { "one_R", 1 / (quad) m->R },
        { "V_c", m->V_c },
        { "eps2", (quad) m->V_star * m->V_star / ((quad) m->g * m->L) },
        { "lnv0", s->x },
        { NULL, 0 },
    };
    const quad anchor[2] = { s->at.x0, s->at.y0 };
    struct fault why = { "" };

    name_leaves(&lowered.f, leaf);
    law_tape(&s->law, equilibrium, &lowered);
    const enum status status =
        tape_plane_at(&lowered, leaf, anchor, &plane, &why);
    CHECK(status == STATUS_OK, "law %zu: %s", s->number, why.text);
}

struct tally {
    double worst, sum;
    long points, lost; /* lost: beyond 10 units of the condition */
};

static void count(struct tally *t, double p, double log_scale, quad q,
                  quad exact_scale, quad condition)
{
    if (fabsq(q) * expq(exact_scale - log_scale) < 1e-290 ||
        !(8 * ULP * condition < 0.5))
        return;
    const double off =
        (double) (fabsq(log_ratio(p, log_scale, q, exact_scale)) /
                  (ULP * condition));
    t->points++;
    t->lost += !(off <= 10);
    t->worst = fmax(t->worst, isfinite(off) ? off : 0);
    t->sum += off <= 10 ? off : 0;
}

static void tally_point(const struct setting *s, struct vec2 z, struct tally *t)
{
    struct planar_field f;
    struct quad_field q;

    tape_field(&plane, z, &f);
    quad_block_field(&s->law, &s->at, z.x, z.y, &q);
    const struct condition c = condition_at(s, z.x, z.y, f.log_scale);
    count(t, f.direction.x, f.log_scale, q.direction[0], q.log_scale, c.x);
    count(t, f.direction.y, f.log_scale, q.direction[1], q.log_scale, c.y);
    if (t->lost)
        print_message("law %zu from %g %g at %g %g\n", s->number, s->b.at.x0,
                      s->b.at.y0, z.x, z.y);
}

/* No component loses more than 10 units of roundoff of its condition. */
static void a_law_s_tape_is_exact_near_far_and_between(void **state)
{
    static const char *const zone[] = { "far", "0.1 to 20", "1e-15 to 0.1" };
    struct tally tally[3] = { { 0 } };
    uint64_t seed = check_seed() + 4;
    struct setting s;

    (void) state;
    if (laws_emulated())
        skip();
    for (size_t i = 0; i < LAWS * 8; i++) {
        if (!draw_setting(i, 20, &seed, &s))
            continue;
        make_plane(&s, s.at.force0 == 0);
        for (int k = 0; k < 24; k++) {
            tally_point(&s,
                        k % 3 == 0   ? draw_far(&s, &seed)
                        : k % 3 == 1 ? draw_near(-1, 1.3, &seed)
                                     : draw_near(-15, -1, &seed),
                        &tally[k % 3]);
            assert_true(tally[k % 3].lost < 100);
        }
    }
    for (int i = 0; i < 3; i++)
        print_message("%s: %ld components, worst %.3g, mean %.3g\n", zone[i],
                      tally[i].points, tally[i].worst,
                      tally[i].sum / (double) tally[i].points);
    for (int i = 0; i < 3; i++)
        CHECK(tally[i].lost == 0 && tally[i].points > 10000, "%s: %ld lost",
              zone[i], tally[i].lost);
}

/* Two curves of three random coefficients each. */
static void draw_curves(uint64_t *seed, jet_pair x[], jet_pair y[])
{
    for (int k = 0; k < JET_SIZE; k++)
        for (int i = 0; i < JET_LANES; i++) {
            x[k][i] = k < 3 ? check_uniform(seed, -1, 1) : 0;
            y[k][i] = k < 3 ? check_uniform(seed, -1, 1) : 0;
        }
}

/* Coefficients may cancel: they are compared with the largest before them. */
static void a_law_s_series_are_those_of_its_components(void **state)
{
    static struct jet_work w;
    static jet_pair x[JET_SIZE], y[JET_SIZE], f[2][2][JET_SIZE];
    enum { ORDER = 16 };
    uint64_t seed = check_seed() + 5;
    struct setting s;
    long compared = 0;

    (void) state;
    for (size_t i = 0; i < LAWS * 4; i++) {
        if (!draw_setting(i, 3, &seed, &s))
            continue;
        make_plane(&s, s.at.force0 == 0);
        draw_curves(&seed, x, y);
        jet_pair scale[2];
        for (int way = 0; way < 2; way++) {
            w.linear = NULL;
            w.used = 0;
            for (size_t k = 0; k < ORDER; k++)
                (way ? tape_jet(&plane, &w, k, x, y, f[1][0], f[1][1])
                     : field_jet(&s.law, &s.b.at, &w, k, x, y, f[0][0],
                                 f[0][1]));
            scale[way] = w.log_scale;
        }
        for (int c = 0; c < 2; c++)
            for (int j = 0; j < JET_LANES; j++) {
                double most = 0;
                for (size_t k = 0; k < ORDER; k++, compared++) {
                    const double u = f[0][c][k][j];
                    const double v =
                        f[1][c][k][j] * exp(scale[1][j] - scale[0][j]);
                    const double lost = 1 + fabs(scale[0][j]);
                    most = fmax(most, fabs(u));
                    CHECK(!isfinite(u) || fabs(u - v) <= 1e-12 * lost * most,
                          "law %zu, f%d[%zu]: %.17g, not %.17g", s.number, c, k,
                          v, u);
                }
            }
    }
    CHECK(compared > 10000, "%ld", compared);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_law_s_tape_is_exact_near_far_and_between),
        cmocka_unit_test(a_law_s_series_are_those_of_its_components),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
