/* Points of planes side by side have the bits that each has alone: of all laws,
 * near the anchor and far from it, at every width of registers. */
#include "many.h"

#include <math.h>
#include <string.h>

#include "block.h"
#include "graph_kernels.h"
#include "laws.h"
#include "tape_plane.h"

enum { ORDER = 12, WIDTHS = 2 };

static struct block block[JET_MANY];
static struct planar plane[JET_MANY];
static struct vec2 z[JET_MANY];

static const struct planar_many *const many[WIDTHS] = {
#ifdef HAVE_WIDE_LANES
    &tape_many_4, &tape_many_8
#endif
};

static bool is_there(const struct planar_many *m)
{
    return m && m->width <= jet_width();
}

/* Laws i whose materials differ a little, and places up to `far` away; false:
 * there is no such law. */
static bool make(size_t i, double far, uint64_t *rng)
{
    const struct law law = laws_at(i);
    const struct material m = laws_material(rng);
    struct fault why;

    if (law_check(&law, &m, &why) != STATUS_OK)
        return false;
    for (size_t l = 0; l < JET_MANY; l++) {
        struct material own = m;
        own.a *= check_uniform(rng, 0.95, 1.05);
        own.b *= check_uniform(rng, 0.95, 1.05);
        block_init(&block[l], &law, &own, 0.34L);
        block_anchor(&block[l],
                     fminl((long double) check_uniform(rng, -3.0, 3.0),
                           steady_x_max(&law) - 1.0L),
                     false);
        plane[l] = block_planar(&block[l]);
        z[l] = (struct vec2){ check_uniform(rng, -far, far),
                              check_uniform(rng, -far, far) };
    }
    return true;
}

static bool same(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

/* Seen together, or its own answer. */
static void check_look(size_t l, int which, bool slopes,
                       const struct planar_look *seen)
{
    struct planar_look own = { .rate = 0.0 };

    if (slopes)
        tape_jacobian(plane[l].ctx, z[l], &own.J);
    else
        tape_field(plane[l].ctx, z[l], &own.J.field);
    if (which >= 0)
        tape_rate(plane[l].ctx, (size_t) which, z[l], &own.rate,
                  slopes ? &own.gradient : NULL);
    const struct vec2 f = own.J.field.direction, g = seen->J.field.direction;
    CHECK(same(&own.J.field, &seen->J.field, sizeof own.J.field) ||
              (isnan(f.x) && isnan(g.x)) || (isnan(f.y) && isnan(g.y)),
          "lane %zu at (%g, %g): field (%a, %a), not (%a, %a)", l, z[l].x,
          z[l].y, g.x, g.y, f.x, f.y);
    own.unit = exp(-own.J.field.log_scale);
    CHECK(isnan(own.unit) || same(&own.unit, &seen->unit, sizeof own.unit),
          "lane %zu at (%g, %g): unit %a, not %a", l, z[l].x, z[l].y,
          seen->unit, own.unit);
    CHECK(!slopes || isnan(f.x + f.y) ||
              same(&own.J.matrix, &seen->J.matrix, sizeof own.J.matrix),
          "lane %zu at (%g, %g): another matrix", l, z[l].x, z[l].y);
    CHECK(which < 0 || isnan(own.rate) ||
              (same(&own.rate, &seen->rate, sizeof own.rate) &&
               (!slopes ||
                same(&own.gradient, &seen->gradient, sizeof own.gradient))),
          "lane %zu at (%g, %g): rate %a, not %a", l, z[l].x, z[l].y,
          seen->rate, own.rate);
}

static void looks_are_those_of_each_alone(void **state)
{
    static const double far[] = { 0.3, 8.0, 60.0, 600.0 };
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 40 * LAWS; i++) {
        const struct planar *sys[JET_MANY];
        struct planar_look seen[JET_MANY];
        const int which = (int) (i / LAWS) % (BLOCK_OBSERVABLES + 1) - 1;
        if (!make(i % LAWS, far[i / LAWS % 4], &rng))
            continue;
        for (int w = 0; w < WIDTHS && is_there(many[w]); w++) {
            size_t n = 0;
            for (; n < JET_MANY; n++) {
                plane[n].many = many[w];
                sys[n] = &plane[n];
                if (!many_alike(&plane[0], &plane[n]))
                    break;
            }
            many_at(sys, n, z, which, i / 7 % 2, seen);
            for (size_t l = 0; l < n; l++)
                check_look(l, which, i / 7 % 2, &seen[l]);
        }
    }
}

static void series_are_those_of_each_alone(void **state)
{
    static const double far[] = { 0.3, 8.0, 60.0 };
    const struct carry carry = { { BLOCK_EXCESS, BLOCK_WORK }, 2 };
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 9 * LAWS; i++) {
        static struct graph_series own, u[JET_MANY];
        const struct planar *sys[JET_MANY];
        struct graph_series *out[JET_MANY];
        struct graph_start start[JET_MANY];
        if (!make(i % LAWS, far[i / LAWS % 3], &rng))
            continue;
        for (int w = 0; w < WIDTHS && is_there(many[w]); w++) {
            size_t n = 0;
            for (; n < JET_MANY; n++) {
                plane[n].many = many[w];
                sys[n] = &plane[n];
                out[n] = &u[n];
                start[n] = (struct graph_start){ z[n], (int) n % 2,
                                                 0.25 * (double) (n % 3), 1.0 };
                if (!many_alike(&plane[0], &plane[n]))
                    break;
            }
            const size_t done = graph_expand(sys, &carry, ORDER, n, start, out);
            for (size_t l = 0; l < done; l++) {
                out[0] = &own;
                (void) graph_expand(&sys[l], &carry, ORDER, 1, &start[l], out);
                CHECK(isnan(own.at[0][ORDER] + own.at[1][ORDER]) ||
                          same(own.at, u[l].at, sizeof own.at),
                      "law %zu, lane %zu at (%g, %g): another series", i % LAWS,
                      l, z[l].x, z[l].y);
            }
        }
    }
}

/* A number of either sign, from 1e-200 to 1e20; 0. */
static double any_number(uint64_t *rng)
{
    const double size = exp(check_uniform(rng, -460.0, 46.0));
    const double kind = check_uniform(rng, -1.0, 1.0);

    return fabs(kind) < 0.05 ? 0.0 : copysign(size, kind);
}

static double two_terms(const double u[], size_t order, double h)
{
    double power = 1.0, square = h;

    for (size_t k = order - 1; k > 0; k /= 2, square *= square)
        power *= k % 2 ? square : 1.0;
    return power * (fabs(u[order - 1]) + h * fabs(u[order]));
}

static struct graph_end plain_end(size_t order, const double u[], double s)
{
    struct graph_end end = { .value = u[order] };

    for (size_t k = order; k > 0; k--)
        end.value = end.value * s + u[k - 1];
    for (size_t k = order; k > 0; k--)
        end.slope = end.slope * s + (double) k * u[k];
    for (size_t k = order; k > 1; k--)
        end.bend = end.bend * s + (double) (k * (k - 1)) * u[k];
    end.last = two_terms(u, order, fabs(s));
    end.before = two_terms(u, order - 2, fabs(s));
    return end;
}

static double plain_reach(size_t order, const double u[], double to)
{
    double least = HUGE_VAL;

    for (size_t k = order - 1; k <= order; k++)
        if (u[k] != 0.0)
            least = fmin(least, (log(to) - log(fabs(u[k]))) / (double) k);
    return exp(least);
}

/* n series by `step`. */
static void check_steps(const struct graph_kernels *step, size_t n,
                        uint64_t *rng)
{
    const size_t order = 4 + (size_t) check_uniform(rng, 0.0, JET_SIZE - 4);
    double series[JET_MANY][JET_SIZE], s[JET_MANY], to[JET_MANY],
        reach[JET_MANY];
    const double *u[JET_MANY];
    struct graph_end end[JET_MANY];

    for (size_t l = 0; l < JET_MANY; l++) {
        u[l] = series[l];
        s[l] = check_uniform(rng, -3.0, 3.0);
        to[l] = l == 3 ? HUGE_VAL : fabs(any_number(rng));
        for (size_t k = 0; k <= order; k++)
            series[l][k] = any_number(rng);
    }
    step->ends(order, n, u, s, end);
    step->reach(order, n, u, to, reach);
    for (size_t l = 0; l < n; l++) {
        const struct graph_end own = plain_end(order, u[l], s[l]);
        const double far = plain_reach(order, u[l], to[l]);
        CHECK(same(&own, &end[l], sizeof own),
              "order %zu, lane %zu of %zu at %a: another end", order, l, n,
              s[l]);
        CHECK(same(&far, &reach[l], sizeof far),
              "order %zu, lane %zu of %zu to %a: %a, not %a", order, l, n,
              to[l], reach[l], far);
    }
}

static void ends_and_reaches_are_those_of_each_alone(void **state)
{
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < 4000; i++) {
        check_steps(&graph_kernels_2, 1 + i % 2, &rng);
#ifdef HAVE_WIDE_LANES
        if (jet_width() >= 4)
            check_steps(&graph_kernels_4, 1 + i % JET_MANY, &rng);
        if (jet_width() >= 8)
            check_steps(&graph_kernels_8, 1 + i % JET_MANY, &rng);
#endif
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(looks_are_those_of_each_alone),
        cmocka_unit_test(series_are_those_of_each_alone),
        cmocka_unit_test(ends_and_reaches_are_those_of_each_alone),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
