/* Formulas: read, lowered to a tape, written, and evaluated at a point, or
 * refused in one line.  The two rates are parted by a #. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "interval.h"
#include "lines.h"
#include "parse.h"
#include "tape_plane.h"

static struct formula f;
static struct tape t;
static struct text_lines lines;

static struct plane_formulas open_plane(void)
{
    struct plane_formulas p = { .values = 0 };

    formula_init(&f);
    formula_leaf(&f, "a", FORMULA_POSITIVE_PARAMETER);
    formula_leaf(&f, "b", FORMULA_PARAMETER);
    p.state[0] = formula_leaf(&f, "v", FORMULA_POSITIVE_STATE);
    p.state[1] = formula_leaf(&f, "y", FORMULA_STATE);
    p.chart[0] = formula_leaf(&f, "x0", FORMULA_PARAMETER);
    p.chart[1] = p.at[1] = formula_leaf(&f, "y0", FORMULA_PARAMETER);
    p.at[0] = formula_of(&f, FUNCTION_EXP, p.chart[0]);
    return p;
}

/* Lines come in order: each calls and names what is there. */
static void write_tape(void)
{
    const int offset[] = { formula_leaf(&f, "X", FORMULA_STATE),
                           formula_leaf(&f, "Y", FORMULA_STATE) };
    struct tape_text made;

    text_of_tape(&f, &t, offset, &made);
    const int result[] = { made.rate[0], made.rate[1], made.scale };
    for (int i = 0; i < 3; i++)
        formula_name(&f, result[i], (const char *[]){ "fx", "fy", "s" }[i]);
    if (!text_write(&f, result, 3, &lines))
        return;
    for (size_t i = 0; i < lines.lines; i++)
        MUST(lines.line[i].name[0] && lines.line[i].text[0]);
}

/* ---- at a point ---------------------------------------------------------- */

static const struct formula_value parameters[] = { { "a", 0.3 },
                                                   { "b", -1.3 },
                                                   { NULL, 0 } };
static const double point[2] = { 0.4, -0.7 }; /* of the chart */

/* Both rates at the point in 113 bits and in doubles, which cannot differ.
 * False where they are not defined there, or not everywhere about it. */
static bool enclose(const struct plane_formulas *p,
                    struct interval_slope_double rate[2])
{
    static struct interval_plan plan;
    static formula_real value[FORMULA_NODES];
    struct interval_slope_quad fine[2];
    struct interval_quad at[2];
    struct interval_double box[2];
    struct fault why = { "" };

    for (const struct formula_value *v = parameters; v->name; v++)
        value[formula_find(&f, v->name, strlen(v->name))] = v->value;
    if (interval_plan(&plan, &f, p->state, p->rate, 2, value, &why)) {
        must_be_a_line(&why);
        return false;
    }
    for (int i = 0; i < 2; i++) {
        const double z = i == 0 ? exp(point[0]) : point[1];
        at[i] = (struct interval_quad){ z, z };
        box[i] = (struct interval_double){ z, z };
    }
    if (interval_over_quad(&plan, at, fine) != INTERVAL_WHOLE ||
        interval_over_double(&plan, box, rate) != INTERVAL_WHOLE)
        return false;
    for (int i = 0; i < 2; i++)
        MUST(rate[i].value.lo <= fine[i].value.hi &&
             fine[i].value.lo <= rate[i].value.hi);
    return true;
}

/* Whether a rate of the chart is what the formula says, to what doubles lose
 * of it and a rounding of the point moves it; beside a much larger one it may
 * vanish. */
static void must_be_near(double direction, double scale,
                         const struct interval_slope_double *rate, double by)
{
    const double lo = rate->value.lo / by, hi = rate->value.hi / by;
    const long double found = direction * expl(scale);
    long double moved = 1e-12 * fmax(fabs(lo), fabs(hi)) + 100 * (hi - lo) +
                        1e-300 * expl(scale);

    for (int i = 0; i < 2; i++)
        moved += 1e-12 * fmax(fabs(rate->by[i].lo), fabs(rate->by[i].hi)) / by;
    MUST(!(found < lo - moved || found > hi + moved));
}

/* Field, slopes and series of the tape. */
static void evaluate(const struct plane_formulas *p)
{
    static struct tape_lowered lowered;
    static struct tape_plane plane;
    static struct jet_work work;
    const formula_real anchor[2] = { point[0], point[1] };
    struct interval_slope_double rate[2];
    struct fault why = { "" };
    struct planar_jacobian J;
    jet_pair x[3] = { { 0, 0 }, { 1, -1 } }, y[3] = { { 0, 0 }, { -1, 1 } },
             fx[3], fy[3];

    const bool known = enclose(p, rate);
    enum status s = tape_plane_lower(&lowered, &f, p, false, &why);
    if (s == STATUS_OK)
        s = tape_plane_at(&lowered, parameters, anchor, &plane, &why);
    if (s != STATUS_OK) {
        MUST(s == STATUS_BAD_ARGUMENT);
        must_be_a_line(&why);
        return;
    }
    tape_jacobian(&plane, (struct vec2){ 0, 0 }, &J);
    for (size_t k = 0; k < 3; k++)
        tape_jet(&plane, &work, k, x, y, fx, fy);
    if (!known)
        return;
    must_be_near(J.field.direction.x, J.field.log_scale, &rate[0],
                 exp(point[0]));
    must_be_near(J.field.direction.y, J.field.log_scale, &rate[1], 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = calloc(size + 1, 1);
    struct plane_formulas p = open_plane();
    struct fault why = { "" };
    enum status s;

    MUST(text != NULL);
    if (size)
        memcpy(text, data, size);
    char *second = strchr(text, '#');
    if (second)
        *second++ = '\0';
    s = formula_parse(&f, text, &p.rate[0], &why);
    if (s == STATUS_OK)
        s = formula_parse(&f, second ? second : text, &p.rate[1], &why);
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE);
    if (s == STATUS_OK)
        evaluate(&p);
    if (s == STATUS_OK && (s = tape_lower(&t, &f, &p, &why)) == STATUS_OK)
        write_tape();
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE || s == STATUS_BAD_ARGUMENT);
    if (s != STATUS_OK)
        must_be_a_line(&why);
    free(text);
    return 0;
}
