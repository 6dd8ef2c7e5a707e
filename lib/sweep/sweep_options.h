/*
 * sweep_options.h -- how a sweep, or an ensemble, is run: by one process, or
 * shared by several that know each other's side files.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Which tasks a process computes: points of a sweep, blocks of draws. */
struct sweep_share {
    /* Another of `count` tasks, from 0, which no other process gets; count or
     * more: there is none.  One thread at a time asks. */
    size_t (*next)(void *ctx, size_t count);
    void *ctx; /* borrowed, passed back */
};

/* Of zeros: one process, without a side file. */
struct sweep_options {
    const char *journal; /* side file kept while running; NULL: none */
    bool resume;         /* take what is in a left one */
    const char *version; /* of the program, part of the key of that file; may
                            be NULL */
    const struct sweep_share *share; /* NULL: all tasks */
    const char *const *other;        /* side files that are read, too */
    size_t others;
    bool join; /* and what is in them is copied to the own one */
};
