/* push (by its table), whole orbits, basin maps zoomed on a state, simulate and
 * 113 bits give one answer, within bars: fate, slip, time, friction and peaks
 * of random states of random laws, materials and slopes - next to the saddle,
 * next to the separatrix, next to the slow curve, at the corners of the boxes
 * of arrest and anywhere.
 *
 * Routes are held to each other, simulate at every twentieth; one state in
 * ANSWER_EACH (11; 1: all) is held to 113 bits, some 0.1 s each.
 * ANSWER_STATES=20000 tries more than a test can afford, CHECK_SEED others,
 * ANSWER_TELL=1 prints each lie as it is found.
 */
#include "answers.h"
#include "found_states.h"
#include "tolerance.h"

#define NEAREST 1e-11
enum { EACH = 20, FEW = 2, DISTANCES = 14 };

static size_t asked(const char *name, size_t usual)
{
    const char *asked = getenv(name);
    return asked ? (size_t) strtoul(asked, NULL, 10) : usual;
}

/* ---- random slopes ------------------------------------------------------- */

/* Three of four have a saddle. */
static void draw(size_t i, uint64_t *rng, struct draw *d)
{
    for (int attempt = 0; attempt < 200; attempt++) {
        slope_scene(&d->scene, "spinodal", NULL, "0.34", grid);
        d->scene.cell_rtol = pow(10.0, -4.0 - (double) (check_bits(rng) % 6));
        if (drawn_law(i, rng, &d->scene) && drawn_slope(rng, &d->scene) &&
            make(d)) {
            if (slider_saddle(&d->study.slider) >= 0 || attempt % 4 == 3) {
                drawn_name(i, &d->scene, d->name);
                return;
            }
            push_free(&d->push);
            study_free(&d->study);
        }
        scene_free(&d->scene);
    }
    fail_msg("no slope");
}

/* ---- states -------------------------------------------------------------- */

static double side(uint64_t *rng)
{
    return check_bits(rng) % 2 ? 1.0 : -1.0;
}

/* 10^-U(0, 14) */
static double distance(uint64_t *rng)
{
    return pow(10.0, -check_uniform(rng, 0.0, DISTANCES));
}

static struct vec2 anywhere(const struct draw *d, uint64_t *rng)
{
    const struct planar *p = &d->study.slider.plane.system;
    struct vec2 z;

    do
        z = (struct vec2){ p->origin.x + check_uniform(rng, -12, 12),
                           p->origin.y + check_uniform(rng, -7, 7) };
    while (!push_holds(&d->push, state_of(d, z)));
    return z;
}

static struct vec2 beside_saddle(const struct draw *d, uint64_t *rng)
{
    const double angle = check_uniform(rng, 0.0, 6.283185307179586);
    const double r = distance(rng);
    const struct vec2 z =
        d->study.slider.plane.equilibrium[slider_saddle(&d->study.slider)].z;

    return (struct vec2){ z.x + r * cos(angle), z.y + r * sin(angle) };
}

/* In the row of z. */
static struct vec2 beside_boundary(const struct draw *d, struct vec2 z,
                                   uint64_t *rng)
{
    struct push_answer a;

    assert_int_equal(push_find(&d->push, state_of(d, z), NULL, &a), 0);
    if (quantity_exists(&a.v_kick))
        z.x += log(a.v_kick.value) + side(rng) * distance(rng);
    return z;
}

static struct vec2 beside_curve(const struct draw *d, struct vec2 z,
                                uint64_t *rng)
{
    const struct vec2 origin = d->study.slider.plane.system.origin;
    struct slow_point p;

    if (slow_curve_at(&d->push.fast.curve, z.y - origin.y, &p))
        z.x = origin.x + p.x + side(rng) * distance(rng);
    return z;
}

/* Outside a box by so much of its size (or inside), next to a face of it or to
 * a corner: one of eight places. */
static struct vec2 beside_box(struct vec2 node, double off, uint64_t place)
{
    const double r = TOL_ARREST * (1.0 + off);

    node.x += place & 1 ? r : -r;
    node.y += (place & 2 ? 1.0 : -1.0) * (place & 4 ? r : 0.5 * TOL_ARREST);
    return node;
}

/* Nearer to a face of the box than a state's digits are, nobody can tell on
 * which side it is. */
static struct vec2 at_corner(const struct draw *d, struct vec2 z, uint64_t *rng)
{
    const struct phase_plane *p = &d->study.slider.plane;

    for (size_t i = p->equilibria; i-- > 0;)
        if ((int) i != slider_saddle(&d->study.slider) &&
            check_bits(rng) % 2 == 0) {
            const double off = side(rng) * fmax(distance(rng), NEAREST);
            z = beside_box(p->equilibrium[i].z, off, check_bits(rng));
        }
    return z;
}

static struct vec2 draw_point(const struct draw *d, enum kind kind,
                              uint64_t *rng)
{
    const struct vec2 z = anywhere(d, rng);

    switch (kind) {
        case AT_SADDLE:
            return slider_saddle(&d->study.slider) < 0 ? z
                                                       : beside_saddle(d, rng);
        case AT_BOUNDARY:
            return beside_boundary(d, z, rng);
        case AT_CURVE:
            return beside_curve(d, z, rng);
        case AT_CORNER:
            return at_corner(d, z, rng);
        default:
            return z;
    }
}

/* ---- maps -----------------------------------------------------------------
 */

enum { MANY = 24 }; /* cells along an axis */

/* Some cells of a map of cells x cells, z in its midst, e^wide up and down. */
static void check_map(const struct draw *d, enum kind kind, struct vec2 z,
                      double wide, size_t cells, size_t looks, bool exactly,
                      uint64_t *rng, struct tally *t)
{
    struct cell c[MANY];
    int8_t label[MANY];
    const struct vec2 half = { wide, wide };
    const struct push_state lo = state_of(d, vec2_sub(z, half));
    const struct push_state hi = state_of(d, vec2_add(z, half));
    struct scene scene = d->scene;
    struct study s;
    struct fault why;
    struct quad_orbit truth;

    if (!push_holds(&d->push, lo) || !push_holds(&d->push, hi))
        return;
    scene.cells[0] = scene.cells[1] = cells;
    scene.window =
        (struct scene_window){ .v = { lo.v, hi.v }, .psi = { lo.psi, hi.psi } };
    const enum status status = study_run(&s, &scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s: %s", d->name, why.text);
    const struct basin_map *m = &s.basins;
    for (size_t i = 0; i < looks; i++) {
        const size_t at = check_bits(rng) % (cells * cells);
        const size_t column = at % cells, row = at / cells;
        const struct place p = { d, kind, { m->x[column], m->y[row] } };
        assert_int_equal(fields_find(&s.fields, row, 1, NULL, c), 0);
        assert_int_equal(basin_map_rows(m, row, 1, label), 0);
        const struct told by_cell = of_cell(&c[column]);
        const struct told by_label = nothing(label[column]);
        compare(t, &p, BY_MAP, &by_cell, BY_MAP, &by_label);
        t->states++;
        t->undecided[kind] += by_cell.fate == FATE_UNDECIDED;
        if (!exactly)
            continue;
        quad_orbit_find(&d->truth, (quad) p.z.x, (quad) p.z.y, 1e-8, &truth);
        judge(t, &p, BY_MAP, &by_cell, &truth);
        t->exact++;
    }
    study_free(&s);
}

static void push_basin_simulate_and_113_bits_give_one_answer(void **state)
{
    const size_t states = asked("ANSWER_STATES", 500);
    const size_t each = asked("ANSWER_EACH", 11);
    static struct draw d;
    struct tally t = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, states + EACH);
    for (size_t i = 0; t.states < states; i++) {
        draw(i, &rng, &d);
        for (int k = 0; k < EACH; k++) {
            const bool in_map = k == EACH - 1;
            const enum kind kind = (enum kind)(in_map ? check_bits(&rng) % KINDS
                                                      : (size_t) k % KINDS);
            const struct vec2 z = draw_point(&d, kind, &rng);
            const size_t n = i * EACH + (size_t) k;
            const unsigned exactly = n % each ? EXACT_NONE : 1 + n / each % 2;
            if (!in_map)
                check_state(&d, kind, state_of(&d, z), k == 0, exactly, &t);
            else
                check_map(&d, kind, z, laws_power(&rng, -12, 0), FEW, 1,
                          exactly != EXACT_NONE, &rng, &t);
        }
        release(&d);
    }
    finish(&t);
    CHECK(20 * t.overruled <= t.states, "%zu", t.overruled);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

/* ---- found --------------------------------------------------------------- */

/* A slope of a preset; of these states each was once told wrongly. */
static void make_preset(struct draw *d, const char *law, const char *alpha,
                        double rtol)
{
    slope_scene(&d->scene, law, NULL, alpha, grid);
    d->scene.cell_rtol = rtol;
    assert_true(make(d));
    snprintf(d->name, sizeof d->name, "%s at %s, rtol %g", law, alpha, rtol);
}

static void maps_zoomed_on_to_the_saddle_are_right(void **state)
{
    static const struct {
        const char *law, *alpha;
        double rtol;
    } of[] = { { "spinodal_gen", "0.34", 1e-4 },
               { "spinodal", "0.30", 1e-6 },
               { "spinodal_phi_gen", "0.36", 1e-9 },
               { "dieterich_gen", "0.34", 1e-6 } };
    enum { MAPS = sizeof of / sizeof *of, LOOKS = 6 };
    static struct draw d;
    struct tally t = { 0 };
    uint64_t rng = check_seed();

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, MAPS * LOOKS);
    for (size_t i = 0; i < MAPS; i++) {
        make_preset(&d, of[i].law, of[i].alpha, of[i].rtol);
        check_map(&d, AT_SADDLE, d.study.slider.plane.system.origin,
                  laws_power(&rng, -12, -2), MANY, LOOKS, true, &rng, &t);
        release(&d);
    }
    finish(&t);
    CHECK(t.lies == 0 && t.exact == MAPS * LOOKS, "%zu lies", t.lies);
}

static void states_beside_boxes_of_arrest_slip_to_their_faces(void **state)
{
    static const double far[] = { 1e-2, 1e-11, -1e-11, 1e-9, -1e-9 };
    static const char *const law[] = { "spinodal_gen", "dieterich_gen",
                                       "spinodal" };
    enum { PLACES = 8 };
    static struct draw d;
    struct tally t = { 0 };

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, 100);
    for (size_t i = 0; i < sizeof law / sizeof *law; i++) {
        make_preset(&d, law[i], "0.34", 1e-6);
        const struct phase_plane *p = &d.study.slider.plane;
        for (size_t k = 0; k < p->equilibria * PLACES; k++)
            if ((int) (k / PLACES) != slider_saddle(&d.study.slider)) {
                const double off = far[(i + k) % (sizeof far / sizeof *far)];
                const struct vec2 z =
                    beside_box(p->equilibrium[k / PLACES].z, off, k);
                check_state(&d, AT_CORNER, state_of(&d, z), true, 1 + k % 2,
                            &t);
            }
        release(&d);
    }
    finish(&t);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

static void states_that_random_ones_found_have_one_answer(void **state)
{
    enum { FOUND = sizeof found / sizeof *found };
    static struct draw d;
    struct tally t = { 0 };

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, FOUND);
    for (size_t i = 0; i < FOUND; i++) {
        found_scene(&found[i].slope, grid, &d.scene);
        assert_true(make(&d));
        snprintf(d.name, sizeof d.name, "%s", found[i].once);
        check_state(&d, ANYWHERE, state_of(&d, found[i].z), true, EXACT_BOTH,
                    &t);
        release(&d);
    }
    finish(&t);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

static void states_of_slopes_told_to_all_digits_have_one_answer(void **state)
{
    enum { TOLD = sizeof told / sizeof *told };
    static struct draw d;
    struct tally t = { 0 };

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, TOLD);
    for (size_t i = 0; i < TOLD; i++) {
        found_scene(&told[i].slope, grid, &d.scene);
        d.scene.tan_alpha = told[i].tan_alpha;
        assert_true(make(&d));
        snprintf(d.name, sizeof d.name, "%s", told[i].once);
        check_state(&d, ANYWHERE, state_of(&d, told[i].z), true,
                    told[i].exactly, &t);
        release(&d);
    }
    finish(&t);
    CHECK(t.lies == 0, "%zu lies", t.lies);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_zoomed_on_to_the_saddle_are_right),
        cmocka_unit_test(states_beside_boxes_of_arrest_slip_to_their_faces),
        cmocka_unit_test(states_that_random_ones_found_have_one_answer),
        cmocka_unit_test(states_of_slopes_told_to_all_digits_have_one_answer),
        cmocka_unit_test(push_basin_simulate_and_113_bits_give_one_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
