/* One process, and nobody beside it. */
#include "crew.h"

void crew_begin(int *argc, char ***argv)
{
    (void) argc, (void) argv;
}

int crew_end(int code)
{
    return code;
}

size_t crew_rank(void)
{
    return 0;
}

size_t crew_ranks(void)
{
    return 1;
}

enum status crew_agree(enum status status, struct fault *why,
                       const struct monitor *monitor)
{
    (void) why, (void) monitor;
    return status;
}

size_t crew_told(size_t number)
{
    return number;
}

void crew_share_begin(void)
{
}

size_t crew_share_next(void *ctx, size_t count)
{
    (void) ctx;
    return count;
}
