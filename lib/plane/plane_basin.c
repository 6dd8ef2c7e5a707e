/* Regions, labelled (plane_label.h), are shared out and bounded.  Orbits from
 * anywhere then audit the map. */
#include "plane_basin.h"
#include "plane_map.h"

#include <math.h>
#include <stdlib.h>

#include "plane_border.h"
#include "plane_branch.h"
#include "plane_label.h"
#include "plane_mosaic.h"
#include "plane_orbit.h"
#include "plane_patch.h"
#include "plane_rest.h"
#include "plane_tolerance.h"
#include "tolerance.h"

static struct measure measure_of(const struct plane_study *s)
{
    const struct box w = s->window.box;

    return (
        struct measure){ { s->window.exponential[0], s->window.exponential[1] },
                         { w.hi.x, w.hi.y } };
}

/* ---- shares -------------------------------------------------------------- */

/* Room for all attractors, what is beyond, and what is undecided. */
static enum status name_shares(struct plane_study *s)
{
    struct plane_basin *b = &s->basin;
    const size_t most = s->rests + s->beyonds + s->cycles + 2;
    size_t n = 0;

    b->share = calloc(most, sizeof *b->share);
    b->name = (const char **) calloc(most + 1, sizeof *b->name);
    if (b->share == NULL || b->name == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->rests; i++)
        if (plane_rest_attracts(&s->rest[i], false))
            b->name[n++] = s->rest[i].name;
    for (size_t i = 0; i < s->beyonds; i++)
        b->name[n++] = s->beyond[i].word;
    for (size_t k = 0; k < s->cycles; k++)
        if (s->cycle[k].type == PLANE_CYCLE_STABLE)
            b->name[n++] = s->cycle[k].name;
    if (n > INT8_MAX)
        return STATUS_BAD_SCENE;
    b->labels = n;
    b->name[n++] = "undecided";
    b->shares = n;
    for (size_t i = 0; i < n; i++)
        b->share[i].attractor = b->name[i];
    return STATUS_OK;
}

/* What borders along rows may be off, as a share. */
static double flat_error(const struct plane_study *s)
{
    const struct separatrix *c = &s->basin.cuts;
    double sum = 0.0;

    for (size_t i = 0; i < c->flats; i++)
        sum += c->flat[i].error / s->scale.side.y;
    return sum;
}

/* The area of thin bands, in which a curve may end. */
static double thin_part(const struct plane_study *s, const struct area area[])
{
    const struct regions *r = &s->basin.regions;
    double sum = 0.0;

    for (size_t i = 0; i < r->bands; i++)
        for (size_t k = 0; k <= r->band[i].strands; k++)
            if (!plane_patch_is_door(s, &r->band[i]))
                sum += fabs(area[r->band[i].first + k].value);
    return sum;
}

static void add_area(struct area *sum, struct area a)
{
    sum->value += a.value;
    sum->error += a.error;
}

static enum status share_out(struct plane_study *s, struct patches *p)
{
    struct plane_basin *b = &s->basin;
    const struct measure m = measure_of(s);
    const struct box w = s->window.box;
    const double all = measure_between(&m, 0, w.lo.x, w.hi.x) *
                       measure_between(&m, 1, w.lo.y, w.hi.y);
    const struct area *area = p->area;
    struct area *part = calloc(b->shares, sizeof *part);
    double sum = 0.0, missing = 0.0;

    if (part == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < b->regions.count; i++) {
        const int8_t label = b->regions.region[i].label;
        size_t k = 0;
        while (k < b->mosaics && b->mosaic[k].region != i)
            k++;
        if (k < b->mosaics)
            plane_mosaic_areas(s, p, k, m, part, b->labels);
        else
            add_area(&part[label < 0 ? b->labels : (size_t) label], area[i]);
    }
    for (size_t k = 0; k < b->shares; k++)
        sum += part[k].value / all;
    missing =
        fabs(1.0 - sum) + flat_error(s) + thin_part(s, area) / all + b->shut;
    for (size_t k = 0; k < b->shares; k++)
        b->share[k].fraction = quantity_of(fmax(part[k].value / all, 0.0),
                                           part[k].error / all + missing +
                                               TOL_FAR_BELOW * TOL_ROUNDED);
    free(part);
    return STATUS_OK;
}

/* ---- audit --------------------------------------------------------------- */

/* Whether attractors in the window are where they themselves go: one that is
 * not is beyond a border that was not found. */
static enum status check_rests(const struct plane_study *s, size_t *asked,
                               size_t *wrong)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->listed && status == STATUS_OK; i++) {
        const struct plane_goal goal = { .kind = PLANE_GOAL_REST, .index = i };
        int8_t label = -1;
        if (!plane_rest_attracts(&s->rest[i], false))
            continue;
        status = plane_map_at(s, s->rest[i].z, true, &label);
        *asked += label >= 0;
        *wrong += label >= 0 && !plane_goal_allows(s, label, &goal);
    }
    return status;
}

/* Of an audit: how many went where that is known, and what it took. */
struct counts {
    size_t asked, wrong, steps;
    bool failed;
};

/* States number first .. last - 1. */
static void audit_part(const struct plane_study *s, size_t first, size_t last,
                       struct counts *c)
{
    const double shift = 0.5 + 1e-3 * (double) (s->scene->seed % 997);
    size_t asked = 0, wrong = 0, steps = 0, failed = 0;

#pragma omp parallel for schedule(dynamic, 8)                                  \
    reduction(+ : asked, wrong, steps, failed)
    for (size_t i = first; i < last; i++) {
        const struct vec2 z =
            window_at(&s->window, vec2_spread(shift, (double) i + 1.0));
        struct plane_goal goal;
        int8_t label;
        if (plane_map_at(s, z, true, &label) != STATUS_OK ||
            (label >= 0 &&
             plane_orbit(s, z, false, NULL, &goal) != STATUS_OK)) {
            failed++;
        } else if (label >= 0) {
            const bool told = goal.kind != PLANE_GOAL_NONE;
            asked += told;
            wrong += told && !plane_goal_allows(s, label, &goal);
            steps += goal.steps;
        }
    }
    c->asked += asked;
    c->wrong += wrong;
    c->steps += steps;
    c->failed = c->failed || failed > 0;
}

static enum status audit(struct plane_study *s, const struct monitor *monitor)
{
    enum { PART = 32 };
    struct plane_basin *b = &s->basin;
    const size_t n = s->scene->audit;
    struct counts c = { .asked = 0 };

    for (size_t i = 0; i < n && c.steps < TOL_PLANE_WORK; i += PART) {
        if (monitor_tell(monitor, "audit", i, n))
            return STATUS_STOPPED;
        audit_part(s, i, i + PART < n ? i + PART : n, &c);
    }
    if (!c.failed)
        c.failed = check_rests(s, &c.asked, &c.wrong) != STATUS_OK;
    b->cells = (int64_t) c.asked;
    b->disagreements = (int64_t) c.wrong;
    b->steps += (int64_t) c.steps;
    for (size_t k = 0; k < b->shares && c.wrong > 0; k++)
        b->share[k].fraction.error +=
            (double) c.wrong / (double) c.asked + 3.0 / sqrt((double) c.asked);
    return c.failed ? STATUS_NO_MEMORY : STATUS_OK;
}

/* ---- the boundary -------------------------------------------------------- */

/* Which borders have different labels on their sides within the window. */
static void mark_borders(struct patches *p, struct plane_study *s)
{
    const struct box w = s->window.box;

    for (size_t i = 0; i < p->r->bands; i++) {
        const struct band *band = &p->r->band[i];
        const double y =
            off_middle(fmax(band->lo, w.lo.y), fmin(band->hi, w.hi.y));
        const size_t n = separatrix_row(p->r->separatrix, y, p->below);
        if (n != band->strands || !(band->hi > w.lo.y && band->lo < w.hi.y))
            continue;
        for (size_t k = 0; k < n; k++) {
            const size_t region = band->first + k;
            const struct vec2 z = { p->below[k].at, y };
            const int8_t left = plane_mosaic_at(s, region, z, p->below),
                         right = plane_mosaic_at(s, region + 1, z, p->below);
            if (left == right || z.x < w.lo.x || z.x > w.hi.x)
                continue;
            for (size_t j = 0; j < s->basin.borders; j++)
                s->basin.border[j].divides |=
                    p->below[k].strand >= s->basin.border[j].first &&
                    p->below[k].strand < s->basin.border[j].last;
        }
    }
}

/* The same of borders along a row. */
static enum status mark_flats(struct plane_study *s)
{
    const struct box w = s->window.box;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->basin.cuts.flats && status == STATUS_OK; i++) {
        const struct flat *f = &s->basin.cuts.flat[i];
        const double from = fmax(f->from, w.lo.x), to = fmin(f->to, w.hi.x);
        const double off = f->error + TOL_SAME * s->scale.side.y;
        int8_t side[2];
        if (!(from < to) || f->w < w.lo.y || f->w > w.hi.y)
            continue;
        for (int k = 0; k < 2 && status == STATUS_OK; k++)
            status = plane_map_at(
                s,
                (struct vec2){ off_middle(from, to), f->w + (k ? off : -off) },
                true, &side[k]);
        s->basin.border[f->chain].divides |= side[0] != side[1];
    }
    return status;
}

/* By their manifolds and cycles, each once. */
static enum status list_boundary(struct plane_study *s)
{
    struct plane_basin *b = &s->basin;

    b->boundary = calloc(2 * b->borders + 1, sizeof *b->boundary);
    if (b->boundary == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < b->borders; i++) {
        const size_t of = b->border[i].of;
        bool known = !b->border[i].divides;
        for (size_t k = 0; k < i; k++)
            known = known || (b->border[k].of == of && b->border[k].divides);
        if (known)
            continue;
        if (of >= s->listed_branches)
            b->boundary[b->boundaries++] = (struct plane_boundary){
                RECORD_COUNT_NONE, of < s->branches
                                       ? s->rest[s->branch[of].rest].name
                                       : s->cycle[of - s->branches].name
            };
        else
            for (size_t k = 0; k < 2; k++)
                b->boundary[b->boundaries++] =
                    (struct plane_boundary){ (int64_t) (of + k),
                                             s->rest[s->branch[of].rest].name };
    }
    return STATUS_OK;
}

/* ---- all ----------------------------------------------------------------- */

static enum status room_for_patches(struct patches *p)
{
    const size_t room = p->r->most + 1, n = p->r->count + 1;

    p->of = calloc(n, sizeof *p->of);
    p->alone = calloc(n, sizeof *p->alone);
    p->area = calloc(n, sizeof *p->area);
    p->part = calloc(n, sizeof *p->part);
    p->goal = calloc(n, sizeof *p->goal);
    p->below = calloc(room, sizeof *p->below);
    p->above = calloc(room, sizeof *p->above);
    p->before = calloc(room, sizeof *p->before);
    const bool all = p->of && p->alone && p->area && p->part && p->goal &&
                     p->below && p->above && p->before;
    return all ? STATUS_OK : STATUS_NO_MEMORY;
}

static void free_patches(struct patches *p)
{
    free(p->of);
    free(p->alone);
    free(p->area);
    free(p->part);
    free(p->goal);
    free(p->below);
    free(p->above);
    free(p->before);
}

/* Cuts the window by all borders that are known, and labels its regions. */
static enum status cut(struct plane_study *s, struct patches *p,
                       const struct monitor *monitor, bool *news)
{
    enum status status = plane_branch_grow_outside(s);

    if (status == STATUS_OK)
        status = plane_border_find(s);
    if (status == STATUS_OK)
        status = regions_init(&s->basin.regions, &s->basin.cuts);
    if (status == STATUS_OK)
        status = room_for_patches(p);
    if (status != STATUS_OK)
        return status;
    regions_areas(p->r, s->window.box, measure_of(s), p->below, p->area);
    return plane_label_all(s, p, monitor, news);
}

static enum status share_and_audit(struct plane_study *s, struct patches *p,
                                   const struct monitor *monitor)
{
    enum status status = name_shares(s);

    if (status != STATUS_OK)
        return status;
    mark_borders(p, s);
    status = share_out(s, p);
    if (status == STATUS_OK)
        status = mark_flats(s);
    if (status == STATUS_OK)
        status = list_boundary(s);
    return status ? status : audit(s, monitor);
}

/* Beside cycles that are new. */
static enum status look_again(struct plane_study *s, size_t cycles, bool *news)
{
    const size_t all = s->cycles;
    const enum status status = plane_border_look(s, s->rests, cycles);

    *news = *news || s->cycles > all;
    return status;
}

enum status plane_basin_find(struct plane_study *s,
                             const struct monitor *monitor)
{
    struct patches p;
    enum status status = plane_border_look(s, 0, 0);
    size_t cycles;
    bool news = true;

    while (news && status == STATUS_OK) {
        plane_basin_free(&s->basin);
        s->beyonds = 0;
        cycles = s->cycles;
        p = (struct patches){ .s = s, .r = &s->basin.regions };
        status = cut(s, &p, monitor, &news);
        if (status == STATUS_OK)
            status = look_again(s, cycles, &news);
        if (status == STATUS_OK && !news)
            status = share_and_audit(s, &p, monitor);
        free_patches(&p);
    }
    return status;
}

void plane_basin_free(struct plane_basin *b)
{
    for (size_t i = 0; i < b->borders; i++)
        for (int k = 0; k < 2; k++)
            branch_free(&b->border[i].half[k]);
    free(b->border);
    for (size_t i = 0; i < b->mosaics; i++)
        free(b->mosaic[i].label);
    free(b->mosaic);
    free(b->goal);
    regions_free(&b->regions);
    separatrix_free(&b->cuts);
    separatrix_free(&b->columns);
    free(b->share);
    free((void *) b->name);
    free(b->boundary);
    *b = (struct plane_basin){ .border = NULL };
}
