/* As many lanes as $LANES at most, said once. */
#include <stdio.h>
#include <stdlib.h>

#include "fast_layer.h"

int __real_layer_width(int most);
int __wrap_layer_width(int most);

int __wrap_layer_width(int most)
{
    static int said;
    const char *asked = getenv("LANES");
    const int width = __real_layer_width(asked ? atoi(asked) : most);

    if (!__atomic_exchange_n(&said, 1, __ATOMIC_RELAXED))
        fprintf(stderr, "%d lanes\n", width);
    return width;
}
