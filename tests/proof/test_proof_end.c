/* What is left of a branch where psi grows without end, beside the way that the
 * field itself leads on from the same place: at places where friction and
 * gravity are nearly even, as well as others. */
#include "proof_end.h"

#include <math.h>

#include "check.h"
#include "proof.h"
#include "proof_short.h"
#include "reference_rows.h"

/* dx/dy */
static long double lean(struct law_long *law, long double x, long double y)
{
    const long double along = law_long_at(law, x, y, LAW_AT_DX);

    return along / law_long_also(law, LAW_AT_DY);
}

/* How far x goes while y does, by Runge's and Kutta's steps of a fiftieth of an
 * e-fold: to where the rest is nothing. */
static double way_of(struct law_long *law, double from, double y)
{
    enum { STEPS = 20000 };
    long double x = from, at = y;

    for (int i = 0; i < STEPS; i++) {
        const long double a = lean(law, x, at);
        const long double rate =
            fabsl(log1pl(lean(law, x, at + 1e-6L) / a - 1)) * 1e6L;
        const long double h = 0.02L / (1 + rate);
        const long double b = lean(law, x + h / 2 * a, at + h / 2);
        const long double c = lean(law, x + h / 2 * b, at + h / 2);
        const long double d = lean(law, x + h * c, at + h);
        if (!(fabsl(a) > 1e-30L))
            break;
        x += h / 6 * (a + 2 * b + 2 * c + d);
        at += h;
    }
    return (double) (x - from);
}

/* ln v where friction exceeds gravity by m. */
static double place_of(struct law_long *law, const struct proof_law *p,
                       double y, double m)
{
    double lo = interval_middle(p->x) - 100, hi = lo + 200;

    for (int i = 0; i < 200; i++) {
        const double x = lo + (hi - lo) / 2;
        const long double mu = law_long_at(law, x, y, LAW_AT_MU);
        *(mu - p->tan_alpha.hi > m ? &hi : &lo) = x;
    }
    return hi;
}

struct tally {
    int asked, proved;
    double nearest; /* the way, of its bound */
};

static void check_place(struct law_long *law, struct proof_law *p, double y,
                        double m, struct tally *t)
{
    const double x = place_of(law, p, y, m);
    const struct proof_place at = { interval_less(point(x), p->x),
                                    interval_less(point(y), p->y), 1 };
    struct proof_tail tail;
    const char *why = proof_tail_psi(p, &at, 1, &tail);

    t->asked++;
    if (why)
        return;
    const double way = way_of(law, x, y);
    t->proved++;
    t->nearest = fmax(t->nearest, way / tail.way);
    CHECK(way <= tail.way + 1e-18 * fabs(x),
          "%s, y %g, m %g: %.17g, beyond %.17g", p->law.preset,
          y - interval_middle(p->y), m, way, tail.way);
}

/* A block with a saddle, of any a and b. */
static bool draw(struct solved *s, const char *preset, double *tan_alpha,
                 uint64_t *rng)
{
    struct material m = material_bristol_board();

    m.a = pow(10, check_uniform(rng, -2, 0));
    m.b = m.a * check_uniform(rng, 1.02, 2.5);
    *tan_alpha = m.mu_star * check_uniform(rng, 0.7, 1.1);
    if (solve(s, law_preset_find(preset), &m, (long double) *tan_alpha,
              1e-10) == STATUS_OK &&
        s->has_saddle)
        return true;
    solved_free(s);
    return false;
}

static void v_settles_no_further_than_is_proved(void **state)
{
    static const char *const presets[] = { "dieterich_gen", "perrin",
                                           "spinodal_gen", "kato_tullis",
                                           "spinodal" };
    enum { BLOCKS = 20, PLACES = 40 };
    static struct law_long law;
    static struct solved s;
    uint64_t rng = check_seed();
    struct tally t = { 0 };

    (void) state;
    for (int done = 0; done < BLOCKS;) {
        struct proof_inputs in = { .slope_in = ANGLE_TAN };
        struct proof p;
        if (!draw(&s, presets[done % 5], &in.slope, &rng))
            continue;
        assert_int_equal(proof_at(&s.block, &in, &p), STATUS_OK);
        law_long_init(&law, &s.block.law, &s.block.material, s.block.tan_alpha);
        for (int k = 0; k < PLACES && p.not_proved.text[0] == '\0'; k++)
            check_place(&law, &p.law,
                        interval_up(p.law.y.hi) +
                            pow(10, check_uniform(&rng, -0.5, 0.8)),
                        pow(10, check_uniform(&rng, -3, 0.3)), &t);
        proof_free(&p);
        solved_free(&s);
        done++;
    }
    print_message("# %d of %d places, the way at most %g of its bound\n",
                  t.proved, t.asked, t.nearest);
    CHECK(t.proved >= 40, "%d of %d", t.proved, t.asked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(v_settles_no_further_than_is_proved),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
