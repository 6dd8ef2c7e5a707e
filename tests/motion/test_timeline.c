/* Events of loose runs against those of tight ones, of any law. */
#include "followed.h"
#include "random_slope.h"

enum { RUN = 200 };

static void holds(const char *run, const char *what, const struct quantity *q,
                  const struct quantity *tight)
{
    const double off = fabs(q->value - tight->value);

    if (quantity_exists(q) && quantity_exists(tight))
        CHECK(off <= q->error + tight->error,
              "%s: %s = %.17g +- %.2g is off by %.2g", run, what, q->value,
              q->error, off);
}

/* Turns are flat: when they are is a matter of rounding. */
static bool is_turn(const struct transient_event *e)
{
    return e->what >= MOMENT_PSI_MIN && e->what <= MOMENT_V_MAX;
}

static bool is_alike(const struct transient_event *a,
                     const struct transient_event *b)
{
    return a->what == b->what && (a->level == b->level || isnan(a->level));
}

/* How many of e's kind, before number `end`. */
static size_t count(const struct transient *t, const struct transient_event *e,
                    size_t end)
{
    size_t n = 0;

    for (size_t i = 0; i < end; i++)
        n += is_alike(&t->event[i], e);
    return n;
}

/* Number `nth` of e's kind. */
static const struct transient_event *find(const struct transient *t,
                                          const struct transient_event *e,
                                          size_t nth)
{
    size_t i = 0;

    while (!is_alike(&t->event[i], e) || nth-- > 0)
        i++;
    return &t->event[i];
}

static int events_hold(const char *run, const struct transient *t,
                       const struct transient *tight)
{
    int compared = 0;

    for (size_t i = 0; i < t->events; i++) {
        const struct transient_event *e = &t->event[i];
        const size_t all = count(t, e, t->events);
        if (is_turn(e))
            continue;
        CHECK(count(tight, e, tight->events) == all,
              "%s: %s, level %g: %zu times, and %zu", run,
              moment_names[e->what], e->level, all,
              count(tight, e, tight->events));
        const struct transient_event *f = find(tight, e, count(t, e, i));
        holds(run, moment_names[e->what], &e->time, &f->time);
        holds(run, "slip", &e->slip, &f->slip);
        holds(run, "v", &e->v, &f->v);
        holds(run, "psi", &e->psi, &f->psi);
        holds(run, "mu", &e->mu, &f->mu);
        compared++;
    }
    return compared;
}

static int run_holds(const struct slope *s, double v, double psi, double rtol)
{
    char run[RUN];

    snprintf(run, RUN, "alpha %.17g, v %.17g, psi %.17g, rtol %g",
             s->scene.alpha, v, psi, rtol);
    struct transient_options o = transient_defaults(&s->scene);
    int compared = 0;

    o.rtol = 1e-13;
    struct transient tight = follow(s, v, psi, &o);
    o.rtol = rtol;
    struct transient t = follow(s, v, psi, &o);
    if (t.sum.end == tight.sum.end) {
        holds(run, "time", &t.sum.time, &tight.sum.time);
        holds(run, "slip", &t.sum.slip, &tight.sum.slip);
        holds(run, "mu_mean", &t.sum.mu_mean, &tight.sum.mu_mean);
        compared = events_hold(run, &t, &tight) + events_hold(run, &tight, &t);
    }
    transient_free(&t);
    transient_free(&tight);
    return compared;
}

static void a_loose_run_has_the_events_of_a_tight_one(void **state)
{
    static const double rtol[] = { 1e-3, 1e-6, 1e-9, 1e-11 };
    const char *const more[] = { "products=[knees]", NULL };
    uint64_t seed = check_seed() + 1;
    int compared = 0;

    (void) state;
    for (size_t law = 0; law < random_presets(); law++) {
        struct slope s;
        random_slope_of(&s, law, &seed, more);
        const struct block *b = &s.study.slider.block;
        for (int k = 0; k < 4; k++) {
            const double v = b->at.v0 * exp(check_uniform(&seed, -5, 8));
            const double y = check_uniform(&seed, -6, 5);
            const double psi = law_psi_is_log(&s.scene.law)
                                   ? b->at.y0 + y
                                   : b->at.psi0 * exp(y);
            compared += run_holds(&s, v, psi, rtol[k % 4]);
        }
        slope_free(&s);
    }
    CHECK(compared > 400, "%d events compared", compared);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_loose_run_has_the_events_of_a_tight_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
