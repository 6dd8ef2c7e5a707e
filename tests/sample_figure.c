#include "sample_figure.h"

#include <math.h>

const struct figure_axis sample_v = { "v (m/s)", 1e-6, 1e6, true };
const struct figure_axis sample_psi = { "\xcf\x88", 1e-3, 1e2, true };

enum { POINTS = 300 };

static void saddle_point(double p, double q, double *v, double *psi)
{
    *v = pow(10, p + 0.6 * q);
    *psi = pow(10, q - 0.4 * p);
}

/* p = p0 e^t, q = q0 e^-t for t in [0, span]. */
static void add_orbit(struct figure *f, enum figure_role role,
                      const char *entry, double p0, double q0, double span)
{
    static const double heads[] = { 0.35, 0.7 };
    double v[POINTS], psi[POINTS];
    for (int k = 0; k < POINTS; k++) {
        const double t = span * k / (POINTS - 1);
        saddle_point(p0 * exp(t), q0 * exp(-t), &v[k], &psi[k]);
    }
    figure_add(f, &(struct figure_layer){ .style.role = role,
                                          .entry = entry,
                                          .x = v,
                                          .y = psi,
                                          .count = POINTS,
                                          .heads = heads,
                                          .head_count = 2 });
}

/* The straight line (p, q) = s (a, b), s in [-20, 20]. */
static void add_line(struct figure *f, enum figure_role role, const char *entry,
                     double a, double b)
{
    double v[POINTS], psi[POINTS];
    for (int k = 0; k < POINTS; k++) {
        const double s = -20 + 40.0 * k / (POINTS - 1);
        saddle_point(s * a, s * b, &v[k], &psi[k]);
    }
    figure_add(f, &(struct figure_layer){ .style.role = role,
                                          .entry = entry,
                                          .x = v,
                                          .y = psi,
                                          .count = POINTS });
}

/* Which side of p = 0 each cell lies on. */
static void add_basins(struct figure *f)
{
    enum { NX = 256, NY = 200 };
    static const struct figure_shade shades[] = {
        { 0, FIGURE_SHADE_1, "basin of rest" },
        { 1, FIGURE_SHADE_2, "basin of sliding" }
    };
    static int8_t label[NX * NY];
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++) {
            const double X = -6 + 12 * (i + 0.5) / NX;
            const double Y = -3 + 5 * (j + 0.5) / NY;
            label[j * NX + i] = X - 0.6 * Y > 0;
        }
    figure_add_labels(
        f, &(struct figure_labels){ label, NX, NY, shades, 2, NULL });
}

static void add_field(struct figure *f)
{
    enum { NX = 20, NY = 14 };
    double x[NX * NY], y[NX * NY], dx[NX * NY], dy[NX * NY];
    for (int k = 0; k < NX * NY; k++) {
        const double X = -6 + 12 * (k % NX + 0.5) / NX;
        const double Y = -3 + 5 * (k / NX + 0.5) / NY;
        const double p = (X - 0.6 * Y) / 1.24, q = Y + 0.4 * p;
        x[k] = pow(10, X);
        y[k] = pow(10, Y);
        dx[k] = p - 0.6 * q;
        dy[k] = -q - 0.4 * p;
    }
    figure_add(f, &(struct figure_layer){ .kind = FIGURE_ARROWS,
                                          .style.role = FIGURE_FIELD,
                                          .entry = "direction field",
                                          .x = x,
                                          .y = y,
                                          .dx = dx,
                                          .dy = dy,
                                          .count = NX * NY });
}

void sample_mark(struct figure *f, enum figure_mark mark, const char *entry,
                 double x, double y)
{
    figure_add(f, &(struct figure_layer){ .kind = FIGURE_POINTS,
                                          .style.role = FIGURE_EQUILIBRIUM,
                                          .entry = entry,
                                          .x = &x,
                                          .y = &y,
                                          .count = 1,
                                          .mark = mark });
}

static void add_orbits(struct figure *f)
{
    for (int k = 0; k < 28; k++) {
        const double p = (k % 2 ? 1 : -1) * pow(10, -3 + 3.5 * (k / 4) / 7);
        add_orbit(f, FIGURE_TRAJECTORY, "trajectories", p, k / 2 % 2 ? 9 : -9,
                  12);
    }
    add_orbit(f, FIGURE_HIGHLIGHT, "after the push", 0.02, 3.2, 8);
}

void sample_portrait(struct figure *f, const char *title)
{
    figure_init(f, title, &sample_v, &sample_psi);
    add_basins(f);
    add_field(f);
    add_orbits(f);
    add_line(f, FIGURE_NULLCLINE_X, "dv/dt = 0", 0.6, 1);
    add_line(f, FIGURE_NULLCLINE_Y, "d\xcf\x88/dt = 0", 1, -0.4);
    add_line(f, FIGURE_STABLE, "stable manifold", 0, 1);
    add_line(f, FIGURE_UNSTABLE, "unstable manifold", 1, 0);
    sample_mark(f, FIGURE_DISC, "node", 1e4, 3e-2);
    sample_mark(f, FIGURE_CIRCLE, "saddle", 1, 1);
}

enum status sample_draw(const struct figure *f, const char *path,
                        bool keep_script, struct fault *fault)
{
    return figures_write(f, &path, 1, keep_script, fault);
}
