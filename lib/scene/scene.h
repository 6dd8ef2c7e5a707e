/*
 * scene.h -- what a user asks for: a YAML file, overridden key by key.
 *
 * One table (schema_table.c) drives parsing, ranges, defaults and messages. The
 * text is read as libyaml events into a small tree that remembers where every
 * value stands, because a message must name file, line, column and key; the
 * libraries that load YAML straight into structs cannot say that.
 *
 * Defaults: law.friction asinh; Table 2's material; gravity 9.81; window v
 * 1e-6..1e6, psi 1e-3..1e2 (psi -7..5 where psi is a logarithm); axes log;
 * dimensionless units; no products (each command has its own); estimates.xi
 * 0.85 0.9 0.99 0.999; spring_block sigma 1000 Pa, as heavy as that, over the
 * window's v; fold_curves c 1e-14..10; chi.alpha 0.2 0.28 0.34 0.38; no
 * trajectories, their seed 1 and without limits; basins 512 x 512, audit 1000,
 * not exact, their rtol 1e-6; no sweep; no ensemble, else of 10000 draws,
 * sobol, seed 1; rtol 1e-12; no output.  A law must be given, and a slope where
 * products take one (scene_slope.h).
 */
#pragma once

#include <stdint.h>

#include "law.h"
#include "plane.h"
#include "unit.h"

/* What a scene may ask for; stage_table says what each runs. */
enum product {
    PRODUCT_EQUILIBRIA,
    PRODUCT_FOLDS,
    PRODUCT_NULLCLINES,
    PRODUCT_FIELD_ARROWS,
    PRODUCT_MANIFOLDS,
    PRODUCT_KNEES,
    PRODUCT_ESTIMATES,
    PRODUCT_TAYLOR_SERIES,
    PRODUCT_SENSITIVITIES,
    PRODUCT_TRAJECTORIES,
    PRODUCT_BASINS,
    PRODUCT_MARGIN,
    PRODUCT_SLIP,
    PRODUCT_TIME,
    PRODUCT_FRICTION,
    PRODUCT_PEAK,
    PRODUCT_FRICTION_LAW,
    PRODUCT_SPRING_BLOCK,
    PRODUCT_BIFURCATION,
    PRODUCT_FOLD_CURVES,
    PRODUCT_CHI,
    PRODUCTS
};

/* As scenes have them, by enum product; NULL-ended. */
extern const char *const product_names[];

/* Of figures and grids; eigen: along the eigenvectors of the saddle, (36). */
enum axes { AXES_LOG, AXES_LINEAR, AXES_EIGEN };

/* Of the scene's starts and of the axes of figures. */
enum units { UNITS_DIMENSIONLESS, UNITS_SI };

/* A state to follow. */
struct scene_start {
    double v, psi; /* dimensionless, whatever the scene's units */
};

/* What figures and grids show. */
struct scene_window {
    double v[2], psi[2];
    enum axes axes;
};

/* A block pulled through a spring on level ground, Fig 1(b). */
struct scene_spring {
    double sigma; /* normal stress, Pa */
    double mass;  /* of the block, kg/m^2 */
    double v[2];  /* speeds of pulling, dimensionless */
};

/* Rabinowicz's experiment: his block and ball, and what he measured. */
struct scene_rabinowicz {
    double block_mass, ball_mass; /* kg; 0: not given */
    double restitution;           /* negative: not given */
    double *tan_alpha; /* owned; slopes to compute l_k at; NULL: the scene's */
    size_t slopes;
    char *data;       /* owned: path of a CSV file; NULL: none */
    double smoothing; /* of slip_curve.h; 0: found from the data */
};

/* Where a figure's legend stands; auto: outside where a page is wide. */
enum legend_place {
    LEGEND_AUTO,
    LEGEND_OUTSIDE,
    LEGEND_INSIDE,
    LEGEND_BELOW,
    LEGEND_NONE
};
/* Of maps of numbers. */
enum colour_map { COLOURS_VIRIDIS, COLOURS_CIVIDIS, COLOURS_GREYS };

/* The paper of figures. */
struct scene_figure {
    double width, height; /* mm; height 0: as the plot and the legend need */
    double type;          /* size of letters, pt */
    double dpi;           /* of a PNG */
    char *font;           /* owned; NULL: the system's sans-serif */
    bool title;
    enum legend_place legend; /* never auto */
    enum colour_map colours;
};

/* How the values of a key lie between its first and its last. */
enum sweep_scale { SWEEP_LINEAR, SWEEP_LOG };

/* A key and the values it takes, one after another. */
struct scene_axis {
    const char *key; /* borrowed, of the schema or a system; NULL: none */
    double from, to; /* as given; both 0: values were listed */
    size_t points;
    enum sweep_scale scale; /* of the points between, and of drawings */
    double *value;          /* owned; ascending */
    size_t count;
};
enum { SCENE_AXES = 2 };

/* What a sweep's figure shows, each over the key. */
enum sweep_show {
    SHOW_VELOCITIES,         /* v_plus, v_minus, the saddle, the knees */
    SHOW_VELOCITY_ESTIMATES, /* the first two against (38), (39): Fig 11(b) */
    SHOW_PERSISTENCE,        /* (30), (31), x_excess: Fig 9 */
    SHOW_STATIC_FRICTION,    /* (41), mu_s_num, mu_s_mean: Fig 12(a) */
    SHOW_FRACTURE_ENERGY,    /* (32): Fig 12(b) */
    SHOW_BASINS,             /* shares of the window, in the chart */
    SHOWS
};
/* Of the upward axis of that figure. */
enum y_scale { Y_SCALE_AUTO, Y_SCALE_LINEAR, Y_SCALE_LOG };

/* The numbers of a study over a key, or over several. */
struct scene_sweep {
    struct scene_axis axis[SCENE_AXES];
    size_t axes;   /* 0: no sweep; 2: a grid */
    double refine; /* in ln v; 0: not at all */
    enum sweep_show show;
    enum y_scale y_scale;    /* of the figure; auto: as `show` is best seen */
    double y_range[2];       /* both 0: as the values need */
    struct scene_axis draft; /* the axis being read */
};

/* How a parameter of an ensemble is distributed; of[2]: mean and standard
 * deviation; ends; median and the factor that a standard deviation is in the
 * logarithm. */
enum spread_law { SPREAD_NORMAL, SPREAD_UNIFORM, SPREAD_LOGNORMAL };
struct scene_spread {
    char *key; /* owned */
    enum spread_law law;
    double of[2]; /* in the scene's units */
    bool is_set;  /* of those that are scattered: where */
    size_t line, column;
};

/* A number that is asked for, and where. */
struct scene_number {
    char *name; /* owned */
    bool is_set;
    size_t line, column;
};

/* A state whose fate is asked for at every draw: v and psi, or what is added to
 * the slip rate of the creep state. */
struct scene_push {
    bool from_creep;
    double v, psi;      /* as given; of a system its first and second state */
    bool is_si, is_phi; /* v in m/s, not in V_star; psi is phi (physical.h) */
    char from[32];      /* of a system: they are added to those of the
                           equilibrium of that name; "": of none */
};

enum ensemble_method { ENSEMBLE_SOBOL, ENSEMBLE_RANDOM, ENSEMBLE_GRID };

/* Numbers of many materials. */
struct scene_ensemble {
    struct scene_spread *parameter; /* owned */
    size_t parameters;
    size_t scattered; /* the first of them are inputs that stand as X +- S at
                         their keys: scene_scatter.h */
    bool is_drawn;    /* `draws` is given */
    char *samples, *covariance; /* owned: paths of CSV files; NULL: none */
    size_t draws;
    enum ensemble_method method;
    uint64_t seed;
    struct scene_number *number; /* owned; NULL: those of the products */
    size_t numbers;
    struct scene_push *push; /* owned */
    size_t pushes;
};

struct formula_system;

/* All of it, defaults filled in. */
struct scene {
    char *title;                   /* owned; "" if none */
    struct formula_system *system; /* owned; NULL: a law on a slope.  With it,
                                      v and psi of window and starts are its
                                      first and its second state */
    char **parameter_key; /* owned: "system.parameters.NAME" of each of its
                             parameters; NULL-ended */
    struct law law;
    struct law_typed *typed; /* owned: the law's formulas; NULL: components */
    struct material material;
    double alpha;             /* rad; 0: none (scene_slope.h) */
    enum unit_angle slope_in; /* as it was given */
    double slope_given;
    long double tan_alpha;
    struct scene_window window; /* dimensionless */
    enum units units;           /* of start values and figure axes */
    unsigned products;          /* bits 1 << enum product; 0: not given */
    double *xi;                 /* owned */
    size_t xi_count;
    const char *physical;      /* a key that has a physical unit; NULL: none */
    struct scene_start *start; /* owned */
    size_t starts;
    size_t spread;
    uint64_t seed;
    double until_time, until_slip; /* 0: no limit */
    size_t linear_slip, log_time;  /* samples; 0: as the steps fall */
    size_t cells[2];               /* of a basin map, along v and psi */
    size_t audit;     /* cells checked by forward integration; 0: none */
    bool exact;       /* every cell by forward integration */
    double cell_rtol; /* of slip, time and friction of the cells */
    struct scene_rabinowicz rabinowicz;
    struct scene_spring spring_block;
    double fold_c[2];  /* fold curves from c to c */
    double *chi_alpha; /* owned; slopes of chi(v), rad */
    size_t chi_alphas;
    struct scene_sweep sweep;
    struct scene_ensemble ensemble;
    double rtol;
    bool proved; /* enclose the numbers with proof */
    struct scene_figure paper;
    char *hdf5, *figure; /* owned; NULL: none */
    char *file;          /* owned: its path as given; NULL: none */
    char *text;          /* owned: the file as read, "" without one */
    char *overrides;     /* owned: one "key=value" a line */
};

/* Reads `path` (NULL: no file, the overrides are all), applies the overrides
 * "key=value" in order, fills defaults and checks everything.
 *
 * STATUS_BAD_SCENE with one line FILE:LINE:COL: (or --set KEY=VALUE:, or
 * command line:) in *why, also for a file beyond SCENE_BYTES; STATUS_IO where
 * the file cannot be read; STATUS_NO_MEMORY.  On failure *s is empty and need
 * not be freed, though scene_free is harmless. */
MUST_CHECK enum status scene_read(struct scene *s, const char *path,
                                  char *const override[], size_t overrides,
                                  struct fault *why);

/* Whether an axis of the chart is the logarithm of its state. */
bool scene_axis_is_log(const struct scene *s, int axis);

/* Its window in the chart (block.h), absolute. */
struct box scene_box(const struct scene *s);

/* What to call it: its title, else its file, else "command line". */
const char *scene_name(const struct scene *s);

/* A second call is harmless. */
void scene_free(struct scene *s);
