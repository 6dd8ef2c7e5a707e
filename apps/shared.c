#include "shared.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "command.h"
#include "crew.h"
#include "parts.h"
#include "progress.h"
#include "replace.h"

/* What all ways of running it have in common. */
struct shared {
    const struct shared_work *w;
    const struct options *o;
    const char *journal;
    bool resume;
    struct fault *why;
};

static enum status run(const struct shared *h, const struct sweep_options *how)
{
    const enum status status =
        h->w->run(h->w->work, how, progress_monitor(h->o), h->why);

    progress_end();
    return status;
}

/* Goes on with what shares have left, which is then in the own side file.
 * share: NULL: computes the rest. */
static enum status join(const struct shared *h, const struct parts *parts,
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
    const enum status status = run(h, &how);

    if (status == STATUS_OK)
        parts_forget(parts);
    return status;
}

/* ---- alone ----------------------------------------------------------------
 */

static enum status run_alone(const struct shared *h)
{
    struct parts parts = { .path = NULL };
    enum status status = STATUS_OK;

    if (h->resume)
        status = parts_find(h->journal, &parts);
    if (status == STATUS_OK && command_id(h->o->command) == COMMAND_MERGE)
        status = parts_check(&parts, h->journal, h->why);
    if (status == STATUS_OK)
        status = join(h, &parts, NULL);
    parts_free(&parts);
    return status;
}

/* ---- a share --------------------------------------------------------------
 */

/* Every `shares`-th task. */
static size_t next_of_share(void *ctx, size_t count)
{
    struct part *p = ctx;
    const size_t at = p->share < count ? p->share : count;

    p->share += p->shares;
    return at;
}

static enum status run_share(const struct shared *h)
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
    status = path ? run(h, &how) : STATUS_NO_MEMORY;
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

/* The first rank's turn: how much is missing.  Side files that are not to be
 * resumed go. */
static enum status join_ranks(const struct shared *h, size_t *missing,
                              size_t *taken)
{
    static const struct sweep_share nobody = { next_of_nobody, NULL };
    struct parts parts;
    enum status status = parts_find(h->journal, &parts);

    if (status == STATUS_OK && !h->resume) {
        parts_forget(&parts);
        parts_free(&parts);
    }
    if (status == STATUS_OK)
        status = join(h, &parts, &nobody);
    parts_free(&parts);
    *missing = status == STATUS_OK ? *h->w->missing : 0;
    *taken = status == STATUS_OK ? *h->w->taken : 0;
    if (*missing > 0)
        h->w->free(h->w->work);
    return status;
}

/* A rank's turn: some of what is missing, into its side file. */
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
    const enum status status = path ? run(h, &how) : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        h->w->free(h->w->work);
    free(path);
    return status;
}

/* What is told to have been there is what an earlier run had left. */
static enum status run_ranks(struct shared *h)
{
    const struct monitor *monitor = progress_monitor(h->o);
    enum status status = STATUS_OK;
    size_t missing = SIZE_MAX, taken = 0, now = 0;

    while (status == STATUS_OK && missing > 0) {
        const bool first = missing == SIZE_MAX;
        if (crew_rank() == 0)
            status = join_ranks(h, &missing, &now);
        taken = first ? now : taken;
        status = crew_agree(status, h->why, monitor);
        if (status == STATUS_OK)
            missing = crew_told(missing);
        if (status == STATUS_OK && missing > 0) {
            crew_share_begin();
            status = crew_agree(run_rank(h), h->why, monitor);
        }
        h->resume = true;
    }
    if (status == STATUS_OK)
        *h->w->taken = taken;
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

static enum status run_somehow(struct shared *h)
{
    enum status status = crew_rank() == 0 && h->journal
                             ? replace_folder(h->journal, h->why)
                             : STATUS_OK;

    status = crew_agree(status, h->why, NULL);
    if (status != STATUS_OK)
        return status;
    if (crew_ranks() > 1)
        return run_ranks(h);
    return h->o->shard ? run_share(h) : run_alone(h);
}

enum status shared_run(const struct shared_work *w, const struct options *o,
                       const char *journal, bool *whole, struct fault *why)
{
    const bool merged = command_id(o->command) == COMMAND_MERGE;
    struct shared h = { w, o, journal, o->resume || merged, why };

    if (journal == NULL && (merged || o->shard || crew_ranks() > 1))
        return complain(&h, o->shard ? "--shard" : o->command->name);
    const enum status status = run_somehow(&h);
    if (status == STATUS_STOPPED && journal)
        snprintf(why->text, sizeof why->text,
                 "interrupted; what is computed stays in %.300s for --resume",
                 journal);
    *whole = crew_rank() == 0 && !o->shard;
    return status;
}
