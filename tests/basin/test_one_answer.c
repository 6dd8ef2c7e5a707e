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
#include "found.h"
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

enum { MANY = 40 }; /* cells along an axis */

/* Some cells of a map of cells x cells, z in its midst, e^wide up and down. */
static void check_map(const struct draw *d, enum kind kind, struct vec2 z,
                      double wide, size_t cells, size_t looks, bool exactly,
                      uint64_t *rng, struct tally *t)
{
    static struct cell c[MANY * MANY];
    static int8_t label[MANY * MANY];
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
    assert_int_equal(fields_find(&s.fields, 0, cells, NULL, c), 0);
    assert_int_equal(basin_map_rows(m, 0, cells, label), 0);
    for (size_t i = 0; i < looks; i++) {
        const size_t at = check_bits(rng) % (cells * cells);
        const struct place p = { d,
                                 kind,
                                 { m->x[at % cells], m->y[at / cells] } };
        const struct told by_cell = of_cell(&c[at]);
        const struct told by_label = nothing(label[at]);
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

/* States that random draws found, and what was wrong. */
static const struct {
    struct found slope;
    struct vec2 z;
    const char *once; /* what was wrong */
} found[] = {
    { { FRICTION_LOG, THETA_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.48482161422022907, 0.0014286286554424344,
        0.0015960336171659596, 9.3854707273630734e-05, 33.924940774215052,
        1.1945937285144653e-05, 1.0199985328756537e-06, 0.4623460517114826,
        1e-4 },
      { 6.3623612032020898, 4.1288388426467364 },
      "loose steps along the separatrix" },
    { { FRICTION_LOG, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL_UNIT,
        TIMESCALE_SPINODAL, KINETICS_SINH, 0.369, 0.038361504765427351, 0.0489,
        0.0069910220770369258, 202.38139217152815, 4.5253109820583293e-07, 1e-6,
        0.35094118338267694, 1e-4 },
      { 7.7666756779721062, -3.4043296007384471 },
      "loose steps along the separatrix" },
    { { FRICTION_LOG, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_LINEAR, 0.369, 0.036799968362236195, 0.0489,
        0.00030768840904163447, 50.671533280808809, 3.2433801953985723e-08,
        1e-6, 0.35621990288265271, 1e-7 },
      { -0.25577625821924449, 0.25573882455558217 },
      "friction after the end of an orbit whose rest is known" },
    { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.369, 0.0341883255829512, 0.0489,
        0.00032861417612569131, 199.07262415076156, 3.9162183192137452e-07,
        1e-6, 0.30408286524863015, 1e-6 },
      { 3.8163842139126185, -3.8114840387865625 },
      "friction between knots of the slow curve" },
    { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_LINEAR, 0.22743075916543562, 0.0058313445692177845,
        0.010867383105932483, 0.012516267230041732, 30.890283751358446,
        0.00022474147709110868, 1.4434320233859645e-07, 0.21006248380805767,
        1e-5 },
      { 4.7415284522191303, -4.7415284522191303 },
      "mean friction over a slip known to a half" },
    { { FRICTION_LOG, THETA_PSI, PSI_SS_INVERSE, TIMESCALE_AGEING44,
        KINETICS_SINH, 0.54706376998726192, 0.094567233575633083,
        0.030054822197114205, 9.9513044800180115, 55.285076870724275,
        7.2457662545443423e-06, 8.7095135294389101e-05, 0.6919994827983386,
        1e-7 },
      { -2.9211244250302797, 18.562147473029356 },
      "push, by orbits whose bars forgot the digits of the state" },
    { { FRICTION_ASINH, THETA_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_SINH, 0.77691844239656127, 0.0028117398605124948,
        0.0050926795772213204, 0.0013463937895642809, 11.283833441873179,
        0.00070910291066307173, 5.817348992172551e-07, 0.7087409607605969,
        1e-4 },
      { -3.8760586712545813, 11.610013603481594 },
      "time past the saddle, to first order" },
    { { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_INVERSE, TIMESCALE_AGEING44,
        KINETICS_SINH, 0.14742199642207687, 0.041957421168991448,
        0.10185274528770955, 3.1677563637478046, 165517.91590901482,
        4.0675691065041833e-05, 0.00022894495708080124, 0.5099185642644057,
        1e-5 },
      { -6.9067216417734745, 4.3359740069779127 },
      "slip past the saddle, to first order" },
    { { FRICTION_ASINH, THETA_PSI, PSI_SS_SPINODAL, TIMESCALE_SLIP,
        KINETICS_SINH, 0.76555682289262428, 0.25494585321973545,
        0.360056900885524, 0.0, HUGE_VAL, 9.9165086104590147e-07,
        2.3008667414008238e-07, 0.8396126417764971, 1e-4 },
      { -3.411644507916348, -5.3245010056683277 },
      "slip past the saddle, to first order" },
    { { FRICTION_LOG, THETA_LN_PSI, PSI_SS_MINUS_LOG, TIMESCALE_SPINODAL,
        KINETICS_LINEAR, 0.56359415254261558, 0.010155987863377227,
        0.0039217356223450149, 5.0736522413511318e-05, 4.8096622451156117,
        2.5002173156945446e-05, 7.7963365865896948e-06, 0.44824030987615565,
        1e-8 },
      { -6.9333849796626298e-10, -21.089526157518492 },
      "slip of a start known to some digits along its orbit" },
    { { FRICTION_ASINH, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL, TIMESCALE_SLIP,
        KINETICS_SINH, 0.10836830081970357, 0.0037130387196230678,
        0.0075329433514028559, 0.0049093159695636854, 0.74530425701247671,
        1.6079482927218644e-05, 2.0806179629053314e-05, 0.11162554431223161,
        1e-6 },
      { -0.503659889971527, 0.1981887102485978 },
      "a box of arrest by whose corner an orbit goes" },
    { { FRICTION_ASINH, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL_UNIT,
        TIMESCALE_SPINODAL, KINETICS_SINH, 0.369, 0.037207369737874994, 0.0489,
        0.00011509123102340951, 435.98778244934584, 2.3457244383894821e-08,
        1e-6, 0.31855212658606474, 1e-5 },
      { 5.1802498083606814, -8.6114753235683494 },
      "a step that misses across its orbit what was estimated along it" },
    { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.369, 0.026333668901323527, 0.0489,
        0.00049074300887327405, 60.133393810930578, 4.1860474267079079e-06,
        1e-6, 0.40419249945748492, 1e-4 },
      { -10.533527918744753, -0.54891747196262131 },
      "a step whose estimate vanishes" },
    { { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_SPINODAL_UNIT, TIMESCALE_SLIP45,
        KINETICS_LINEAR, 0.10946609002968266, 0.0049491436119979641,
        0.016539180391215567, 0.033766696988162377, 1.3696578735272227,
        0.00016230191774945253, 4.4996318464821721e-08, 0.080117596454715917,
        1e-4 },
      { 27.782286433037864, 3.1726217048146848 },
      "a step whose estimate vanishes" },
    { { FRICTION_ASINH, THETA_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_LINEAR, 0.35838222826273081, 0.048745225148090814,
        0.010271319279817217, 0.013406343101165142, 2452.9873780463604,
        3.0262838996485415e-07, 0.00023098601944379621, 0.35698359402709817,
        1e-8 },
      { 6.3936640313684689, 13.897865290179778 },
      "slopes of the slow curve's knots that are mostly rounding" },
    { { FRICTION_LOG, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.59402751916929952, 0.015351586407853998,
        0.062243497090994644, 0.00017446094426540158, 8197.8300909377995,
        0.00039863880108191856, 1.5082563659867877e-05, 0.99523463462405171,
        1e-6 },
      { -9.6662550733904027, 12.808337279079629 },
      "a base point whose fibre is not that of the state" },
    { { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_SINH, 0.41410403466642653, 0.0087529388898655025,
        0.039770166828770034, 0.0, HUGE_VAL, 1.7000743598736656e-05,
        4.5641124349175146e-06, 0.10362603597122191, 1e-5 },
      { 6.6906998563487132, -15.675120607608676 },
      "a step over a bend that is small beside what it goes along" },
    { { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_LINEAR, 0.369, 0.025358480393082479, 0.0489,
        0.0048798127295660481, 48.390248828402015, 3.6345678915014544e-08, 1e-6,
        0.2695171658454639, 1e-4 },
      { 6.4694328345617969, 0.081544055362328921 },
      "loose steps along the separatrix" },
    { { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_MINUS_LOG, TIMESCALE_SLIP45,
        KINETICS_LINEAR, 0.43607592926725147, 0.0064652240491263821,
        0.0023475200781905019, 2.1908654918560221e-05, 404109.38334217726,
        6.6749327922710329e-05, 0.00016884887334311509, 0.3900385207639963,
        1e-5 },
      { -2.0471439198992928e-06, -13.099064943995469 },
      "friction between knots whose curvatures are noise" },
    { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_INVERSE, TIMESCALE_SLIP,
        KINETICS_LINEAR, 0.6527477132126065, 0.0019819584195257599,
        0.0020079098221206394, 0.00072699993910954586, 14369.164591146613,
        0.0001317677549768603, 6.080188730358422e-07, 0.5783044855984133,
        1e-6 },
      { 0.054953240998228813, -0.054953240998917491 },
      "the saddle's place, known worse than a state" },
    { { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_INVERSE, TIMESCALE_AGEING44,
        KINETICS_LINEAR, 0.25300930229857654, 0.0059113995304208335,
        0.0072357634905840648, 0.52135349067736003, 58930838.136952251,
        1.5135912694215926e-05, 1.0508384660146301e-07, 0.2963063472914074,
        1e-9 },
      { 20.849206333540842, 41.82311788837626 },
      "by 113 bits: a block that fades only once it has stopped" },
};

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

/* Slip per rounding of a place beside the face where it ends is 1e-9 and 1e-3.
 */
static void slip_holds_what_rounding_does_beside_a_face(void **state)
{
    static const struct {
        struct found slope;
        long double tan_alpha;
        struct vec2 z;
    } of[] = {
        { { FRICTION_ASINH, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL, TIMESCALE_SLIP,
            KINETICS_SINH, 0.4035469199735896, 0.10108313584722665,
            0.19403752308733591, 0.009520640690048706, 26.882066035064977,
            0.00048885582302031212, 3.8917050796854153e-08, 0.8820829951261275,
            1e-4 },
          1.21480810544308444787L,
          { -1.3652188881811844, 1.564100643909407 } },
        { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
            KINETICS_LINEAR, 0.39661208036849571, 0.044735916554059958,
            0.2230661753753071, 6.4589400724731902, HUGE_VAL,
            3.5416963011374195e-07, 0.00020839613333400845, 0.9272042584089243,
            1e-5 },
          1.33308069843681531311L,
          { 1.5893781303543708, -1.249652090809632 } },
    };
    enum { FACES = sizeof of / sizeof *of };
    static struct draw d;
    struct tally t = { 0 };

    (void) state;
    if (laws_emulated())
        skip();
    prepare(&t, FACES);
    for (size_t i = 0; i < FACES; i++) {
        found_scene(&of[i].slope, grid, &d.scene);
        d.scene.tan_alpha = of[i].tan_alpha;
        assert_true(make(&d));
        snprintf(d.name, sizeof d.name, "face %zu", i);
        check_state(&d, AT_CURVE, state_of(&d, of[i].z), true, EXACT_BOTH, &t);
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
        cmocka_unit_test(slip_holds_what_rounding_does_beside_a_face),
        cmocka_unit_test(push_basin_simulate_and_113_bits_give_one_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
