/* Arrivals are found on the polynomials of a step, which is then taken again to
 * just there.  An orbit is followed twice: the difference is the
 * error. */
#include "quad_orbit.h"

#include <math.h>

#include "quad_course.h"
#include "quad_peak.h"
#include "quad_rest.h"
#include "rest_form.h"
#include "tolerance.h"

enum { SCAN = 64, POLISH = 4 };
/* Steps on which a block that only fades is followed. */
enum { FALLS = 60 };

/* Of the finer run, over the tolerance of the coarser one. */
static const double finer = 0.1;
/* A rest is one when so little of time (slip) so far is left. */
static const double soon = 1e-22;
/* The same of one that cannot be followed further. */
static const double at_all = 1e-10;
/* Of two runs' difference, and of the finer one's tolerance squared, what
 * errors are at most. */
static const double twice = 2.0, square = 1000.0;
/* Relative errors of peaks by that of where they are. */
static const double placed = 1e-18;

/* ---- slopes -------------------------------------------------------------- */

/* The root of the force balance next to x, which doubles know. */
static quad root_near(const struct study *s, double x)
{
    const struct law *law = &s->slider.block.law;
    const struct material *m = &s->slider.block.material;
    const quad tangent = (quad) s->slider.block.tan_alpha;

    for (double off = 1e-15 * fmax(fabs(x), 1.0); off < 1e-3; off *= 4.0) {
        const quad lo = (quad) x - (quad) off, hi = (quad) x + (quad) off;
        if ((quad_block_mu_ss(law, m, lo) < tangent) !=
            (quad_block_mu_ss(law, m, hi) < tangent))
            return quad_block_equilibrium(law, m, tangent, lo, hi);
    }
    return (quad) x;
}

void quad_slope_init(struct quad_slope *q, const struct study *s)
{
    const struct law *law = &s->slider.block.law;
    const struct material *m = &s->slider.block.material;
    const size_t home =
        slider_saddle(&s->slider) >= 0 ? (size_t) slider_saddle(&s->slider) : 0;
    const quad x = s->slider.plane.equilibria > 0
                       ? root_near(s, s->slider.plane.equilibrium[home].z.x)
                       : (quad) s->slider.block.at.x0;

    quad_method_init(&q->method);
    q->study = s;
    q->nodes = 0;
    quad_block_anchor(law, m, (quad) s->slider.block.tan_alpha, x,
                      s->slider.plane.equilibria > 0, &q->at);
    for (size_t i = 0; i < s->slider.plane.equilibria; i++) {
        if ((int) i == slider_saddle(&s->slider))
            continue;
        const quad at =
            i == home ? x : root_near(s, s->slider.plane.equilibrium[i].z.x);
        q->node[q->nodes][0] = at - x;
        q->node[q->nodes][1] = quad_block_y_ss(law, m, at) - q->at.y0;
        q->fate[q->nodes++] =
            fate_of_node(&s->slider, &s->slider.plane.equilibrium[i]);
    }
}

/* ---- ends ---------------------------------------------------------------- */

/* Where a step may end: in the box of arrest of a node, or at a time. */
struct goal {
    size_t node;
    quad time; /* 0: the node */
};

/* What is missing there: nothing, or less, once it is reached. */
static quad missing(const struct quad_slope *q, const struct goal *g,
                    const quad u[])
{
    if (g->time > 0)
        return g->time - u[QUAD_TIME];
    const quad x = fabsq(u[QUAD_X] - q->node[g->node][0]);
    const quad y = fabsq(u[QUAD_Y] - q->node[g->node][1]);

    return (x > y ? x : y) - (quad) TOL_ARREST;
}

static quad missing_at(const struct quad_course *c, const struct quad_radau *w,
                       const struct goal *g, quad theta)
{
    quad u[QUAD_DIM];

    for (int k = 0; k <= QUAD_TIME; k++)
        u[k] = c->u[k] + quad_radau_gain(w, k, theta);
    return missing(c->slope, g, u);
}

/* Whether the step may come near the node at all. */
static bool comes_near(const struct quad_course *c, const struct quad_radau *w,
                       size_t node)
{
    for (int k = 0; k < 2; k++) {
        quad lo = 0, hi = 0;
        for (int i = 0; i < QUAD_STAGES; i++) {
            lo = w->z[i][k] < lo ? w->z[i][k] : lo;
            hi = w->z[i][k] > hi ? w->z[i][k] : hi;
        }
        const quad at = c->slope->node[node][k] - c->u[k];
        const quad more = (hi - lo) / 4 + 2 * (quad) TOL_ARREST;
        if (at < lo - more || at > hi + more)
            return false;
    }
    return true;
}

/* The first part of the step where the goal is reached; above 1: none. */
static quad part_to(const struct quad_course *c, const struct quad_radau *w,
                    const struct goal *g)
{
    quad lo = 0, hi = 2;

    if (g->time == 0 && !comes_near(c, w, g->node))
        return hi;
    for (int i = 1; i <= SCAN && hi > 1; i++) {
        const quad theta = (quad) i / SCAN;
        *(missing_at(c, w, g, theta) <= 0 ? &hi : &lo) = theta;
    }
    for (int i = 0; i < 50 && hi <= 1; i++) {
        const quad mid = (lo + hi) / 2;
        *(missing_at(c, w, g, mid) <= 0 ? &hi : &lo) = mid;
    }
    return hi;
}

/* The step to just there, from a good guess of its part. */
static bool step_to(const struct quad_course *c, const struct quad_radau *whole,
                    const struct goal *g, quad theta, struct quad_radau *w,
                    quad to[QUAD_DIM])
{
    quad before = 0, off = 0;

    for (int i = 0; i < POLISH; i++) {
        if (!quad_course_part(c, whole, theta, w, to))
            return false;
        const quad now = missing(c->slope, g, to), last = theta;
        const quad slope =
            i == 0 ? (missing_at(c, whole, g, theta) -
                      missing_at(c, whole, g, theta * (1 - (quad) 1e-8))) /
                         (theta * (quad) 1e-8)
                   : (now - off) / (theta - before);
        if (fabsq(now) < (quad) 1e-30 || (i > 0 && now == off))
            return true;
        theta -= now / slope;
        before = last;
        off = now;
    }
    return true;
}

/* Of who is in the node's box.  One that holds the saddle, too, arrests only
 * what is in the saddle's quadrant of the node, which none leaves. */
static enum fate fate_in(const struct quad_slope *q, size_t node,
                         const quad u[])
{
    const quad *n = q->node[node], most = (quad) TOL_ARREST;
    const bool shared = slider_saddle(&q->study->slider) >= 0 &&
                        fabsq(n[0]) <= most && fabsq(n[1]) <= most;

    return shared && !(u[QUAD_X] * n[0] > 0 && u[QUAD_Y] * n[1] > 0)
               ? FATE_UNDECIDED
               : q->fate[node];
}

/* The nodes' boxes: true where the step ends in one. */
static bool find_arrival(struct quad_course *c, struct quad_radau *w,
                         quad to[QUAD_DIM])
{
    struct goal g = { .time = 0 };
    quad first = 2;

    for (size_t i = 0; i < c->slope->nodes; i++) {
        const quad theta = part_to(c, w, &(struct goal){ .node = i });
        if (theta < first) {
            first = theta;
            g.node = i;
        }
    }
    if (first > 1)
        return false;
    const struct quad_radau whole = *w;
    c->fate = step_to(c, &whole, &g, first, w, to)
                  ? fate_in(c->slope, g.node, to)
                  : FATE_UNDECIDED;
    return true;
}

/* How blocks of the law come to rest. */
static struct rest_form rest_of(const struct quad_course *c)
{
    const struct block *b = &c->slope->study->slider.block;

    return rest_form_at(b);
}

/* Where v falls for ever. */
static bool is_falling(const struct quad_course *c)
{
    const struct study *s = c->slope->study;

    return slider_saddle(&s->slider) == 0
               ? c->u[QUAD_X] < 0 && c->u[QUAD_Y] > 0
               : s->slider.plane.equilibria == 0 && c->slope->at.force0 < 0;
}

/* What is left of one that stops but cannot be followed so far: psi and psi_ss
 * agree to all digits long before v = 0. */
static void add_rest(struct quad_course *c)
{
    const struct study *s = c->slope->study;
    const struct rest_form rest = rest_of(c);
    quad time, slip, error[2];

    if (rest.fate != FATE_REST_FINITE || !(c->left[0] > 0) ||
        !quad_rest_left(c, QUAD_LEFT_TIME, &time, &error[0]) ||
        !quad_rest_left(c, QUAD_LEFT_SLIP, &slip, &error[1]))
        return;
    c->u[QUAD_TIME] += time;
    c->u[QUAD_SLIP] += slip;
    c->u[QUAD_WORK] += (quad) s->slider.block.tan_alpha * slip;
    c->left[0] = error[0];
    c->left[1] = error[1];
    c->fate = FATE_REST_FINITE;
}

/* Whether it stops within this part of its time, for psi grows within as little
 * of it: v that only falls, as where friction first takes its speed, does so to
 * where friction balances gravity. */
static bool is_stopping(const struct quad_course *c, double part)
{
    const quad soon_is = (quad) part * c->u[QUAD_TIME];

    return c->left[0] < soon_is && c->du[QUAD_Y] * soon_is > c->du[QUAD_TIME];
}

/* What is left of a block that stops, and its fate where that is nothing.  One
 * that fades does so as psi grows, from when that shows. */
static void find_rest(struct quad_course *c)
{
    const struct study *s = c->slope->study;
    const struct rest_form rest = rest_of(c);
    const bool falls = is_falling(c);
    const quad v = expq(c->slope->at.x0 + c->u[QUAD_X]);
    const quad rate = -c->du[QUAD_X] / c->du[QUAD_TIME];
    const quad grows = c->du[QUAD_Y] / c->du[QUAD_TIME];

    c->left[0] = c->left[1] = 0;
    if (slider_saddle(&s->slider) > 0 || !(rate > 0))
        return;
    if (rest.fate == FATE_REST_FINITE) {
        c->left[0] = (quad) rest.power / rate;
        c->left[1] = v * c->left[0];
        if (is_stopping(c, soon))
            c->fate = FATE_REST_FINITE;
    } else if (falls && grows > 0) {
        c->left[1] = v * (c->u[QUAD_TIME] + 1 / grows);
        c->is_over = c->left[1] < (quad) soon * c->u[QUAD_SLIP];
        if (!c->is_over && ++c->falls > FALLS) {
            c->is_over = true;
            quad_rest_fade(c, rest.has_slip);
        }
        if (c->is_over && rest.fate == FATE_REST_ASYMPTOTIC)
            c->fate = rest.fate;
    }
}

/* v -> 0, v -> inf; true where that is certain and nothing is left. */
static bool find_end(struct quad_course *c)
{
    const struct study *s = c->slope->study;
    const bool runs =
        c->u[QUAD_X] > 0 && c->u[QUAD_Y] < 0 &&
        slider_saddle(&s->slider) >= 0 &&
        (size_t) slider_saddle(&s->slider) + 1 == s->slider.plane.equilibria;

    if (runs || c->slope->at.x0 + c->u[QUAD_X] > 690)
        c->fate = FATE_RUNAWAY;
    else
        find_rest(c);
    return c->is_over || c->fate != FATE_UNDECIDED;
}

/* ---- orbits -------------------------------------------------------------- */

/* One step; false where the orbit has ended, or none is short enough. */
static bool advance(struct quad_course *c)
{
    struct quad_radau w;
    quad to[QUAD_DIM];
    double excess;

    if (!quad_course_take(c, &w, to, &excess))
        return false;
    const bool arrived = find_arrival(c, &w, to);
    quad_peak_step(c, &w);
    quad_course_move(c, &w, to, excess);
    quad_peak_note(c, c->u);
    return !arrived && !find_end(c);
}

static void follow(const struct quad_slope *q, quad x, quad y, double tol,
                   struct quad_course *c)
{
    quad_course_start(c, q, x, y, tol);
    quad_peak_start(c);
    for (size_t i = 0; i < q->nodes; i++)
        if (missing(q, &(struct goal){ .node = i }, c->u) <= 0)
            c->fate = fate_in(q, i, c->u);
    while (c->fate == FATE_UNDECIDED && advance(c))
        ;
    if (c->fate == FATE_UNDECIDED && !c->is_over)
        add_rest(c);
    if (c->fate == FATE_UNDECIDED && !c->is_over && is_falling(c) &&
        rest_of(c).fate == FATE_REST_ASYMPTOTIC &&
        quad_rest_fade(c, rest_of(c).has_slip))
        c->fate = FATE_REST_ASYMPTOTIC;
    if (c->fate == FATE_UNDECIDED && c->left[0] > 0 && is_stopping(c, at_all))
        c->fate = FATE_REST_FINITE;
}

bool quad_orbit_at(const struct quad_slope *q, quad x, quad y, quad time,
                   double tol, quad z[2])
{
    const struct goal g = { .time = time };
    struct quad_course c;
    struct quad_radau whole, w;
    quad to[QUAD_DIM] = { 0 };
    double excess;

    quad_course_start(&c, q, x, y, tol);
    bool good = quad_course_take(&c, &whole, to, &excess);
    while (good && to[QUAD_TIME] < time) {
        quad_course_move(&c, &whole, to, excess);
        good = quad_course_take(&c, &whole, to, &excess);
    }
    good = good && step_to(&c, &whole, &g, part_to(&c, &whole, &g), &w, to);
    z[0] = q->at.x0 + to[QUAD_X];
    z[1] = q->at.y0 + to[QUAD_Y];
    return good;
}

/* (27) */
static double defect_of(const struct quad_course *c, quad x)
{
    const struct study *s = c->slope->study;
    const struct material *m = &s->slider.block.material;
    const quad tangent = (quad) s->slider.block.tan_alpha;
    const quad eps2 = (quad) m->V_star * m->V_star / ((quad) m->g * m->L);
    const quad half = eps2 * sqrtq(1 + tangent * tangent) / 2;
    const quad v0 = expq(x), v1 = expq(c->slope->at.x0 + c->u[QUAD_X]);
    const quad term[] = { half * v1 * v1, -half * v0 * v0,
                          -tangent * c->u[QUAD_SLIP], c->u[QUAD_WORK] };
    quad sum = 0, most = 0;

    for (int i = 0; i < 4; i++) {
        sum += term[i];
        most = fabsq(term[i]) > most ? fabsq(term[i]) : most;
    }
    return (double) (fabsq(sum) / most);
}

static void read_values(const struct quad_course *c, quad value[CELL_FIELDS])
{
    value[CELL_SLIP] = c->u[QUAD_SLIP];
    value[CELL_TIME] = c->u[QUAD_TIME];
    value[CELL_MU_MEAN] = c->u[QUAD_WORK] / c->u[QUAD_SLIP];
    value[CELL_V_PEAK] = c->v_peak;
    value[CELL_MU_PEAK] = c->mu_peak;
}

/* Which fields an orbit with that end has. */
static bool has(enum fate fate, enum cell_field k, const struct quad_course *c)
{
    if (fate == FATE_RUNAWAY || fate == FATE_UNDECIDED)
        return false;
    if (k == CELL_TIME)
        return fate != FATE_REST_ASYMPTOTIC;
    if (k == CELL_MU_PEAK)
        return fate != FATE_REST_FINITE;
    if (k == CELL_V_PEAK)
        return true;
    return (fate != FATE_REST_ASYMPTOTIC || rest_of(c).has_slip) &&
           (k == CELL_SLIP || c->u[QUAD_SLIP] > 0);
}

/* What the difference of two runs may not show: chance, what is left, and how
 * well peaks are placed. */
static quad more_of(const struct quad_course *c, enum cell_field k, quad value)
{
    const quad size = fabsq(value), part = c->left[1] / c->u[QUAD_SLIP];
    const quad chance = (quad) (square * c->tol * c->tol) * size;
    const quad tangent = (quad) c->slope->study->slider.block.tan_alpha;
    const quad apart = c->falls > FALLS ? fabsq(value - tangent) : size;

    switch (k) {
        case CELL_TIME:
            return chance + c->left[0];
        case CELL_SLIP:
            return chance + c->left[1];
        case CELL_MU_MEAN:
            return chance + part * apart;
        default:
            return (quad) placed * size;
    }
}

void quad_orbit_find(const struct quad_slope *q, quad x, quad y, double tol,
                     struct quad_orbit *out)
{
    struct quad_course coarse, fine;
    quad before[CELL_FIELDS];

    follow(q, x, y, tol, &coarse);
    follow(q, x, y, tol * finer, &fine);
    read_values(&coarse, before);
    read_values(&fine, out->value);
    out->fate = fine.fate == coarse.fate ? fine.fate : FATE_UNDECIDED;
    out->steps = coarse.steps + fine.steps;
    out->defect = defect_of(&fine, x);
    for (int k = 0; k < CELL_FIELDS; k++) {
        const quad off = (quad) twice * fabsq(out->value[k] - before[k]) +
                         more_of(&fine, (enum cell_field) k, out->value[k]);
        out->error[k] = has(out->fate, (enum cell_field) k, &fine)
                            ? (double) off
                            : (double) NAN;
    }
}
