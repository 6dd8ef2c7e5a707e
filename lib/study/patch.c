#include "patch.h"

#include <math.h>
#include <stddef.h>

#include "fate.h"
#include "study_tolerance.h"

/* Where a field lies in struct cell, and whether its logarithm is smooth. */
static const struct member {
    size_t value, error;
    bool is_log;
} member[CELL_FIELDS] = {
    [CELL_SLIP] = { offsetof(struct cell, slip),
                    offsetof(struct cell, slip_error), true },
    [CELL_TIME] = { offsetof(struct cell, time),
                    offsetof(struct cell, time_error), true },
    [CELL_MU_MEAN] = { offsetof(struct cell, mu_mean),
                       offsetof(struct cell, mu_mean_error), false },
    [CELL_V_PEAK] = { offsetof(struct cell, v_peak),
                      offsetof(struct cell, v_peak_error), true },
    [CELL_MU_PEAK] = { offsetof(struct cell, mu_peak),
                       offsetof(struct cell, mu_peak_error), false },
};

static double read_at(const struct cell *c, size_t offset)
{
    return *(const double *) ((const char *) c + offset);
}

static void write_at(struct cell *c, size_t offset, double value)
{
    *(double *) ((char *) c + offset) = value;
}

/* Chebyshev points, descending, as t in [-1, 1]. */
static double point(int i)
{
    return cos(M_PI * (i + 0.5) / PATCH_SIDE);
}

/* T_0(t) ... T_7(t) */
static void chebyshev(double t, double T[PATCH_SIDE])
{
    T[0] = 1.0;
    T[1] = t;
    for (int k = 2; k < PATCH_SIDE; k++)
        T[k] = 2.0 * t * T[k - 1] - T[k - 2];
}

static double inside(double lo, double hi, double u)
{
    return (2.0 * u - lo - hi) / (hi - lo);
}

void patch_nodes(const struct box *box, struct vec2 z[PATCH_NODES])
{
    const struct vec2 middle = vec2_scale(0.5, vec2_add(box->lo, box->hi));
    const struct vec2 half = vec2_scale(0.5, vec2_sub(box->hi, box->lo));

    for (int i = 0; i < PATCH_NODES; i++)
        z[i] = (struct vec2){ middle.x + half.x * point(i % PATCH_SIDE),
                              middle.y + half.y * point(i / PATCH_SIDE) };
}

/* Coefficients of values at the points: c[k] = (2/n) sum f_i T_k(t_i), half of
 * it for k = 0; with the stride of the array. */
static void transform(double f[], size_t stride)
{
    double c[PATCH_SIDE] = { 0 };

    for (int i = 0; i < PATCH_SIDE; i++) {
        double T[PATCH_SIDE];
        chebyshev(point(i), T);
        for (int k = 0; k < PATCH_SIDE; k++)
            c[k] += f[(size_t) i * stride] * T[k];
    }
    for (int k = 0; k < PATCH_SIDE; k++)
        f[(size_t) k * stride] = c[k] * (k == 0 ? 1.0 : 2.0) / PATCH_SIDE;
}

/* The last coefficients in each direction, and a part of those before: they
 * alone may vanish by symmetry. */
static double last_of(const struct patch *p, int field)
{
    double sum = 0.0;

    for (int j = 0; j < PATCH_SIDE; j++)
        for (int i = 0; i < PATCH_SIDE; i++) {
            const int k = i > j ? i : j;
            const double size = fabs(p->coef[field][j][i]);
            if (k >= PATCH_SIDE - 2)
                sum += k == PATCH_SIDE - 1 ? size : TOL_PATCH_BEFORE * size;
        }
    return sum;
}

static double value_at(const struct patch *p, int field,
                       const double Tx[PATCH_SIDE], const double Ty[PATCH_SIDE])
{
    double sum = 0.0;

    for (int j = 0; j < PATCH_SIDE; j++) {
        double row = 0.0;
        for (int i = 0; i < PATCH_SIDE; i++)
            row += p->coef[field][j][i] * Tx[i];
        sum += row * Ty[j];
    }
    return member[field].is_log ? exp(sum) : sum;
}

/* How many of the states have the field; the worst bar, relative, and the
 * least value of these. */
static int look_at(const struct cell cell[PATCH_STATES], const struct member *m,
                   double *worst, double *least)
{
    int count = 0;

    *worst = 0.0;
    *least = HUGE_VAL;
    for (int i = 0; i < PATCH_STATES; i++) {
        const double value = read_at(&cell[i], m->value);
        if (!(value > 0.0 && isfinite(value)))
            continue;
        *worst = fmax(*worst, read_at(&cell[i], m->error) / value);
        *least = fmin(*least, value);
        count++;
    }
    return count;
}

/* The largest miss, relative. */
static double test_field(const struct patch *p, int field,
                         const struct vec2 test[], const struct cell found[])
{
    double off = 0.0;

    for (int i = 0; i < PATCH_TESTS; i++) {
        double Tx[PATCH_SIDE], Ty[PATCH_SIDE];
        chebyshev(inside(p->box.lo.x, p->box.hi.x, test[i].x), Tx);
        chebyshev(inside(p->box.lo.y, p->box.hi.y, test[i].y), Ty);
        const double value = read_at(&found[i], member[field].value);
        off = fmax(off, fabs(value_at(p, field, Tx, Ty) / value - 1.0));
    }
    return off;
}

/* The field's bar; infinite where it is there for some states only, NaN for
 * none. */
static double fit_field(struct patch *p, int field, const struct vec2 test[],
                        const struct cell cell[PATCH_STATES])
{
    const struct member *m = &member[field];
    double worst, least;
    const int count = look_at(cell, m, &worst, &least);
    double(*c)[PATCH_SIDE] = p->coef[field];

    if (count < PATCH_STATES)
        return count == 0 ? NAN : HUGE_VAL;
    for (int i = 0; i < PATCH_NODES; i++) {
        const double value = read_at(&cell[i], m->value);
        c[i / PATCH_SIDE][i % PATCH_SIDE] = m->is_log ? log(value) : value;
    }
    for (int i = 0; i < PATCH_SIDE; i++)
        transform(c[i], 1);
    for (int i = 0; i < PATCH_SIDE; i++)
        transform(&c[0][i], PATCH_SIDE);
    const double rest = last_of(p, field) / (m->is_log ? 1.0 : least);
    const double off = test_field(p, field, test, cell + PATCH_NODES);
    return fmax(rest, TOL_PATCH_TESTS * off) + TOL_PATCH_LEBESGUE * worst;
}

bool patch_fit(struct patch *p, const struct box *box, unsigned which,
               double rtol, const struct vec2 test[PATCH_TESTS],
               const struct cell cell[PATCH_STATES])
{
    bool holds = cell[0].exit_reason != FATE_UNDECIDED;

    p->box = *box;
    p->which = which;
    p->exit_reason = cell[0].exit_reason;
    for (int i = 1; i < PATCH_STATES && holds; i++)
        holds = cell[i].exit_reason == p->exit_reason;
    for (int k = 0; k < CELL_FIELDS && holds; k++)
        if (which >> k & 1u) {
            p->bar[k] = fit_field(p, k, test, cell);
            holds = !(p->bar[k] > rtol);
        }
    return holds;
}

void patch_row(const struct patch *p, const double x[], size_t n, double y,
               struct cell out[])
{
    double Ty[PATCH_SIDE], along[CELL_FIELDS][PATCH_SIDE];

    chebyshev(inside(p->box.lo.y, p->box.hi.y, y), Ty);
    for (int k = 0; k < CELL_FIELDS; k++)
        for (int i = 0; i < PATCH_SIDE && p->which >> k & 1u; i++) {
            along[k][i] = 0.0;
            for (int j = 0; j < PATCH_SIDE; j++)
                along[k][i] += p->coef[k][j][i] * Ty[j];
        }
    for (size_t i = 0; i < n; i++) {
        double Tx[PATCH_SIDE];
        chebyshev(inside(p->box.lo.x, p->box.hi.x, x[i]), Tx);
        out[i].exit_reason = p->exit_reason;
        for (int k = 0; k < CELL_FIELDS; k++) {
            double value = NAN, error = NAN;
            if (p->which >> k & 1u && !isnan(p->bar[k])) {
                value = 0.0;
                for (int j = 0; j < PATCH_SIDE; j++)
                    value += along[k][j] * Tx[j];
                value = member[k].is_log ? exp(value) : value;
                error = p->bar[k] * fabs(value);
            }
            write_at(&out[i], member[k].value, value);
            write_at(&out[i], member[k].error, error);
        }
    }
}
