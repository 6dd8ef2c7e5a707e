#include "sample_store.h"

#include <hdf5.h>
#include <math.h>

#include "check.h"
#include "store_grid.h"
#include "store_records.h"

static const char *const types[] = { "saddle", "stable_node", NULL };

struct steady {
    int8_t type;
    int64_t rank;
    double v;
    struct quantity lambda;
    const char *note;
};
#define STEADY(name, unit, text, kind, codes)                                  \
    {                                                                          \
#name, unit, text, offsetof(struct steady, name), kind, codes, NULL    \
    }
static const struct record_field steady_fields[] = {
    STEADY(type, "1", "linear type", RECORD_CODE, types),
    STEADY(rank, "1", "rank", RECORD_COUNT, NULL),
    STEADY(v, "m s-1", "slip rate", RECORD_REAL, NULL),
    STEADY(lambda, "s-1", "eigenvalue", RECORD_QUANTITY, NULL),
    STEADY(note, "1", "remark", RECORD_TEXT, NULL),
};
static const struct record_type steady_type = { "steady", "a steady state",
                                                steady_fields, 5,
                                                sizeof(struct steady) };
static const struct proved steady_enclosure = { .lo = 1.25, .hi = 1.75 };
static const struct proved steady_open = { .not_proved = "no tube" };
static struct steady steady_states[] = {
    { 0,
      7,
      0.25,
      { 1.5, 1e-9, 2e-15, NULL, &steady_enclosure, NAN, NAN },
      "Gr\xc3\xbc\xc3\x9f" },
    { -1,
      8,
      4.0,
      { NAN, NAN, NAN, "no window", &steady_open, NAN, NAN },
      NULL },
};
const struct record_array sample_states = { &steady_type, steady_states, 2 };

struct point {
    double value[12];
};
#define POINT(i, name)                                                         \
    {                                                                          \
        name, "1", "column " name, (i) * sizeof(double), RECORD_REAL, NULL,    \
            NULL                                                               \
    }
/* More columns on one axis than an object header holds compactly. */
static const struct record_field point_fields[] = {
    POINT(0, "v"),  POINT(1, "psi"), POINT(2, "slope"), POINT(3, "arc"),
    POINT(4, "c4"), POINT(5, "c5"),  POINT(6, "c6"),    POINT(7, "c7"),
    POINT(8, "c8"), POINT(9, "c9"),  POINT(10, "time"), POINT(11, "slip"),
};
static const struct record_type point_type = { "point", "a point", point_fields,
                                               12, sizeof(struct point) };

static const struct record_field label = { .name = "label",
                                           .unit = "1",
                                           .text = "fate",
                                           .kind = RECORD_CODE,
                                           .codes = types };
static const struct record_field margin = {
    .name = "margin", .unit = "1", .text = "distance", .kind = RECORD_REAL
};

double sample_margin(size_t row, size_t column)
{
    return (double) row + 0.001 * (double) column;
}

/* The margin in two blocks; the last row is never written. */
static void put_grid(struct store *st)
{
    static const char *const psi_v[] = { "psi", "v" };
    static double axis[SAMPLE_ROWS], cell[SAMPLE_ROWS * SAMPLE_COLUMNS];
    static int8_t code[SAMPLE_ROWS * SAMPLE_COLUMNS];

    for (size_t i = 0; i < SAMPLE_ROWS; i++)
        axis[i] = (double) i;
    for (size_t i = 0; i < (size_t) SAMPLE_ROWS * SAMPLE_COLUMNS; i++) {
        cell[i] = sample_margin(i / SAMPLE_COLUMNS, i % SAMPLE_COLUMNS);
        code[i] = i % 2;
    }
    (void) !store_put_axis(st, "/basin", "psi", "1", "state", SAMPLE_ROWS,
                           axis);
    (void) !store_put_axis(st, "/basin", "v", "1", "rate", SAMPLE_COLUMNS,
                           axis);
    (void) !store_put_cube(st, "/basin", &label, 2, psi_v);
    (void) !store_put_cube(st, "/basin", &margin, 2, psi_v);
    (void) !store_put_rows(st, "/basin", &label, 0, SAMPLE_ROWS - 1, code);
    (void) !store_put_rows(st, "/basin", &margin, 0, 256, cell);
    (void) !store_put_rows(st, "/basin", &margin, 256, SAMPLE_ROWS - 257,
                           cell + (size_t) 256 * SAMPLE_COLUMNS);
    (void) !store_put_real(st, "/basin", "sliding_fraction", 0.125);
    (void) !store_put_count(st, "/basin", "audited", 1000);
}

/* Failures stick, so the last answer is the first failure. */
enum status sample_put(struct store *st)
{
    static struct point points[SAMPLE_POINTS];
    const struct record_array branch = { &point_type, points, SAMPLE_POINTS };
    const struct record_array none = { &steady_type, NULL, 0 };

    for (int i = 0; i < SAMPLE_POINTS; i++)
        for (int j = 0; j < 12; j++)
            points[i].value[j] = i + 0.01 * j;
    (void) !store_put_text(st, "/provenance", "scene", "law: a\nslope: b\n");
    (void) !store_put_text(st, "/provenance", "overrides", "");
    (void) !store_put_records(st, "/equilibria", &sample_states, NULL);
    (void) !store_put_records(st, "/none", &none, NULL);
    (void) !store_put_records(st, "/manifold/stable_upper", &branch, "arc");
    (void) !store_put_records(st, "/manifold/stable_lower", &branch, "arc");
    (void) !store_put_scalars(st, "/critical", &steady_type, &steady_states[0]);
    (void) !store_put_scalars(st, "/absent", &steady_type, &steady_states[1]);
    put_grid(st);
    return store_put_text(st, "/provenance", "version", "1");
}

static void open_are(unsigned kind, int count)
{
    assert_int_equal(H5Fget_obj_count(H5F_OBJ_ALL, kind), count);
}

/* A store keeps open its axes and the last group, and nothing else. */
static void open_after_puts(void)
{
    open_are(H5F_OBJ_DATASET, SAMPLE_AXES);
    open_are(H5F_OBJ_GROUP, 1);
    open_are(H5F_OBJ_ATTR, 0);
}

void sample_no_handles(void)
{
    open_are(H5F_OBJ_ALL, 0);
}

enum status sample_write(const char *name, struct fault *fault)
{
    struct store *st = NULL;
    enum status s = store_create(name, "sample", &st, fault);

    if (s == STATUS_OK) {
        const enum status put = sample_put(st);
        if (put == STATUS_OK)
            open_after_puts();
        s = store_commit(st, fault);
        assert_true(put == STATUS_OK || put == s);
    }
    store_free(&st);
    store_free(&st);
    sample_no_handles();
    return s;
}

void sample_must_write(const char *name)
{
    struct fault fault = { "" };
    const enum status s = sample_write(name, &fault);
    CHECK(s == STATUS_OK, "%s", fault.text);
}
