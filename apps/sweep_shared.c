#include "sweep_shared.h"

#include <stdio.h>
#include <stdlib.h>

#include "crew.h"
#include "parts.h"
#include "progress.h"

/* What all ways of running it have in common. */
struct shared {
    const struct scene *scene;
    const struct options *o;
    const char *journal;
    bool resume;
    struct fault *why;
};

static enum status run(struct sweep *s, const struct shared *h,
                       const struct sweep_options *how)
{
    const enum status status =
        sweep_run(s, h->scene, how, progress_monitor(h->o), h->why);

    progress_end();
    return status;
}

/* Goes on with what shares have left, which is then in the own side file.
 * share: NULL: computes the rest. */
static enum status join(struct sweep *s, const struct shared *h,
                        const struct parts *parts,
                        const struct sweep_share *share)
{
    const struct sweep_options how = {
        .journal = h->journal,
        .resume = h->resume,
        .version = SLIPWAY_VERSION,
        .share = share,
        .other = (const char *const *) parts->path,
        .others = parts->count,
        .join = true,
    };
    const enum status status = run(s, h, &how);

    if (status == STATUS_OK)
        parts_forget(parts);
    return status;
}

/* ---- alone ----------------------------------------------------------------
 */

static enum status run_alone(struct sweep *s, const struct shared *h)
{
    struct parts parts = { .path = NULL };
    enum status status = STATUS_OK;

    if (h->resume)
        status = parts_find(h->journal, &parts);
    if (status == STATUS_OK && command_id(h->o->command) == COMMAND_MERGE)
        status = parts_check(&parts, h->journal, h->why);
    if (status == STATUS_OK)
        status = join(s, h, &parts, NULL);
    parts_free(&parts);
    return status;
}

/* ---- a share --------------------------------------------------------------
 */

/* Every `shares`-th point. */
static size_t next_of_share(void *ctx, size_t count)
{
    struct part *p = ctx;
    const size_t at = p->share < count ? p->share : count;

    p->share += p->shares;
    return at;
}

static enum status run_share(struct sweep *s, const struct shared *h)
{
    struct part part;
    const struct sweep_share share = { next_of_share, &part };
    enum status status = part_parse(h->o->shard, &part, h->why);

    if (status != STATUS_OK)
        return status;
    char *path = part_path(h->journal, part);
    const struct sweep_options how = { .journal = path,
                                       .resume = h->resume,
                                       .version = SLIPWAY_VERSION,
                                       .share = &share };
    part.share--;
    status = path ? run(s, h, &how) : STATUS_NO_MEMORY;
    free(path);
    return status;
}

/* ---- ranks ----------------------------------------------------------------
 */

static size_t next_of_nobody(void *ctx, size_t count)
{
    (void) ctx;
    return count;
}

/* The first rank's turn: how many points are missing.  Side files that are not
 * to be resumed go. */
static enum status join_ranks(struct sweep *s, const struct shared *h,
                              size_t *missing)
{
    static const struct sweep_share nobody = { next_of_nobody, NULL };
    struct parts parts;
    enum status status = parts_find(h->journal, &parts);

    if (status == STATUS_OK && !h->resume) {
        parts_forget(&parts);
        parts_free(&parts);
    }
    if (status == STATUS_OK)
        status = join(s, h, &parts, &nobody);
    *missing = status == STATUS_OK ? s->missing : 0;
    if (*missing > 0) {
        const size_t taken = s->taken;
        sweep_free(s);
        s->taken = taken;
    }
    parts_free(&parts);
    return status;
}

/* A rank's turn: some of the points that are missing, into its side file. */
static enum status run_rank(const struct shared *h)
{
    const struct sweep_share share = { crew_share_next, NULL };
    char *path =
        part_path(h->journal, (struct part){ crew_rank() + 1, crew_ranks() });
    const struct sweep_options how = { .journal = path,
                                       .version = SLIPWAY_VERSION,
                                       .share = &share,
                                       .other = &h->journal,
                                       .others = 1 };
    struct sweep s;
    const enum status status = path ? run(&s, h, &how) : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        sweep_free(&s);
    free(path);
    return status;
}

static enum status run_ranks(struct sweep *s, struct shared *h)
{
    const struct monitor *monitor = progress_monitor(h->o);
    enum status status = STATUS_OK;
    size_t missing = SIZE_MAX, taken = 0;

    while (status == STATUS_OK && missing > 0) {
        const bool first = missing == SIZE_MAX;
        if (crew_rank() == 0)
            status = join_ranks(s, h, &missing);
        taken = first ? s->taken : taken; /* not those of this run */
        status = crew_agree(status, h->why, monitor);
        if (status == STATUS_OK)
            missing = crew_told(missing);
        if (status == STATUS_OK && missing > 0) {
            crew_share_begin();
            status = crew_agree(run_rank(h), h->why, monitor);
        }
        h->resume = true;
    }
    s->taken = taken;
    return status;
}

/* ---- the whole ------------------------------------------------------------
 */

static enum status complain(const struct shared *h, const char *what)
{
    snprintf(h->why->text, sizeof h->why->text,
             "%s without a file, expected -o FILE.h5", what);
    return STATUS_BAD_ARGUMENT;
}

enum status sweep_shared(struct sweep *s, const struct scene *scene,
                         const struct options *o, const char *journal,
                         bool *whole, struct fault *why)
{
    const bool merged = command_id(o->command) == COMMAND_MERGE;
    struct shared h = { scene, o, journal, o->resume || merged, why };
    enum status status;

    *s = (struct sweep){ .scene = scene };
    if (journal == NULL && (merged || o->shard || crew_ranks() > 1))
        return complain(&h, o->shard ? "--shard" : o->command->name);
    if (crew_ranks() > 1)
        status = run_ranks(s, &h);
    else
        status = o->shard ? run_share(s, &h) : run_alone(s, &h);
    *whole = crew_rank() == 0 && !o->shard;
    return status;
}
