/* monitor.h -- how long work tells of its progress and learns to stop. */
#pragma once

#include <stdint.h>

/* Called now and then by anything that may take longer than a blink.  `done`
 * never decreases; `total` is 0 where it is not known beforehand.  A non-zero
 * answer asks for an early end: the caller returns STATUS_STOPPED. */
struct monitor {
    int (*tell)(void *ctx, const char *stage, uint64_t done, uint64_t total);
    void *ctx; /* borrowed */
};

/* Zero when there is no monitor or it wants to go on. */
static inline int monitor_tell(const struct monitor *m, const char *stage,
                               uint64_t done, uint64_t total)
{
    return m && m->tell ? m->tell(m->ctx, stage, done, total) : 0;
}
