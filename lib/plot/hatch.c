#include "hatch.h"

#include <math.h>

#include "look.h"
#include "palette.h"

static void put_line(FILE *out, const struct layout *p, struct vec2 a,
                     struct vec2 b, const char *layer)
{
    const struct paint paint =
        paint_of((struct figure_style){ .role = FIGURE_FIELD });

    fprintf(out,
            "set arrow from screen %.6f,%.6f to screen %.6f,%.6f nohead %s ",
            layout_across(p, a.x), layout_up(p, a.y), layout_across(p, b.x),
            layout_up(p, b.y), layer);
    look_line(out, p->device, &paint);
    fputc('\n', out);
}

/* Line c has x - y = c from the lower left corner. */
void hatch_write(FILE *out, const struct layout *p, struct box b,
                 const char *layer)
{
    const double apart = 9; /* px along an axis */
    const struct vec2 size = vec2_sub(b.hi, b.lo);

    for (double c = apart / 2 - size.y; c < size.x; c += apart) {
        const struct vec2 from = { c < 0 ? 0 : c, c < 0 ? -c : 0 };
        const double length =
            fmin(size.x - from.x, size.y - from.y); /* along an axis */
        const struct vec2 way = { length, length };
        const struct vec2 start = vec2_add(b.lo, from);
        put_line(out, p, start, vec2_add(start, way), layer);
    }
}
