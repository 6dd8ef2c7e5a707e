#include "fixtures.h"

#include <math.h>

#include "check.h"
#include "jet_operations.h"

/* Coordinates beyond this are of no interest to any test. */
static const struct box domain = { { -100.0, -100.0 }, { 100.0, 100.0 } };

/* The base field about u: polynomials shifted, the sine by its addition
 * theorem.  A multiple of the double nearest pi stands for that of pi. */
static struct fixture_local local_at(const struct fixture *f, struct vec2 u)
{
    const double x = u.x, y = u.y, a = f->a, b = f->b;
    const double slope = 1.0 - 3.0 * x * x, rest = x - x * x * x;
    const double sine = remainder(x, M_PI) == 0.0 ? 0.0 : sin(x);

    switch (f->base) {
        case FIXTURE_PARABOLA:
            return (struct fixture_local){ .p = { a * x, a },
                                           .q = { x * x - b * y, 2.0 * x, 1.0 },
                                           .b = b };
        case FIXTURE_DUFFING:
            return (struct fixture_local){ .p = { y },
                                           .q = { rest, slope, -3.0 * x, -1.0 },
                                           .y = 1.0 };
        case FIXTURE_PENDULUM:
            return (struct fixture_local){
                .p = { y }, .y = 1.0, .s = cos(x), .c = sine
            };
        case FIXTURE_PITCHFORK:
        default:
            return (struct fixture_local){ .p = { a * rest, a * slope,
                                                  -3.0 * a * x, -a },
                                           .q = { -b * y },
                                           .b = b };
    }
}

/* A cubic: value and derivative. */
static double cubic(const double c[4], double t, double *slope)
{
    *slope = (3.0 * c[3] * t + 2.0 * c[2]) * t + c[1];
    return ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
}

/* The base field at the base offset d; `which` observable's gradient. */
static struct shear_frame base_frame(const struct fixture_local *g,
                                     struct vec2 d, size_t which)
{
    struct shear_frame F = { .z = d };

    F.value.x = cubic(g->p, d.x, &F.slope.xx) + g->y * d.y;
    F.value.y = cubic(g->q, d.x, &F.slope.yx) - g->b * d.y;
    F.value.y += g->s * sin(d.x) + g->c * cos(d.x);
    F.slope.yx += g->s * cos(d.x) - g->c * sin(d.x);
    F.slope.xy = g->y;
    F.slope.yy = -g->b;
    if (which == FIXTURE_X_MOVED)
        F.gradient = (struct vec2){ F.slope.xx, F.slope.xy };
    if (which == FIXTURE_Y_MOVED)
        F.gradient = (struct vec2){ F.slope.yx, F.slope.yy };
    return F;
}

static struct vec2 base_offset(const struct fixture *f, struct vec2 z)
{
    for (size_t i = f->shears; i-- > 0;)
        z = shear_undo(&f->about[i], z);
    return z;
}

/* The moved field at the offset z, at rate 1. */
static struct shear_frame frame_at(const struct fixture *f, struct vec2 z)
{
    struct shear_frame F =
        base_frame(&f->local, base_offset(f, z), FIXTURE_CLOCK);

    for (size_t i = 0; i < f->shears; i++)
        shear_carry(&f->about[i], &F);
    return F;
}

static double tilt_at(const struct fixture *f, struct vec2 z)
{
    return f->tilt.x * z.x + f->tilt.y * z.y;
}

static void jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct fixture *f = ctx;
    const struct shear_frame F = frame_at(f, z);
    const double tilt = tilt_at(f, z), e = exp(-tilt);

    J->field.direction = vec2_scale(e, F.value);
    J->field.log_scale = f->log_rate + tilt;
    J->matrix = (struct mat2){ e * F.slope.xx, e * F.slope.xy, e * F.slope.yx,
                               e * F.slope.yy };
}

static void field(const void *ctx, struct vec2 z, struct planar_field *out)
{
    struct planar_jacobian J;

    jacobian(ctx, z, &J);
    *out = J.field;
}

static jet_pair cubic_jet(const double c[4], size_t k,
                          const jet_pair *const t[4])
{
    jet_pair sum = JET_PAIR(k == 0 ? c[0] : 0.0);

    for (size_t j = 1; j < 4; j++)
        sum += c[j] * t[j][k];
    return sum;
}

/* Series of the base field along (x, y), into v; sine' = cosine x'. */
static void base_jet(const struct fixture_local *g, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair *const v[2])
{
    jet_pair *square = jet_slot(w), *cube = jet_slot(w);
    jet_pair *sine = jet_slot(w), *cosine = jet_slot(w), *dx = jet_slot(w);
    const jet_pair *const power[4] = { NULL, x, square, cube };

    dx[k] = jet_number[k] * x[k];
    square[k] = jet_product(k, x, x);
    cube[k] = jet_product(k, x, square);
    sine[k] = k == 0 ? (jet_pair){ sin(x[0][0]), sin(x[0][1]) }
                     : jet_chain(w, k, x, dx, cosine);
    cosine[k] = k == 0 ? (jet_pair){ cos(x[0][0]), cos(x[0][1]) }
                       : -jet_chain(w, k, x, dx, sine);
    v[0][k] = cubic_jet(g->p, k, power) + g->y * y[k];
    v[1][k] = cubic_jet(g->q, k, power) - g->b * y[k] + g->s * sine[k] +
              g->c * cosine[k];
}

static jet_pair scale_of(const struct fixture *f, const struct jet_work *w)
{
    return (jet_pair){ exp(f->log_rate - w->log_scale[0]),
                       exp(f->log_rate - w->log_scale[1]) };
}

/* The base field's series take the first two slots, where rate_jet finds
 * them. */
static void jet(const void *ctx, struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[])
{
    const struct fixture *f = ctx;
    const jet_pair *z[2] = { x, y }, *v[2], *slope[FIXTURE_SHEARS_MAX];

    if (k == 0)
        for (int i = 0; i < JET_LANES; i++)
            w->log_scale[i] =
                f->log_rate + tilt_at(f, (struct vec2){ x[0][i], y[0][i] });
    w->used = 0;
    jet_pair *const base[2] = { jet_slot(w), jet_slot(w) };
    for (size_t i = f->shears; i-- > 0;)
        slope[i] = shear_jet_undo(&f->about[i], w, k, z);
    base_jet(&f->local, w, k, z[0], z[1], base);
    v[0] = base[0];
    v[1] = base[1];
    for (size_t i = 0; i < f->shears; i++)
        shear_jet_carry(&f->about[i], w, k, slope[i], v);
    fx[k] = v[0][k] * scale_of(f, w);
    fy[k] = v[1][k] * scale_of(f, w);
}

static void rate_gradient(const void *ctx, size_t which, struct vec2 z,
                          double *rate, struct vec2 *gradient)
{
    const struct fixture *f = ctx;
    const double speed = exp(f->log_rate);
    struct shear_frame F = base_frame(&f->local, base_offset(f, z), which);
    const double rates[] = { F.value.x, F.value.y, 1.0 };

    for (size_t i = 0; i < f->shears; i++)
        shear_carry(&f->about[i], &F);
    *rate = speed * rates[which];
    if (gradient)
        *gradient = vec2_scale(speed, F.gradient);
}

static void rate_jet(const void *ctx, size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[])
{
    const struct fixture *f = ctx;
    const jet_pair e = scale_of(f, w);

    (void) x;
    (void) y;
    if (which == FIXTURE_CLOCK)
        rate[k] = k == 0 ? e : JET_PAIR(0.0);
    else
        rate[k] = e * w->slot[which][k];
}

static long double balance(const void *ctx, long double x)
{
    const struct fixture *f = ctx;

    switch (f->base) {
        case FIXTURE_PARABOLA:
            return (long double) f->a * x;
        case FIXTURE_PENDULUM:
            return sinl(x);
        default:
            return x * (1.0L - x) * (1.0L + x);
    }
}

/* Every base equilibrium has Y = 0. */
static long double steady_curve(const void *ctx, long double x)
{
    const struct fixture *f = ctx;
    long double y = 0.0L;

    for (size_t i = 0; i < f->shears; i++) {
        long double p = 0.0L;
        for (size_t k = f->shear[i].degree + 1; k-- > 0;)
            p = p * x + (long double) f->shear[i].coef[k];
        y += p;
    }
    return y;
}

static struct planar_steady steady_of(enum fixture_base base)
{
    const long double turn = 1.0L / sqrtl(3.0L), half_pi = 2.0L * atanl(1.0L);
    struct planar_steady s = { .balance = balance,
                               .y = steady_curve,
                               .turning = { -turn, turn },
                               .turnings = 2,
                               .lo = -10.0L,
                               .hi = 10.0L };

    if (base == FIXTURE_PARABOLA)
        s.turnings = 0;
    if (base == FIXTURE_PENDULUM) {
        s.turning[0] = half_pi;
        s.turning[1] = 3.0L * half_pi;
        s.lo = -1.0L;
        s.hi = 7.0L;
    }
    return s;
}

static void add_equilibrium(struct fixture *f, enum fixture_type type, double x,
                            struct eigen2 lambda)
{
    const double speed = exp(f->log_rate);
    const struct vec2 base = { x, 0.0 };
    struct fixture_equilibrium *e = &f->equilibrium[f->equilibria++];

    lambda.re[0] *= speed;
    lambda.re[1] *= speed;
    lambda.im *= speed;
    *e = (struct fixture_equilibrium){ type, base, base, lambda };
    for (size_t i = 0; i < f->shears; i++)
        e->z = shear_apply(&f->shear[i], e->z);
}

static void list_equilibria(struct fixture *f)
{
    const double a = f->a, b = f->b;
    const struct eigen2 slow = { { -b, a }, 0.0 }, unit = { { -1.0, 1.0 }, 0 };
    const struct eigen2 node = { { fmin(-2.0 * a, -b), fmax(-2.0 * a, -b) },
                                 0 };
    const struct eigen2 well = { { 0.0, 0.0 }, M_SQRT2 };
    const struct eigen2 down = { { 0.0, 0.0 }, 1.0 };
    const bool ab = f->base == FIXTURE_PARABOLA || f->base == FIXTURE_PITCHFORK;

    f->equilibria = 0;
    add_equilibrium(f, FIXTURE_SADDLE, 0.0, ab ? slow : unit);
    if (f->base == FIXTURE_DUFFING) {
        add_equilibrium(f, FIXTURE_CENTRE, -1.0, well);
        add_equilibrium(f, FIXTURE_CENTRE, 1.0, well);
    }
    if (f->base == FIXTURE_PENDULUM) {
        add_equilibrium(f, FIXTURE_CENTRE, M_PI, down);
        add_equilibrium(f, FIXTURE_SADDLE, 2.0 * M_PI, unit);
    }
    if (f->base == FIXTURE_PITCHFORK) {
        add_equilibrium(f, FIXTURE_NODE, -1.0, node);
        add_equilibrium(f, FIXTURE_NODE, 1.0, node);
    }
}

void fixture_center(struct fixture *f, struct vec2 u)
{
    f->centre = f->origin = u;
    f->local = local_at(f, u);
    for (size_t i = 0; i < f->shears; i++) {
        f->about[i] = shear_about(&f->shear[i], f->origin);
        f->origin = shear_apply(&f->shear[i], f->origin);
    }
    f->steady = steady_of(f->base);
    list_equilibria(f);
}

void fixture_plain(struct fixture *f, enum fixture_base base)
{
    *f = (struct fixture){ .base = base, .a = 1.0, .b = 1.0 };
    fixture_center(f, (struct vec2){ 0.0, 0.0 });
}

/* `size`: how far out the shear is of order size / 2. */
static struct shear random_shear(bool vertical, double size, uint64_t *rng)
{
    struct shear s = { .vertical = vertical,
                       .degree = 2 + (size_t) (check_bits(rng) % 3) };
    double unit = 0.3 * size;

    for (size_t k = 0; k <= s.degree; k++) {
        s.coef[k] = check_uniform(rng, -unit, unit);
        unit /= size;
    }
    return s;
}

void fixture_random(struct fixture *f, enum fixture_base base, uint64_t *rng)
{
    const double size = base == FIXTURE_PENDULUM ? 2.0 * M_PI : 1.5;
    const bool first = check_bits(rng) & 1;

    *f = (struct fixture){ .base = base };
    f->a = check_uniform(rng, 0.5, 2.0);
    f->b = check_uniform(rng, 0.5, 2.0);
    f->shears = 2 + (size_t) (check_bits(rng) % 2);
    for (size_t i = 0; i < f->shears; i++)
        f->shear[i] = random_shear(first ^ (i & 1), size, rng);
    f->log_rate = check_uniform(rng, -3.0, 3.0);
    f->tilt.x = check_uniform(rng, -0.5, 0.5);
    f->tilt.y = check_uniform(rng, -0.5, 0.5);
    fixture_center(f, (struct vec2){ 0.0, 0.0 });
}

static bool all_vertical(const struct fixture *f)
{
    for (size_t i = 0; i < f->shears; i++)
        if (!f->shear[i].vertical)
            return false;
    return true;
}

static const char *const names[FIXTURE_BASES] = { "parabola", "duffing",
                                                  "pendulum", "pitchfork" };

static const struct planar_observable observables[FIXTURE_OBSERVABLES] = {
    [FIXTURE_X_MOVED] = { "x_moved", "1", "displacement of base X" },
    [FIXTURE_Y_MOVED] = { "y_moved", "1", "displacement of base Y" },
    [FIXTURE_CLOCK] = { "clock", "1", "time in units of exp(-log_rate)" },
};

struct planar fixture_planar(const struct fixture *f)
{
    return (struct planar){
        .name = names[f->base],
        .axis = { { "x", "1", "first coordinate", false },
                  { "y", "1", "second coordinate", false } },
        .domain = domain,
        .origin = f->origin,
        .field = field,
        .jacobian = jacobian,
        .jet = jet,
        .observables = observables,
        .observable_count = FIXTURE_OBSERVABLES,
        .rate_gradient = rate_gradient,
        .rate_jet = rate_jet,
        .steady = all_vertical(f) ? &f->steady : NULL,
        .ctx = f,
    };
}

struct vec2 fixture_offset(const struct fixture *f, struct vec2 u)
{
    struct vec2 z = vec2_sub(u, f->centre);

    for (size_t i = 0; i < f->shears; i++)
        z = shear_apply(&f->about[i], z);
    return z;
}

struct vec2 fixture_base_point(const struct fixture *f, struct vec2 z)
{
    return vec2_add(f->centre, base_offset(f, z));
}

struct vec2 fixture_manifold_at(const struct fixture *f,
                                enum fixture_manifold kind, double s)
{
    const double sign = kind == FIXTURE_STABLE ? -1.0 : 1.0;
    struct vec2 u = { s, 0.0 };

    if (f->base == FIXTURE_DUFFING)
        u.y = sign * s * sqrt((1.0 - s * M_SQRT1_2) * (1.0 + s * M_SQRT1_2));
    else if (f->base == FIXTURE_PENDULUM)
        u.y = sign * 2.0 * sin(0.5 * s);
    else if (kind == FIXTURE_STABLE)
        u = (struct vec2){ 0.0, s };
    else if (f->base == FIXTURE_PARABOLA)
        u.y = s * s / (2.0 * f->a + f->b);
    return fixture_offset(f, u);
}

double fixture_reach(const struct fixture *f, enum fixture_manifold kind)
{
    if (f->base == FIXTURE_DUFFING)
        return M_SQRT2;
    if (f->base == FIXTURE_PENDULUM)
        return 2.0 * M_PI;
    return f->base == FIXTURE_PITCHFORK && kind == FIXTURE_UNSTABLE ? 1.0
                                                                    : INFINITY;
}

double fixture_implicit(const struct fixture *f, enum fixture_manifold kind,
                        struct vec2 z)
{
    const struct vec2 u = fixture_base_point(f, z);
    const double sign = kind == FIXTURE_STABLE ? -1.0 : 1.0;

    if (f->base == FIXTURE_DUFFING)
        return u.y * u.y - u.x * u.x * (1.0 - 0.5 * u.x * u.x);
    if (f->base == FIXTURE_PENDULUM)
        return u.y - sign * 2.0 * sin(0.5 * u.x);
    if (kind == FIXTURE_STABLE)
        return u.x;
    return f->base == FIXTURE_PARABOLA ? u.y - u.x * u.x / (2.0 * f->a + f->b)
                                       : u.y;
}

void fixture_each(int sheared,
                  void (*check)(const struct fixture *f, double rtol))
{
    uint64_t rng = check_seed();
    struct fixture f;

    for (int base = 0; base < FIXTURE_BASES; base++) {
        fixture_plain(&f, (enum fixture_base) base);
        check(&f, 1e-12);
        check(&f, 1e-6);
    }
    for (int i = 0; i < sheared; i++) {
        fixture_random(&f, (enum fixture_base)(i % FIXTURE_BASES), &rng);
        check(&f, 1e-12);
    }
}
