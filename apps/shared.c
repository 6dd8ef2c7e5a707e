#include "shared.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "crew.h"
#include "origin.h"
#include "output.h"
#include "parts.h"
#include "progress.h"
#include "provenance.h"
#include "replace.h"
#include "sweep.h"

/* ---- side file ----------------------------------------------------------- */

/* FILE.h5.part of the scene's file, owned by the caller; NULL without a file or
 * memory. */
static char *side_file_of(const struct scene *c)
{
    const size_t size = c->hdf5 ? strlen(c->hdf5) + sizeof ".part" : 0;
    char *path = size ? malloc(size) : NULL;

    if (path)
        snprintf(path, size, "%s.part", c->hdf5);
    return path;
}

static enum status is_of(const char *path, const char *command,
                         const char *expected, struct fault *why)
{
    if (strcmp(command, expected) == 0)
        return STATUS_OK;
    return fault_set(
        why, STATUS_BAD_SCENE,
        "%.300s: made by %.40s, expected a file of this %s (without "
        "--resume it is replaced)",
        path, command, expected);
}

static enum status is_sweep(const char *path, const char *command,
                            struct fault *why)
{
    return is_of(path, command, "sweep", why);
}

static enum status is_ensemble(const char *path, const char *command,
                               struct fault *why)
{
    return is_of(path, command, "ensemble", why);
}

/* A file that is there already is this run's own, which was finished. */
static enum status check_finished(const struct scene *c, const char *command,
                                  struct fault *why)
{
    struct origin was;
    const bool sweeps = strcmp(command, "sweep") == 0;
    enum status s =
        origin_read(c->hdf5, sweeps ? is_sweep : is_ensemble, &was, why);
    char *overrides = s == STATUS_OK ? provenance_overrides(c) : NULL;

    if (s == STATUS_OK && overrides == NULL)
        s = STATUS_NO_MEMORY;
    if (s == STATUS_OK && (strcmp(was.scene, c->text) != 0 ||
                           strcmp(was.overrides, overrides) != 0)) {
        snprintf(why->text, sizeof why->text,
                 "%.300s: of another scene, expected a file of this %s "
                 "(without --resume it is replaced)",
                 c->hdf5, command);
        s = STATUS_BAD_SCENE;
    }
    free(overrides);
    free(was.held);
    return s;
}

/* output_check, and with --resume what there is to go on with: the side file
 * says what it is of; where there is none, a file that was finished is of this
 * command and scene. */
static enum status side_file_check(const struct options *o,
                                   const struct scene *c, const char *command,
                                   const char *journal,
                                   const char *const panel[], struct fault *why)
{
    if (o->resume && c->hdf5 == NULL)
        return fault_set(why, STATUS_BAD_SCENE,
                         "%s: --resume without a file, expected -o FILE.h5",
                         command);
    const enum status s = output_check(o, c, c->figure, panel, why);
    return s == STATUS_OK && o->resume && access(journal, F_OK) != 0 &&
                   access(c->hdf5, F_OK) == 0
               ? check_finished(c, command, why)
               : s;
}

/* What all ways of running it have in common. */
struct shared {
    const struct shared_work *w;
    const struct options *o;
    const struct scene *scene;
    const char *journal;
    bool resume;
    struct fault *why;
};

static enum status run(const struct shared *h, const struct sweep_options *how)
{
    const enum status status =
        h->w->run(h->w->work, h->scene, how, progress_monitor(h->o), h->why);

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

/* ---- alone --------------------------------------------------------------- */

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

/* ---- a share ------------------------------------------------------------- */

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

/* ---- ranks --------------------------------------------------------------- */

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

/* ---- the whole ----------------------------------------------------------- */

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

/* *whole: all is there, and it is for this process to write it; else the work
 * has its share or, on another rank, nothing. */
static enum status run_whole(struct shared *h, bool *whole)
{
    const struct options *o = h->o;
    const bool merged = command_id(o->command) == COMMAND_MERGE;
    struct fault stopped = { "" };

    h->resume = o->resume || merged;
    if (h->journal == NULL && (merged || o->shard || crew_ranks() > 1))
        return complain(h, o->shard ? "--shard" : o->command->name);
    if (h->journal) {
        snprintf(stopped.text, sizeof stopped.text,
                 "interrupted; what is computed stays in %.300s for --resume",
                 h->journal);
        progress_leaves(stopped.text);
    }
    const enum status status = run_somehow(h);
    if (status == STATUS_STOPPED)
        *h->why = stopped;
    *whole = crew_rank() == 0 && !o->shard;
    return status;
}

/* ---- what it leaves ------------------------------------------------------ */

static enum status write_files(const struct shared *h)
{
    const struct scene *c = h->scene;
    struct panels p = PANELS_EMPTY;
    enum status status = STATUS_OK;

    if (c->hdf5)
        status = h->w->write(h->w->work, c->hdf5, h->why);
    if (status == STATUS_OK && c->hdf5) {
        progress_leaves(NULL);
        sweep_forget(h->journal);
        output_tell(h->o, c->hdf5);
    }
    if (status == STATUS_OK && c->figure)
        status = h->w->draw(h->w->work, &p, h->why);
    return status ? status
                  : output_draw(h->o, &c->paper, &p, c->figure, h->why);
}

static void print_notes(const struct shared *h)
{
    const struct shared_work *w = h->w;

    if (*w->replaced)
        printf("note: %s of an interrupted %s was replaced; --resume would "
               "have gone on\n",
               h->journal, w->name);
    if (*w->taken > 0)
        printf("note: %zu of %zu %s were there already\n", *w->taken, *w->count,
               w->tasks);
    if (w->note)
        w->note(w->work);
}

static enum exit_code tell(const struct shared *h, bool whole)
{
    const struct shared_work *w = h->w;
    const struct options *o = h->o;

    if (!whole && !o->quiet && o->shard)
        printf("share %s: %zu of %zu %s, beside %s; 'slipway merge' joins all "
               "shares\n",
               o->shard, *w->count - *w->missing, *w->count, w->tasks,
               h->journal);
    if (!whole)
        return EXIT_DONE;
    const enum status status = write_files(h);
    if (status != STATUS_OK)
        return command_fail(status, h->why->text);
    const enum exit_code code = w->print(w->work, o);
    if (!o->json && !o->quiet && !output_is_standard(o))
        print_notes(h);
    return code;
}

enum exit_code shared_command(const struct shared_work *w,
                              const struct options *o,
                              const struct scene *scene)
{
    struct fault why = { "" };
    char *journal = side_file_of(scene);
    struct shared h = { w, o, scene, journal, false, &why };
    bool whole = true;
    enum status s =
        scene->hdf5 && !journal
            ? STATUS_NO_MEMORY
            : side_file_check(o, scene, w->name, journal, w->panel, &why);

    s = crew_agree(s, &why, NULL);
    if (s == STATUS_OK)
        s = run_whole(&h, &whole);
    const enum exit_code code =
        s == STATUS_OK ? tell(&h, whole) : command_fail(s, why.text);
    w->free(w->work);
    free(journal);
    return code;
}
