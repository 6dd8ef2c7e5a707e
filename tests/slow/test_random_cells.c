/* Bars of cells never lie: fields of random states of random laws, materials
 * and slopes, one by one and from the patches of a grid, against whole orbits
 * followed by L-stable steps at 1e-11.
 *
 * CELL_STATES=2000 tries more states than a test can afford, and grids of SIDE
 * cells a side for FEW; CHECK_SEED others.
 */
#include "fields_of.h"

#include "any_law.h"
#include "cells_of.h"
#include "peak.h"
#include "tolerance.h"

enum { EACH = 10, SIDE = 64, FEW = 24 };

static size_t states_asked(size_t usual)
{
    const char *asked = getenv("CELL_STATES");
    return asked ? (size_t) strtoul(asked, NULL, 10) : usual;
}

/* ---- random slopes ------------------------------------------------------- */

/* A slope of any law, with what finds its cells. */
struct draw {
    struct slope s;
    struct fast_cells fast;
    char name[DRAWN_NAME];
};

/* Until it is one that can be studied. */
static void draw(size_t i, uint64_t *rng, const char *const more[],
                 struct draw *d)
{
    struct scene *const s = &d->s.scene;
    struct fault why;

    for (int attempt = 0; attempt < 200; attempt++) {
        slope_scene(s, "spinodal", NULL, "0.34", more);
        s->cell_rtol = pow(10.0, -4.0 - (double) (check_bits(rng) % 6));
        if (drawn_law(i, rng, s) && drawn_slope(rng, s) &&
            study_run(&d->s.study, s, NULL, &why) == STATUS_OK) {
            drawn_name(i, s, d->name);
            return;
        }
        scene_free(s);
    }
    fail_msg("no slope");
}

/* Anywhere near the steady state that the chart is centred on. */
static struct vec2 draw_state(const struct draw *d, uint64_t *rng)
{
    const struct planar *p = &d->s.study.slider.plane.system;
    struct vec2 z;

    do
        z = (struct vec2){ p->origin.x + check_uniform(rng, -10, 10),
                           p->origin.y + check_uniform(rng, -5, 5) };
    while (!box_holds(p->domain, z));
    return z;
}

/* ---- orbits to compare with ---------------------------------------------- */

struct tight {
    enum fate fate;
    double value[CELL_FIELDS], error[CELL_FIELDS];
};

static void follow(const struct draw *d, struct vec2 z, double rtol, bool peaks,
                   struct tight *t)
{
    struct peaks p = { .x = (double) NAN, .mu = (double) NAN };
    struct fate_result r;

    assert_int_equal(fate_find(&d->s.study.slider, z, rtol, true, NULL, &r), 0);
    if (peaks)
        assert_int_equal(peaks_find(&d->s.study.slider, z, rtol, r.steps, &p),
                         0);
    *t = (struct tight){
        r.fate,
        { r.slip.value, r.time.value, r.mu_mean.value, exp(p.x), p.mu },
        { r.slip.error, r.time.error, r.mu_mean.error, 0.0, 0.0 }
    };
}

/* How far the field is off, over its bar and what is left of the orbit; no
 * number where either lacks it. */
static double off_by(const struct cell *c, enum cell_field k,
                     const struct tight *t)
{
    const double off = fabs(value(c, k) - t->value[k]);
    return off == 0.0 ? 0.0 : off / (error(c, k) + t->error[k]);
}

/* An orbit's own errors show as the difference to one at a finer tolerance. */
static void widen(const struct draw *d, struct vec2 z, bool peaks,
                  struct tight *t)
{
    const struct tight before = *t;

    follow(d, z, 1e-13, peaks, t);
    for (int k = 0; k < CELL_FIELDS; k++)
        t->error[k] += fabs(t->value[k] - before.value[k]);
    if (t->fate != before.fate)
        t->fate = FATE_UNDECIDED;
}

/* Whether two orbits agree on it to nine digits at the least, as they do not
 * where psi rounds to psi_ss long before the block rests. */
static bool is_sharp(const struct tight *t, enum cell_field k)
{
    return t->error[k] <= 1e-9 * fabs(t->value[k]);
}

/* ---- checks -------------------------------------------------------------- */

/* Of blocks that rest in finite time (1) and of all others (0): those that
 * rest, or are undecided, come by the draw, all or none of its states. */
struct tally {
    size_t states, compared, fields[2], blurred[2], wide;
    double worst;
};

static void check_field(const struct draw *d, struct vec2 z,
                        const struct cell *c, enum cell_field k,
                        const struct tight *t, struct tally *tally)
{
    const char *name = record_cell.fields[1 + 2 * k].name;
    const double off = off_by(c, k, t), bar = error(c, k);
    const bool rests = c->exit_reason == FATE_REST_FINITE;

    CHECK(isnan(value(c, k)) == isnan(bar) && !(bar < 0.0),
          "%s (%.17g, %.17g) %s: %g +- %g", d->name, z.x, z.y, name,
          value(c, k), bar);
    if (isnan(value(c, k)))
        return;
    if (isnan(off) || !is_sharp(t, k)) {
        tally->blurred[rests]++;
        return;
    }
    CHECK(off <= 1.0, "%s (%.17g, %.17g) %s: %.16g +- %.3g, not %.16g +- %.3g",
          d->name, z.x, z.y, name, value(c, k), bar, t->value[k], t->error[k]);
    tally->fields[rests]++;
    tally->wide += bar > 1.0001 * d->s.scene.cell_rtol * value(c, k);
    tally->worst = fmax(tally->worst, off);
}

/* What exists: the peaks of whatever does not run away, but no largest friction
 * at rest; slip, time and mean of what is arrested, but no mean over a slip
 * that is hardly known. */
static void check_existence(const struct draw *d, struct vec2 z,
                            const struct cell *c)
{
    const bool runs = c->exit_reason == FATE_RUNAWAY;
    const bool rests = c->exit_reason == FATE_REST_FINITE;
    const bool fades = c->exit_reason == FATE_REST_ASYMPTOTIC;
    const bool slips = !runs && !(fades && isnan(c->slip));
    const bool is_known = c->slip_error < 0.5 * c->slip;
    const bool has_mean =
        slips && (is_known || (c->slip > 0.0 && isfinite(c->mu_mean)));
    const bool is[CELL_FIELDS] = { slips, !runs && !fades, has_mean, !runs,
                                   !runs && !rests };

    for (int k = 0; k < CELL_FIELDS; k++)
        CHECK(isnan(value(c, (enum cell_field) k)) == !is[k],
              "%s (%.17g, %.17g) %s: %s = %g", d->name, z.x, z.y,
              fate_names[c->exit_reason], record_cell.fields[1 + 2 * k].name,
              value(c, (enum cell_field) k));
}

/* The energies at arrest: those of nodes to within what arrest means. */
static void end_energies(const struct study *s, const struct cell *c,
                         double end[2])
{
    const double far = exp(2.0 * TOL_ARREST * 1.0001);
    const bool is_node =
        c->exit_reason == FATE_CREEP || c->exit_reason == FATE_SLIDING;

    end[0] = is_node ? HUGE_VAL : 0.0;
    end[1] = 0.0;
    for (size_t i = 0; i < s->slider.plane.equilibria && is_node; i++) {
        const struct equilibrium *e = &s->slider.plane.equilibrium[i];
        const double v = exp(e->z.x);
        const double energy =
            0.5 * material_eps2(&s->slider.block.material) * v * v;
        if ((int) i == slider_saddle(&s->slider) ||
            (int) fate_of_node(&s->slider, e) != c->exit_reason)
            continue;
        end[0] = fmin(end[0], energy / far);
        end[1] = fmax(end[1], energy * far);
    }
}

/* (27) */
static void check_energy(const struct draw *d, struct vec2 z,
                         const struct cell *c)
{
    const struct study *s = &d->s.study;
    const double sine = sin(s->scene->alpha), cosine = cos(s->scene->alpha);
    const double eps2 = material_eps2(&s->slider.block.material);
    const double start = 0.5 * eps2 * exp(2.0 * z.x);
    const double pull = sine * c->slip, work = cosine * c->mu_mean * c->slip;
    const double slack = c->slip_error * (sine + cosine * c->mu_mean) +
                         cosine * c->slip * c->mu_mean_error +
                         1e-14 * (start + pull + work);
    const double now = start + pull - work;
    double end[2];

    end_energies(s, c, end);
    CHECK(now >= end[0] - slack && now <= end[1] + slack,
          "%s (%.17g, %.17g): energy %g, not %g..%g, slack %g", d->name, z.x,
          z.y, now, end[0], end[1], slack);
}

static void check_cell(const struct draw *d, struct vec2 z,
                       const struct cell *c, unsigned which,
                       struct tally *tally)
{
    bool is_off = false;
    struct tight t;

    tally->states++;
    if (c->exit_reason == FATE_UNDECIDED)
        return;
    follow(d, z, 1e-11, which == ALL, &t);
    for (int k = 0; k < CELL_FIELDS; k++)
        is_off = is_off || off_by(c, (enum cell_field) k, &t) > 0.5;
    if (is_off || (int) t.fate != c->exit_reason)
        widen(d, z, which == ALL, &t);
    if (t.fate == FATE_UNDECIDED)
        return;
    CHECK((int) t.fate == c->exit_reason, "%s (%.17g, %.17g): %s, not %s",
          d->name, z.x, z.y, fate_names[c->exit_reason], fate_names[t.fate]);
    for (int k = 0; k < CELL_FIELDS; k++)
        if (which >> k & 1u)
            check_field(d, z, c, (enum cell_field) k, &t, tally);
    if (which == ALL)
        check_existence(d, z, c);
    if (isfinite(c->mu_mean))
        check_energy(d, z, c);
    tally->compared++;
}

static void report(const char *what, const struct tally *t)
{
    const size_t *fields = t->fields, *blurred = t->blurred;

    print_message("# %s: %zu of %zu states compared, %zu fields, the worst at "
                  "%.2f of its bar, %zu bars wider than asked for; orbits know "
                  "%zu fields less well, and %zu of %zu at rest\n",
                  what, t->compared, t->states, fields[0] + fields[1], t->worst,
                  t->wide, blurred[0], blurred[1], fields[1] + blurred[1]);
    CHECK(t->compared + EACH > t->states - t->states / 10, "%zu of %zu",
          t->compared, t->states);
    CHECK(fields[0] > 5 * blurred[0], "%zu and %zu", fields[0], blurred[0]);
    CHECK(fields[1] > 0 || blurred[1] == 0, "0 and %zu", blurred[1]);
}

/* ---- states -------------------------------------------------------------- */

static void errors_of_random_states_lie_within_their_bars(void **state)
{
    const size_t draws = states_asked(120) / EACH;
    static struct draw d;
    struct tally tally = { 0 };
    uint64_t rng = check_seed();
    struct vec2 z[EACH];
    struct cell c[EACH];

    (void) state;
    for (size_t i = 0; i < draws; i++) {
        draw(i, &rng, steady_only, &d);
        assert_int_equal(fast_cells_init(&d.fast, &d.s.study.slider, NULL), 0);
        for (int k = 0; k < EACH; k++)
            z[k] = draw_state(&d, &rng);
        assert_int_equal(fast_cells_find(&d.fast, z, EACH, d.s.scene.cell_rtol,
                                         ALL, NULL, c, NULL),
                         0);
        for (int k = 0; k < EACH; k++)
            check_cell(&d, z[k], &c[k], ALL, &tally);
        fast_cells_free(&d.fast);
        slope_free(&d.s);
    }
    report("one by one", &tally);
}

static void errors_of_cells_of_random_grids_lie_within_their_bars(void **state)
{
    const size_t side = getenv("CELL_STATES") ? SIDE : FEW;
    const char *const grid[] = { "products=[slip, time, friction]",
                                 side == FEW
                                     ? "basins={cells: [24, 24], audit: 0}"
                                     : "basins={cells: [64, 64], audit: 0}",
                                 NULL };
    const unsigned which =
        1u << CELL_SLIP | 1u << CELL_TIME | 1u << CELL_MU_MEAN;
    const size_t draws = states_asked(40) / EACH;
    static struct cell row[SIDE];
    static struct draw d;
    struct tally tally = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    for (size_t i = 0; i < draws; i++) {
        draw(i, &rng, grid, &d);
        const struct basin_map *m = &d.s.study.basins;
        for (int k = 0; k < EACH; k++) {
            const size_t at = check_bits(&rng) % (side * side);
            const struct vec2 z = { m->x[at % side], m->y[at / side] };
            assert_int_equal(
                fields_find(&d.s.study.fields, at / side, 1, NULL, row), 0);
            check_cell(&d, z, &row[at % side], which, &tally);
        }
        slope_free(&d.s);
    }
    report("of grids", &tally);
}

/* ---- accuracy ------------------------------------------------------------ */

static void check_accuracy(const char *law, const char *form, size_t states,
                           uint64_t *rng)
{
    static struct draw d;
    struct cell c;
    struct tight t;

    slope_make(&d.s, law, form, "0.34", steady_only);
    assert_int_equal(fast_cells_init(&d.fast, &d.s.study.slider, NULL), 0);
    for (size_t i = 0; i < states; i++) {
        const struct vec2 z = { check_uniform(rng, -8, 9),
                                check_uniform(rng, -5, 5) };
        assert_int_equal(
            fast_cells_find(&d.fast, &z, 1, 1e-6, ALL, NULL, &c, NULL), 0);
        if (c.exit_reason == FATE_RUNAWAY || c.exit_reason == FATE_UNDECIDED)
            continue;
        follow(&d, z, 1e-11, false, &t);
        CHECK(fabs(c.slip - t.value[CELL_SLIP]) <= 1e-6 * c.slip &&
                  fabs(c.time - t.value[CELL_TIME]) <= 1e-6 * c.time,
              "%s %s (%.17g, %.17g): slip %.12g, not %.12g; time %.12g, not "
              "%.12g",
              law, form, z.x, z.y, c.slip, t.value[CELL_SLIP], c.time,
              t.value[CELL_TIME]);
    }
    fast_cells_free(&d.fast);
    slope_free(&d.s);
}

static void slip_and_time_are_right_to_six_digits(void **state)
{
    const size_t each = states_asked(40) / 4;
    uint64_t rng = check_seed();

    (void) state;
    check_accuracy("spinodal_gen", "asinh", each, &rng);
    check_accuracy("spinodal_gen", "log", each, &rng);
    check_accuracy("dieterich_gen", "asinh", each, &rng);
    check_accuracy("dieterich_gen", "log", each, &rng);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_random_states_lie_within_their_bars),
        cmocka_unit_test(errors_of_cells_of_random_grids_lie_within_their_bars),
        cmocka_unit_test(slip_and_time_are_right_to_six_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
