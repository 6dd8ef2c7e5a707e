/* api.h -- what the files behind include/slipway share. */
#pragma once

#include <stddef.h>

#include "monitor.h"
#include "record.h"
#include "scene.h"
#include "slipway.h"
#include "status.h"
#include "sweep_column.h"

struct slipway_scene {
    char *path; /* owned; NULL: no file */
    char **set; /* owned: "key=value", in order */
    size_t sets, room;
};

/* That rows are lent as what the header calls them: a member lies where another
 * does. */
#define API_LENT(type, member, row, of_row)                                    \
    _Static_assert(offsetof(type, member) == offsetof(struct row, of_row) &&   \
                       sizeof(type) == sizeof(struct row),                     \
                   #type " is " #row)

/* As a caller of the library is told it. */
slipway_status api_status(enum status s);
slipway_number api_number(const struct quantity *q);

/* Whether a column is one number; a label; that of the k-th of those. */
bool api_is_number(const struct sweep_column *c);
slipway_label api_labelled(const char *name, const char *unit,
                           const char *text);
slipway_label api_label(const struct sweep_columns *c, size_t k);

/* *in as the rooms below take it; NULL stays NULL. */
const struct monitor *api_monitor(const slipway_monitor *in,
                                  struct monitor *out);

/* What the caller's scene says, checked; `why` may be NULL. */
slipway_status api_read(const slipway_scene *scene, struct scene *out,
                        slipway_fault *why);

/* A state of the scene. */
slipway_axis api_axis(const struct scene *scene, int axis);

/* What a scene of a law asks for, where it names nothing that of `knees`. */
unsigned api_products(const struct scene *scene);

/* What became of a call, with the fault's text or, without one, the status'. */
slipway_status api_answer(slipway_fault *why, enum status s,
                          const struct fault *fault);

/* The text of a fault that the caller may not want; returns `status`. */
slipway_status api_fault(slipway_fault *why, slipway_status status,
                         const char *text);
