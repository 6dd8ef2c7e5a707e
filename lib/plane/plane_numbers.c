#include "plane_numbers.h"

#include <float.h>
#include <math.h>

#include "plane_label.h"
#include "plane_rest.h"
#include "plane_results.h"
#include "plane_tolerance.h"

#define ASKED(product) ((uint64_t) 1 << PRODUCT_##product)

/* ---- what is counted ----------------------------------------------------- */

static struct quantity share_of(const struct plane_study *s,
                                const struct plane_goal *goal,
                                const char *reason)
{
    const int8_t label = plane_goal_label(s, goal);

    return label < 0 || !s->basin.share ? quantity_none(reason)
                                        : s->basin.share[label].fraction;
}

static struct quantity share_of_rest(const struct plane_study *s, size_t i)
{
    const struct plane_goal goal = { .kind = PLANE_GOAL_REST, .index = i };

    return plane_rest_attracts(&s->rest[i], false)
               ? share_of(s, &goal, "no basins")
               : quantity_none("it does not attract");
}

static struct quantity sum_of(struct quantity p, struct quantity q)
{
    return quantity_of(p.value + q.value, p.error + q.error);
}

/* Sums over all equilibria outside the window, over all else beyond it, or
 * over what ends where formulas have no values. */
static struct quantity share_beyond(const struct plane_study *s, bool rests,
                                    bool breaks)
{
    struct quantity sum = quantity_of(0.0, 0.0);

    for (size_t i = s->listed; i < s->rests && rests && !breaks; i++)
        if (plane_rest_attracts(&s->rest[i], false))
            sum = sum_of(sum, share_of_rest(s, i));
    for (size_t i = 0; i < s->beyonds; i++)
        if (s->beyond[i].rests == rests && s->beyond[i].breaks == breaks)
            sum =
                sum_of(sum, s->basin.share[plane_goal_beyond(s) + i].fraction);
    return sum;
}

/* Sums over all cycles that attract. */
static struct quantity share_of_cycles(const struct plane_study *s)
{
    struct quantity sum = quantity_of(0.0, 0.0);

    for (size_t k = 0; k < s->cycles; k++) {
        const struct plane_goal goal = { .kind = PLANE_GOAL_CYCLE, .index = k };
        if (s->cycle[k].type != PLANE_CYCLE_STABLE)
            continue;
        sum = sum_of(sum, share_of(s, &goal, "no basins"));
    }
    return sum;
}

void plane_numbers_add(struct plane_study *s)
{
    s->basin.elsewhere = (struct plane_elsewhere){
        share_beyond(s, false, false),
        share_beyond(s, true, false),
        share_beyond(s, true, true),
        share_of_cycles(s),
        s->basin.share[s->basin.labels].fraction,
    };
}

/* Off the curve by d, the place on the edge is off by d (1 + |t|), t how much
 * the curve goes along the edge where it goes one across. */
static void fill_leaves(const struct plane_study *s, struct plane_branch *b)
{
    const struct curve *c = &b->curve.curve;
    const struct plane_rest *r = &s->rest[b->rest];
    const struct box w = s->window.box;
    double at[CURVE_DIM_MAX], slope[CURVE_DIM_MAX];

    b->leaves[0] = b->leaves[1] =
        quantity_none(b->end < 0 || b->end == PLANE_END_STEPS
                          ? "where it ends is not known"
                          : "it does not leave the window");
    if (b->shown == 0 || (b->shown == c->count && b->shown_to == 1.0))
        return;
    curve_at(c, b->shown - 1, b->shown_to, at);
    curve_slope_at(c, b->shown - 1, b->shown_to, slope);
    const double z[] = { r->z.x + at[0], r->z.y + at[1] };
    const double off[] = { (z[0] - w.lo.x) / s->scale.side.x,
                           (w.hi.x - z[0]) / s->scale.side.x,
                           (z[1] - w.lo.y) / s->scale.side.y,
                           (w.hi.y - z[1]) / s->scale.side.y };
    const double turns[] = { s->scale.period.x, s->scale.period.y };

    b->edge = turns[0] > 0.0 ? 2 : 0; /* an angle has no edge */
    for (int8_t i = 0; i < 4; i++)
        if (!(turns[i / 2] > 0.0) && off[i] < off[b->edge])
            b->edge = i;
    const int across = b->edge / 2;
    const double along = fabs(slope[1 - across] / slope[across]);
    const double error =
        (c->piece[b->shown - 1].error + vec2_length(r->error)) * (1.0 + along);

    for (int i = 0; i < 2; i++) {
        const double x = plane_state(s, i, z[i]);
        const double steep = scene_axis_is_log(s->scene, i) ? fabs(x) : 1.0;
        b->leaves[i] =
            isfinite(x) && isfinite(error)
                ? quantity_of(x, steep * error + TOL_ROUNDINGS_MANY *
                                                     DBL_EPSILON *
                                                     (fabs(x) + steep))
                : quantity_none("no bound on its error could be found");
    }
}

void plane_numbers_fill(struct plane_study *s)
{
    for (size_t i = 0; i < s->branches; i++)
        fill_leaves(s, &s->branch[i]);
    s->count = (struct plane_count){
        .equilibria = (int64_t) s->listed,
        .undecided = (int64_t) s->undecided_count,
        .saddles = (int64_t) s->saddles,
    };
    for (size_t i = 0; i < s->listed; i++)
        s->count.attractors += plane_rest_attracts(&s->rest[i], false);
    for (size_t k = 0; k < s->cycles; k++) {
        s->count.cycles++;
        s->count.attractors += s->cycle[k].type == PLANE_CYCLE_STABLE;
    }
    for (size_t i = 0; i < s->rests && s->basin.share; i++)
        s->rest[i].share = share_of_rest(s, i);
}

/* ---- described ----------------------------------------------------------- */

RESULT_VIEW(view_count, plane_study, &s->count, 1)
RESULT_VIEW(view_share, plane_study, &s->rest[k], 1)
RESULT_VIEW(view_elsewhere, plane_study, &s->basin.elsewhere, 1)

RESULT_COUNT(count_rests, plane_study, s->listed)

static const struct record_type record_count = RECORD(
    plane_count, "count", "how many there are",
    FIELD(plane_count, COUNT, equilibria, "1", "found in the window"),
    FIELD(plane_count, COUNT, undecided, "1", "boxes that may hold others"),
    FIELD(plane_count, COUNT, saddles, "1", "among the equilibria"),
    FIELD(plane_count, COUNT, cycles, "1", "closed orbits that were met"),
    FIELD(plane_count, COUNT, attractors, "1", "equilibria and cycles"));

static const struct record_type record_share =
    RECORD(plane_rest, "share", "the basin of an equilibrium",
           FIELD_AS(plane_rest, QUANTITY, "fraction", share, "1",
                    "of the window, by area as it is drawn"));

static const struct record_type record_elsewhere = RECORD(
    plane_elsewhere, "elsewhere", "shares that are no equilibrium's",
    FIELD(plane_elsewhere, QUANTITY, infinity, "1", "goes beyond all bounds"),
    FIELD(plane_elsewhere, QUANTITY, outside, "1",
          "comes to rest outside the window"),
    FIELD(plane_elsewhere, QUANTITY, singularity, "1",
          "ends where the formulas have no values"),
    FIELD(plane_elsewhere, QUANTITY, cycles, "1", "goes to closed orbits"),
    FIELD(plane_elsewhere, QUANTITY, undecided, "1", "is not known"));

const struct result plane_number_results[] = {
    { .name = "count", .type = &record_count, .view = view_count },
    { .name = "equilibria[K].basin",
      .type = &record_share,
      .needs = ASKED(BASINS),
      .fewer = "there are fewer equilibria",
      .count = count_rests,
      .view = view_share },
    { .name = "basin",
      .type = &record_elsewhere,
      .needs = ASKED(BASINS),
      .view = view_elsewhere },
    { .path = NULL },
};

/* ---- a frame ------------------------------------------------------------- */

enum status plane_numbers_frame(struct plane_study *frame,
                                const struct scene *scene)
{
    *frame = (struct plane_study){ .scene = scene,
                                   .products = scene->products |
                                               1u << PRODUCT_EQUILIBRIA,
                                   .listed = PLANE_RESTS_ALONE };
    for (int i = 0; i < 2; i++)
        frame->system[0].axis[i].name = scene->system->state[i].name;
    return plane_results_make(frame);
}

void plane_numbers_free(struct plane_study *frame)
{
    plane_results_free(frame->table);
    *frame = (struct plane_study){ .scene = NULL };
}

enum status plane_numbers(struct result_numbers *n,
                          const struct plane_study *frame)
{
    const struct results all = plane_results(frame);

    return result_numbers_init(n, &all);
}

bool plane_numbers_lack(const struct plane_study *s)
{
    const struct plane_basin *b = &s->basin;

    /* an audit that disagrees widens all bars by far more than is seen */
    return b->share && b->share[b->labels].fraction.value >
                           fmin(b->share[b->labels].fraction.error, TOL_SEEN);
}
