/* Every composition as formulas, lowered to a tape: its field against the same
 * in 113 bits. */
#include <math.h>

#include "condition.h"

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

    tape_field(&s->b.plane, z, &f);
    quad_block_field(&s->at, z.x, z.y, &q);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_law_s_tape_is_exact_near_far_and_between),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
