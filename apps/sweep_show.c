#include "sweep_show.h"

#include <stdio.h>

#include "symbols.h"

#define BOTH(text)                                                             \
    {                                                                          \
        text, text                                                             \
    }
#define IN_L(text)                                                             \
    {                                                                          \
        text "/" S_L, text " (m)"                                              \
    }
const struct show_frame show_frames[SHOWS] = {
    [SHOW_VELOCITIES] = { { "slip rate " S_V_RATIO,
                            "slip rate " S_BIG_V " (m/s)" },
                          { 0 },
                          "ln_v_plus",
                          { "ln " S_V_PLUS,
                            "ln " S_BIG_V SUB("+") " (" S_BIG_V " in m/s)" } },
    [SHOW_VELOCITY_ESTIMATES] = { { "slip rate " S_V_RATIO,
                                    "slip rate " S_BIG_V " (m/s)" },
                                  { 0 },
                                  "ln_v_plus",
                                  { "ln " S_V_PLUS,
                                    "ln " S_BIG_V SUB("+") " (" S_BIG_V
                                                           " in m/s)" } },
    [SHOW_PERSISTENCE] = { { "slip " S_SLIP, "slip " S_X " (m)" },
                           { 0 },
                           "x_excess",
                           { "excess slip " S_SLIP,
                             "excess slip " S_X " (m)" } },
    [SHOW_STATIC_FRICTION] = { BOTH("static friction coefficient " S_MU_S),
                               { 0.0, 1.5 }, /* (41) leaves it at both ends */
                               "mu_s_mean",
                               BOTH("mean static friction " S_MU_S) },
    [SHOW_FRACTURE_ENERGY] = { IN_L("fracture energy " ITALIC("G")),
                               { 0 },
                               "fracture_energy",
                               IN_L("fracture energy " ITALIC("G")) },
    [SHOW_BASINS] = { BOTH("share of the window"),
                      { 0.0, 1.0 },
                      "basin_fraction_log_creep",
                      BOTH("share that creeps") },
};

/* ---- curves -------------------------------------------------------------- */

/* A column, or one for each xi: then `column` follows the number, and colour
 * and entry are the number's. */
struct look {
    const char *column, *entry;
    struct figure_style style;
    bool marks, of_xi;
    enum figure_mark mark;
};

#define XI(column, width)                                                      \
    {                                                                          \
        column, NULL, { FIGURE_SERIES_3, FIGURE_SOLID, width }, false, true, 0 \
    }
#define LINE(column, entry, role, dash, width)                                 \
    {                                                                          \
        column, entry, { FIGURE_##role, FIGURE_##dash, width }, false, false,  \
            0                                                                  \
    }
#define MARKS(column, entry, role, mark)                                       \
    {                                                                          \
        column, entry, { FIGURE_##role, FIGURE_SOLID, 0 }, true, false,        \
            FIGURE_##mark                                                      \
    }

enum { LOOKS = 7 }; /* at most, and one that ends the list */

static const struct look look[SHOWS][LOOKS] = {
    [SHOW_VELOCITIES] = {
        LINE("v_plus", S_V_PLUS, SERIES_1, SOLID, 0),
        LINE("saddle_v", S_V " at the saddle", SERIES_2, DASHED, 0),
        LINE("v_minus", S_V_MINUS, SERIES_3, DASH_DOT, 0),
        LINE("knee_upper_v", "upper knee", SERIES_4, DOTTED, 0),
        LINE("knee_lower_v", "lower knee", SERIES_5, LONG_DASH, 0),
    },
    [SHOW_VELOCITY_ESTIMATES] = {
        XI("v_plus", 2.0),
        XI("v_minus", 2.0),
        LINE("saddle_v", S_V " at the saddle", TRAJECTORY, DASHED, 1.8),
        MARKS("v_plus", "exact " S_V_PLUS, SERIES_2, PLUS),
        MARKS("v_minus", "exact " S_V_MINUS, SERIES_1, CROSS),
    },
    [SHOW_PERSISTENCE] = {
        LINE("estimates_x_k", S_X_K ", (30)", SERIES_5, SOLID, 4.5),
        LINE("estimates_x_k_small_psi", S_X_K ", (31)", SERIES_3, DASHED, 1.8),
        LINE("x_excess", "exact excess slip", SERIES_1, SOLID, 3.0),
    },
    [SHOW_STATIC_FRICTION] = {
        XI("mu_s", 1.8),
        LINE("estimates_mu_s_exact_v_plus", "(41), exact " S_V_PLUS, SERIES_2, LONG_DASH, 2.6),
        LINE("mu_s_num", "exact " S_V_PLUS " and slip", SERIES_1, DASHED, 2.4),
        LINE("mu_s_mean", "exact mean", SERIES_1, SOLID, 3.0),
    },
    [SHOW_FRACTURE_ENERGY] = {
        XI("G", 1.8),
        LINE("fracture_energy", "exact " S_V_PLUS, SERIES_1, SOLID, 3.0),
    },
    [SHOW_BASINS] = {
        LINE("basin_fraction_log_creep", "creeps", SERIES_1, DASH_OF_ROLE, 0),
        LINE("basin_fraction_log_sliding", "slides", SERIES_2, DASH_OF_ROLE, 0),
        LINE("basin_fraction_log_rest_finite", "comes to rest", SERIES_3, DASH_OF_ROLE, 0),
        LINE("basin_fraction_log_rest_asymptotic", "rests as " S_T " → ∞", SERIES_4, DASH_OF_ROLE, 0),
        LINE("basin_fraction_log_runaway", "runs away", SERIES_5, DASH_OF_ROLE, 0),
        LINE("basin_fraction_log_undecided", "undecided", SERIES_6, DASH_OF_ROLE, 0),
    },
};

/* Colours and dashes that exact numbers leave; thinner after four. */
static struct sweep_curve curve_of_xi(const struct look *l, double xi, size_t i)
{
    const size_t roles = FIGURE_SERIES_6 - FIGURE_SERIES_3 + 1;
    const int role = FIGURE_SERIES_3 + (int) (i % roles);
    struct sweep_curve c = { .style = l->style };

    c.style.role = (enum figure_role) role;
    c.style.dash = FIGURE_DASH_OF_ROLE;
    c.style.width *= i < roles ? 1.0 : 0.5;
    snprintf(c.column, sizeof c.column, "estimates_xi_%zu_%s", i, l->column);
    snprintf(c.entry, sizeof c.entry, ITALIC("ξ") " = %.6g", xi);
    return c;
}

static struct sweep_curve curve_of(const struct look *l)
{
    struct sweep_curve c = { .style = l->style,
                             .marks = l->marks,
                             .mark = l->mark };

    snprintf(c.column, sizeof c.column, "%s", l->column);
    snprintf(c.entry, sizeof c.entry, "%s", l->entry);
    return c;
}

size_t sweep_show_curves(const struct scene *s,
                         struct sweep_curve curve[SWEEP_CURVES_MAX])
{
    size_t n = 0;

    for (const struct look *l = look[s->sweep.show]; l->column; l++)
        if (!l->of_xi)
            curve[n++] = curve_of(l);
        else
            for (size_t i = 0; i < s->xi_count; i++)
                curve[n++] = curve_of_xi(l, s->xi[i], i);
    return n;
}
