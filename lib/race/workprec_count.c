#include "workprec_count.h"

static void field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct workprec_counter *c = ctx;

    ++*c->calls;
    c->system.field(c->system.ctx, z, f);
}

static void jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct workprec_counter *c = ctx;

    ++*c->calls;
    c->system.jacobian(c->system.ctx, z, J);
}

static void jet(const void *ctx, struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[])
{
    const struct workprec_counter *c = ctx;

    ++*c->calls;
    c->system.jet(c->system.ctx, w, k, x, y, fx, fy);
}

static void rate_gradient(const void *ctx, size_t which, struct vec2 z,
                          double *rate, struct vec2 *gradient)
{
    const struct workprec_counter *c = ctx;

    c->system.rate_gradient(c->system.ctx, which, z, rate, gradient);
}

static void rate_jet(const void *ctx, size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[])
{
    const struct workprec_counter *c = ctx;

    c->system.rate_jet(c->system.ctx, which, w, k, x, y, rate);
}

static long double balance(const void *ctx, long double x)
{
    const struct workprec_counter *c = ctx;

    return c->system.steady->balance(c->system.ctx, x);
}

static long double steady_y(const void *ctx, long double x)
{
    const struct workprec_counter *c = ctx;

    return c->system.steady->y(c->system.ctx, x);
}

struct planar workprec_counted(struct workprec_counter *c)
{
    struct planar counted = c->system;

    if (counted.steady) {
        c->steady = *counted.steady;
        c->steady.balance = balance;
        c->steady.y = steady_y;
        counted.steady = &c->steady;
    }

    counted.field = field;
    counted.jacobian = jacobian;
    counted.jet = counted.jet ? jet : NULL;
    counted.many = NULL;
    counted.rate_gradient = rate_gradient;
    counted.rate_jet = rate_jet;
    counted.ctx = c;
    return counted;
}
