/* stops.h -- a monitor's ear that stops the work at its first word. */
#pragma once

#include <stdint.h>

static int stop_at_once(void *ctx, const char *stage, uint64_t done,
                        uint64_t total)
{
    (void) ctx, (void) stage, (void) done, (void) total;
    return 1;
}
