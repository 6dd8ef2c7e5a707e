/* The field's derivatives by the parameters against differences of the field
 * in 113 bits. */
#include "parameter.h"

#include <math.h>

#include "setting.h"

/* The field at fixed absolute (x, y), where one parameter is moved; in units
 * of exp(scale). */
struct moved {
    quad x, y;
};

static struct moved field_when(const struct setting *s, struct vec2 z,
                               enum parameter p, double step, quad scale)
{
    struct material m = s->m;
    struct quad_anchor at;
    struct quad_field f;
    quad t = s->exact_tan;

    switch (p) {
        case PARAMETER_ALPHA:
            t += (quad) step;
            break;
        case PARAMETER_EPS2:
            m.g += step;
            break;
        default:
            *(p == PARAMETER_A         ? &m.a
              : p == PARAMETER_B       ? &m.b
              : p == PARAMETER_MU_STAR ? &m.mu_star
              : p == PARAMETER_C       ? &m.c
                                       : &m.R) += step;
    }
    quad_block_anchor(&s->law, &m, t, (quad) s->x, false, &at);
    const quad Y = s->at.y0 + (quad) z.y - at.y0;
    quad_block_field(&at, (quad) z.x, Y, &f);
    const quad unit = expq(f.log_scale - scale);
    return (struct moved){ f.direction[0] * unit, f.direction[1] * unit };
}

/* The size of a parameter as differences see it. */
static double size_of(const struct setting *s, enum parameter p)
{
    switch (p) {
        case PARAMETER_ALPHA:
            return (double) s->exact_tan;
        case PARAMETER_A:
            return s->m.a;
        case PARAMETER_B:
            return s->m.b;
        case PARAMETER_MU_STAR:
            return s->m.mu_star;
        case PARAMETER_C:
            return s->m.c;
        case PARAMETER_R:
            return s->m.R;
        default:
            return s->m.g;
    }
}

/* d moved/d p: tan(alpha) is moved for alpha, g for eps2. */
static quad unit_of(const struct setting *s, enum parameter p)
{
    const quad g = s->m.g, V = s->m.V_star;

    if (p == PARAMETER_ALPHA)
        return 1 + s->exact_tan * s->exact_tan;
    return p == PARAMETER_EPS2 ? -g * g * (quad) s->m.L / (V * V) : 1;
}

/* Differences of order 4 at steps that doubles hold exactly. */
static struct moved difference(const struct setting *s, struct vec2 z,
                               enum parameter p, quad scale)
{
    const double h = 0x1p-30 * exp2(floor(log2(size_of(s, p))));
    struct moved f[4], d;

    for (int i = 0; i < 4; i++)
        f[i] = field_when(s, z, p, (i < 2 ? i - 2 : i - 1) * h, scale);
    d.x = (f[0].x - 8 * f[1].x + 8 * f[2].x - f[3].x) / (12 * h);
    d.y = (f[0].y - 8 * f[1].y + 8 * f[2].y - f[3].y) / (12 * h);
    const quad unit = unit_of(s, p);
    return (struct moved){ d.x * unit, d.y * unit };
}

static void check_parameter(const struct setting *s, struct vec2 z,
                            enum parameter p)
{
    struct planar_field f;
    struct vec2 got[PARAMETERS];

    tape_field(&s->b.plane, z, &f);
    parameter_field(&s->b, z, &f, got);
    const struct moved want = difference(s, z, p, (quad) f.log_scale);
    const double unit = exp(s->b.at.log_inertia - z.x - f.log_scale);
    /* exponents are rounded to their size, d = psi - psi_ss to psi's, and
     * mu_log is a sum of terms that may cancel */
    const double terms = fabs(s->m.mu_star) / s->m.a + fabs(s->b.at.x0 + z.x) +
                         s->m.b / s->m.a * fabs(s->b.at.y0 + z.y);
    const double exponents = 20 + terms + fabs(f.log_scale) +
                             fabs(s->b.at.log_inertia) +
                             exp(fmin(fabs(s->b.at.y0 + z.y), 30));
    const double sums =
        p == PARAMETER_ALPHA || p == PARAMETER_A || p == PARAMETER_B ? unit
        : p == PARAMETER_EPS2 ? unit / material_eps2(&s->m)
                              : 0;
    const double by_x = fabs((double) want.x) + sums;
    const double tol = 8 * 0x1p-53 * exponents;
    const double noise = /* of the differences */
        1e-22 * fabs((double) unit_of(s, p)) / size_of(s, p);

    CHECK(fabs(got[p].x - (double) want.x) <= tol * by_x + noise,
          "law %zu, p = %d, z = (%g, %g): d f_x = %.17g, not %.17g", s->number,
          (int) p, z.x, z.y, got[p].x, (double) want.x);
    const double by_y = fabs((double) want.y) +
                        (p == PARAMETER_R ? fabs(f.direction.y) / s->m.R : 0);
    CHECK(fabs(got[p].y - (double) want.y) <= 4 * tol * by_y + noise,
          "law %zu, p = %d, z = (%g, %g): d f_y = %.17g, not %.17g", s->number,
          (int) p, z.x, z.y, got[p].y, (double) want.y);
}

static void derivatives_are_those_of_the_field(void **state)
{
    uint64_t seed = check_seed();
    struct setting s;
    size_t compared = 0;

    (void) state;
    for (size_t i = 0; i < 3 * LAWS; i++) {
        if (!draw_setting(i, 8, &seed, &s))
            continue;
        for (int k = 0; k < 4; k++) {
            const struct vec2 z = draw_near(-3, 0.5, &seed);
            for (int p = 0; p < PARAMETERS; p++) {
                const enum parameter which = (enum parameter) p;
                if (parameter_missing(&s.law, &s.m, which) ||
                    (which == PARAMETER_C && s.m.c == 0))
                    continue;
                check_parameter(&s, z, which);
                compared++;
            }
        }
    }
    CHECK(compared > 5000, "only %zu", compared);
}

static void what_a_law_does_not_use_moves_nothing_and_is_missing(void **state)
{
    const struct law *law = law_preset_find("dieterich_gen");
    const struct material m = material_bristol_board();
    struct block b;
    struct planar_field f;
    struct vec2 out[PARAMETERS];

    (void) state;
    block_init(&b, law, &m, 0.35L);
    block_anchor(&b, 0.0L, false);
    tape_field(&b.plane, (struct vec2){ 1, -1 }, &f);
    parameter_field(&b, (struct vec2){ 1, -1 }, &f, out);
    for (int p = PARAMETER_C; p <= PARAMETER_R; p++) {
        assert_non_null(parameter_missing(law, &m, (enum parameter) p));
        CHECK(out[p].x == 0 && out[p].y == 0, "p = %d", p);
    }
    assert_null(parameter_missing(law, &m, PARAMETER_EPS2));
    struct material limit = m;
    limit.R = HUGE_VAL;
    law = law_preset_find("spinodal_gen");
    assert_null(parameter_missing(law, &m, PARAMETER_R));
    assert_non_null(parameter_missing(law, &limit, PARAMETER_R));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_are_those_of_the_field),
        cmocka_unit_test(what_a_law_does_not_use_moves_nothing_and_is_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
