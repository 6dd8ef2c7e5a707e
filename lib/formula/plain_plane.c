/* Derivatives go forward through the operations (dual numbers); series by the
 * recurrences of Moore 1966, as in jet.h: coefficient k of g needs those of h
 * before k only, so that h may come after g. */
#include "plain_plane.h"

#include <math.h>

/* ---- numbers ------------------------------------------------------------- */

/* Newton's method for ln w + w + k = 0 in ln w. */
static double lambert(double k)
{
    double w = k > -1.0 ? -k : log1p(-k);

    for (int i = 0; i < 40; i++)
        w -= (w + exp(w) + k) / (1.0 + exp(w));
    return exp(w);
}

static double value_of(const struct plain_op *op, double u)
{
    switch (op->function) {
        case FUNCTION_EXP:
            return exp(u);
        case FUNCTION_LN:
            return log(u);
        case FUNCTION_SQRT:
            return sqrt(u);
        case FUNCTION_SINH:
            return sinh(u);
        case FUNCTION_COSH:
            return cosh(u);
        case FUNCTION_SIN:
            return sin(u);
        case FUNCTION_COS:
            return cos(u);
        case FUNCTION_TAN:
            return tan(u);
        case FUNCTION_TANH:
            return tanh(u);
        case FUNCTION_ATAN:
            return atan(u);
        case FUNCTION_ASINH:
            return asinh(u);
        case FUNCTION_ASIN:
            return asin(u);
        case FUNCTION_POWER:
            return pow(u, op->number);
        default:
            return lambert(u);
    }
}

void plain_values(const struct plain_program *p, struct vec2 z, double value[])
{
    for (int i = 0; i < p->ops; i++) {
        const struct plain_op *op = &p->op[i];
        switch (op->kind) {
            case PLAIN_COORDINATE:
                value[i] = op->a == 0 ? z.x : z.y;
                break;
            case PLAIN_NUMBER:
                value[i] = op->number;
                break;
            case PLAIN_SUM:
                value[i] = value[op->a] + value[op->b];
                break;
            case PLAIN_TIMES:
                value[i] = value[op->a] * value[op->b];
                break;
            case PLAIN_OVER:
                value[i] = value[op->a] / value[op->b];
                break;
            case PLAIN_CALL:
                value[i] = value_of(op, value[op->a]);
        }
    }
}

/* p u + q w */
static struct vec2 blend(double p, struct vec2 u, double q, struct vec2 w)
{
    return vec2_add(vec2_scale(p, u), vec2_scale(q, w));
}

static void slopes(const struct plain_program *p, const double value[],
                   struct vec2 slope[])
{
    for (int i = 0; i < p->ops; i++) {
        const struct plain_op *op = &p->op[i];
        const int a = op->a, b = op->b;
        switch (op->kind) {
            case PLAIN_COORDINATE:
                slope[i] = (struct vec2){ a == 0, a == 1 };
                break;
            case PLAIN_NUMBER:
                slope[i] = (struct vec2){ 0.0, 0.0 };
                break;
            case PLAIN_SUM:
                slope[i] = vec2_add(slope[a], slope[b]);
                break;
            case PLAIN_TIMES:
                slope[i] = blend(value[b], slope[a], value[a], slope[b]);
                break;
            case PLAIN_OVER:
                slope[i] = vec2_scale(
                    1.0 / value[b], blend(1.0, slope[a], -value[i], slope[b]));
                break;
            case PLAIN_CALL:
                slope[i] = vec2_scale(value[b], slope[a]);
        }
    }
}

struct vec2 plain_rates(const struct plain_program *p, struct vec2 z,
                        struct mat2 *slope)
{
    double value[PLAIN_OPS];
    struct vec2 of[PLAIN_OPS];

    plain_values(p, z, value);
    if (slope) {
        slopes(p, value, of);
        const struct vec2 x = of[p->rate[0]], y = of[p->rate[1]];
        *slope = (struct mat2){ x.x, x.y, y.x, y.y };
    }
    return (struct vec2){ value[p->rate[0]], value[p->rate[1]] };
}

double plain_value(const struct plain_program *p, int i, struct vec2 z,
                   struct vec2 *gradient)
{
    double value[PLAIN_OPS];
    struct vec2 of[PLAIN_OPS];

    plain_values(p, z, value);
    if (gradient) {
        slopes(p, value, of);
        *gradient = of[p->value[i]];
    }
    return value[p->value[i]];
}

/* ---- as a planar system -------------------------------------------------- */

static void field(const void *ctx, struct vec2 z, struct planar_field *f)
{
    const struct plain_plane *p = ctx;
    const struct vec2 rate =
        plain_rates(p->program, vec2_add(p->origin, z), NULL);

    *f = (struct planar_field){ vec2_scale(p->sign, vec2_sub(rate, p->left)),
                                0.0 };
}

static void jacobian(const void *ctx, struct vec2 z, struct planar_jacobian *J)
{
    const struct plain_plane *p = ctx;
    const double s = p->sign;
    struct mat2 m;

    const struct vec2 rate =
        plain_rates(p->program, vec2_add(p->origin, z), &m);
    J->field =
        (struct planar_field){ vec2_scale(s, vec2_sub(rate, p->left)), 0.0 };
    J->matrix = (struct mat2){ s * m.xx, s * m.xy, s * m.yx, s * m.yy };
}

/* One slot an operation, and one more for j u[j] of a call. */
static void op_jet(const struct plain_program *p, int i, struct jet_work *w,
                   size_t k, jet_pair *du)
{
    const struct plain_op *op = &p->op[i];
    jet_pair *const out = w->slot[i];
    const jet_pair *a = w->slot[op->a], *b = w->slot[op->b < 0 ? 0 : op->b];

    switch (op->kind) {
        case PLAIN_COORDINATE:
            break;
        case PLAIN_NUMBER:
            out[k] = JET_PAIR(k == 0 ? op->number : 0.0);
            break;
        case PLAIN_SUM:
            out[k] = a[k] + b[k];
            break;
        case PLAIN_TIMES:
            if (p->op[op->a].kind == PLAIN_NUMBER)
                out[k] = a[0] * b[k];
            else
                out[k] = a == b ? jet_square(k, a) : jet_product(k, a, b);
            break;
        case PLAIN_OVER:
            out[k] = p->op[op->b].kind == PLAIN_NUMBER
                         ? a[k] / b[0]
                         : jet_quotient(k, a, b, out);
            break;
        case PLAIN_CALL:
            du[k] = jet_number[k] * a[k];
            if (k == 0)
                out[0] =
                    (jet_pair){ value_of(op, a[0][0]), value_of(op, a[0][1]) };
            else
                out[k] = jet_chain(w, k, a, du, b);
    }
}

static void jet(const void *ctx, struct jet_work *w, size_t k,
                const jet_pair x[], const jet_pair y[], jet_pair fx[],
                jet_pair fy[])
{
    const struct plain_plane *p = ctx;
    const struct plain_program *g = p->program;
    size_t du = (size_t) g->ops;

    if (k == 0)
        w->log_scale = JET_PAIR(0.0);
    w->slot[0][k] = k == 0 ? x[0] + p->origin.x : x[k];
    for (int i = 1; i < g->ops; i++) {
        if (g->op[i].kind == PLAIN_COORDINATE)
            w->slot[i][k] = k == 0 ? y[0] + p->origin.y : y[k];
        op_jet(g, i, w, k, w->slot[du]);
        du += g->op[i].kind == PLAIN_CALL;
    }
    w->used = du;
    const jet_pair *fp = w->slot[g->rate[0]], *fq = w->slot[g->rate[1]];
    fx[k] = p->sign * (k == 0 ? fp[0] - p->left.x : fp[k]);
    fy[k] = p->sign * (k == 0 ? fq[0] - p->left.y : fq[k]);
}

static void rate_gradient(const void *ctx, size_t which, struct vec2 z,
                          double *rate, struct vec2 *gradient)
{
    const struct plain_plane *p = ctx;

    *rate =
        plain_value(p->program, (int) which, vec2_add(p->origin, z), gradient);
}

static void rate_jet(const void *ctx, size_t which, struct jet_work *w,
                     size_t k, const jet_pair x[], const jet_pair y[],
                     jet_pair rate[])
{
    const struct plain_plane *p = ctx;

    (void) x, (void) y;
    rate[k] = w->slot[p->program->value[which]][k];
}

struct plain_plane plain_around(const struct plain_program *program,
                                struct vec2 origin, bool still, double sign)
{
    return (struct plain_plane){
        .program = program,
        .origin = origin,
        .left = still ? plain_rates(program, origin, NULL)
                      : (struct vec2){ 0.0, 0.0 },
        .sign = sign,
    };
}

void plain_planar(const struct plain_plane *p, struct planar *out)
{
    out->origin = p->origin;
    out->field = field;
    out->jacobian = jacobian;
    out->jet = jet;
    out->rate_gradient = rate_gradient;
    out->rate_jet = rate_jet;
    out->ctx = p;
}
