#include "litter.h"

#include <signal.h>
#include <stddef.h>
#include <unistd.h>

enum { ROOM = 16 };

static const char *volatile known[ROOM];
static volatile pid_t waited_for;

void litter_add(const char *path)
{
    for (int i = 0; i < ROOM; i++)
        if (known[i] == NULL) {
            known[i] = path;
            return;
        }
}

void litter_drop(const char *path)
{
    for (int i = 0; i < ROOM; i++)
        if (known[i] == path)
            known[i] = NULL;
}

void litter_child(pid_t child)
{
    waited_for = child;
}

void litter_sweep(void)
{
    if (waited_for > 0)
        (void) kill(waited_for, SIGKILL);
    for (int i = ROOM; i-- > 0;)
        if (known[i] && unlink(known[i]) != 0)
            (void) rmdir(known[i]);
}
