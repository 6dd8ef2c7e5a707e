/*
 * result.h -- what was computed, described once: a line for each thing, in a
 * table beside the computation.  Files, JSON, text, sweeps, checks and the
 * reference pages walk the tables and know no result by name.
 *
 * A new number is a record (record.h), a line in a table, and the table's name
 * in the list of whoever runs it (study_results.c).
 *
 * Names may hold a number or words, which instance k = 0, 1, ... of the result
 * fills in: "/nullcline/v_K" is /nullcline/v_0, /nullcline/v_1, ...;
 * "/critical/knees_{upper,lower}" has two instances.
 */
#pragma once

#include <stdbool.h>

#include "monitor.h"
#include "record.h"
#include "status.h"
#include "unit.h"

/* How the records of a result lie. */
enum result_shape {
    RESULT_SCALARS,    /* one record */
    RESULT_COLUMNS,    /* many, along one of their members, or n = 0, 1, ... */
    RESULT_LAYERS,     /* many, row by row over two axes of the group */
    RESULT_ATTRIBUTES, /* one that tells something of the group: members that
                          have no value are left out */
};

/* Records on loan from a run. */
struct result_view {
    struct record_array records;
    bool here;   /* false: there are none, and no place for them either */
    void *owned; /* what was made for this view; else NULL */
};

struct result {
    const char *path; /* group of a file; NULL: in no file */
    const char *name; /* place in JSON, with dots; "": at the top; NULL: none */
    const char *text; /* what it is and when it is there; NULL: as before */
    enum result_shape shape;
    const char *axis;   /* member along which columns lie, NULL: n; of layers
                           "psi, v" */
    const char *member; /* what a member is called in a file, * being its name;
                           NULL: by its name */
    const struct record_type *type;
    const char *title; /* heading for people; "": below the one before, by full
                          names; NULL: not in text */
    const char *note;  /* what people should know of it; lines, or NULL */
    uint64_t needs;    /* asked for by any of these bits; 0: always */
    size_t alone;      /* of columns: as many rows may stand alone, by name */
    const char *fewer; /* why one of these is not there */

    /* How many instances, where that is not said by `path`; may be NULL. */
    size_t (*count)(const void *run);
    /* Lends instance k.  *out is clear before; STATUS_NO_MEMORY leaves it so.
     * May be called in parallel.  NULL: whoever makes the file writes it. */
    enum status (*view)(const void *run, size_t k, struct result_view *out);
    /* Instead of a view: computes the one record there is, which the run then
     * keeps (result_keep).  STATUS_NO_MEMORY. */
    enum status (*make)(const void *run, void *record);
    /* Of layers: the records of rows first .. first + count - 1.  Results of
     * one group with the same function share its records. */
    enum status (*rows)(const void *run, size_t first, size_t count,
                        const struct monitor *monitor, void *records);
};

/* Records that were made, kept with the run. */
struct result_keep {
    struct result_kept {
        const struct result *of;
        void *record; /* owned */
    } * at;           /* owned */
    size_t count;
};

/* The results of a run: tables that end with a line without a type, in a list
 * that ends with NULL. */
struct results {
    const struct result *const *table;
    const void *run;                /* borrowed; what views are given */
    const struct result_keep *kept; /* borrowed; NULL: none */
    uint64_t asked;           /* bits that the run and its tables agree upon */
    struct unit_system units; /* that views are in; clear: as they are */
};

/* Lends records from *out on; they are owned by the run. */
static inline enum status result_lend(struct result_view *out, const void *at,
                                      size_t count)
{
    out->here = true;
    out->records.at = at;
    out->records.count = count;
    return STATUS_OK;
}

/* A view of a struct *s, the run, where it is here: what lends from it, which
 * may depend on k. */
#define RESULT_VIEW_IF(function, struct_, here_, lends)                        \
    static enum status function(const void *run, size_t k,                     \
                                struct result_view *out)                       \
    {                                                                          \
        const struct struct_ *s = run;                                         \
        (void) k;                                                              \
        return (here_) ? lends : STATUS_OK;                                    \
    }

/* How many there are in a struct *s, the run. */
#define RESULT_COUNT(function, struct_, count_)                                \
    static size_t function(const void *run)                                    \
    {                                                                          \
        const struct struct_ *s = run;                                         \
        return count_;                                                         \
    }

/* Whether the run was asked for it. */
static inline bool result_asked(const struct result *r,
                                const struct results *all)
{
    return r->needs == 0 || (r->needs & all->asked);
}

/* How many instances there are. */
size_t result_count(const struct result *r, const void *run);

/* Instance k, if there are so many; result_close either way.  STATUS_NO_MEMORY.
 */
MUST_CHECK enum status result_open(const struct results *all,
                                   const struct result *r, size_t k,
                                   struct result_view *out);
void result_close(struct result_view *v);

/* Makes what was asked for and needs nothing but `bits`, and is not kept yet.
 * STATUS_NO_MEMORY, or that of the maker. */
MUST_CHECK enum status result_keep(struct result_keep *kept,
                                   const struct results *all, uint64_t bits);

/* A second call is harmless. */
void result_keep_free(struct result_keep *kept);

enum { RESULT_NAME = 160 };

/* A path, name or member of instance k; `field`: what stands for *. */
void result_name(const char *pattern, size_t k, const char *field,
                 char name[RESULT_NAME]);

/* The path of instance k of n: numbers of one length, so that names sort as
 * numbers do, "/trajectory_01" of 11. */
void result_path(const struct result *r, size_t k, size_t n,
                 char name[RESULT_NAME]);

/* "estimates.chi[0]" as "estimates_chi_0_", "" as it is: what precedes the
 * members' names where they stand alone. */
void result_prefix(const struct result *r, size_t k, char prefix[RESULT_NAME]);

/* What a member of the result is called in its group. */
void result_member(const struct result *r, size_t k,
                   const struct record_field *f, char name[RESULT_NAME]);

/* Always: `count` records from `first` on. */
#define RESULT_VIEW(function, struct_, first, count)                           \
    RESULT_VIEW_IF(function, struct_, true, result_lend(out, first, count))
