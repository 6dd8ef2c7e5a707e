/* Extrema of mu_ss where two are about to merge, which is where digits go:
 * the printed friction in 113 bits must turn within the bar of each. */
#include "extremum.h"

#include <math.h>

#include "check.h"
#include "cusp.h"
#include "laws.h"
#include "plain.h"

/* mu_ss rises (1), falls (-1) at v (1 + by). */
static int rises(const struct law *law, const struct material *m, double v,
                 double by)
{
    const quad x = logq((quad) v) + log1pq((quad) by), h = (quad) 1e-12;
    return plain_mu_ss(law, m, x + h) > plain_mu_ss(law, m, x - h) ? 1 : -1;
}

static void check_turn(size_t i, const struct law *law,
                       const struct material *m, const struct extremum *e)
{
    const double bar = e->v.error / e->v.value;
    const int before = rises(law, m, e->v.value, -bar);
    const int after = rises(law, m, e->v.value, bar);
    const int wanted = e->kind == EXTREMUM_MAXIMUM ? 1 : -1;

    CHECK(before == wanted && after == -wanted,
          "law %zu c = %.17g: %s at v = %.17g +- %.1g: slopes %d, %d", i, m->c,
          extremum_names[e->kind], e->v.value, e->v.error, before, after);
}

static void check_pair(size_t i, const struct law *law,
                       const struct material *m)
{
    struct extremum e[EXTREMA_MAX];

    CHECK(extremum_find(law, m, e) == 2 && e[0].kind == EXTREMUM_MAXIMUM &&
              e[1].kind == EXTREMUM_MINIMUM && e[0].v.value < e[1].v.value,
          "law %zu: no maximum before a minimum", i);
    check_turn(i, law, m, &e[0]);
    check_turn(i, law, m, &e[1]);
}

/* Down to the last digits of c below the cusp. */
static void bars_hold_up_to_the_cusp(void **state)
{
    uint64_t seed = check_seed();
    struct law law;
    struct material m;
    size_t pairs = 0;

    (void) state;
    if (laws_emulated())
        return;
    for (size_t i = 0; i < LAWS * 8; i++) {
        if (!laws_draw(i % LAWS, &seed, &law, &m) || isinf(m.R))
            continue;
        m.mu_star = check_uniform(&seed, 0.3, 0.9); /* asinh keeps its digits */
        m.b = m.a * (1 + laws_power(&seed, -1, 0.5));
        const struct cusp at = cusp_find(&law, &m);
        if (at.reason)
            continue;
        m.c = (double) at.c * (1 - laws_power(&seed, -15, -0.1));
        check_pair(i % LAWS, &law, &m);
        pairs++;
    }
    CHECK(pairs > 100, "%zu", pairs);
}

/* The largest k u/(1 + u), u = W(exp(-k)), by thirds of ln k. */
static quad top_of_rise(void)
{
    quad lo = -5, hi = 5;

    for (int i = 0; i < 200; i++) {
        quad rise[2];
        for (int j = 0; j < 2; j++) {
            const quad k = expq(lo + (hi - lo) * (j + 1) / 3);
            const quad u = plain_lambert(k);
            rise[j] = k * u / (1 + u);
        }
        if (rise[0] > rise[1])
            hi = lo + (hi - lo) * 2 / 3;
        else
            lo = lo + (hi - lo) / 3;
    }
    const quad k = expq(lo), u = plain_lambert(k);
    return k * u / (1 + u);
}

/* mu_ss turns where a = b (1 + k u/(1 + u)), which has no symmetry about its
 * top as those of the spinodal laws have. */
static void bars_hold_where_kato_and_tullis_two_merge(void **state)
{
    const struct law *law = law_preset_find("kato_tullis");
    struct material m = material_bristol_board();
    const quad top = 1 + top_of_rise();

    (void) state;
    if (laws_emulated())
        return;
    for (int digits = 2; digits <= 15; digits++) {
        m.a = (double) (m.b * top * (1 - expq(-digits * logq(10))));
        check_pair(LAWS_COMPOSED, law, &m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bars_hold_up_to_the_cusp),
        cmocka_unit_test(bars_hold_where_kato_and_tullis_two_merge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
