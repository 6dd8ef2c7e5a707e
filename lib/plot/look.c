#include "look.h"

void look_line(FILE *out, const struct device *d, const struct paint *p)
{
    const char *between = " dt (";

    fprintf(out, "lw %.4g lc rgb '%s'", p->width, p->colour);
    for (size_t k = 0; k < PAINT_DASHES && p->dash[k] > 0; k++) {
        fprintf(out, "%s%.4g", between, p->dash[k] * d->dash);
        between = ",";
    }
    if (p->dash[0] > 0)
        fputc(')', out);
}

int look_type(enum figure_mark mark)
{
    static const int type[] = {
        [FIGURE_DISC] = 7,     [FIGURE_CIRCLE] = 6,   [FIGURE_SQUARE] = 5,
        [FIGURE_PLUS] = 1,     [FIGURE_CROSS] = 2,    [FIGURE_BOX] = 4,
        [FIGURE_TRIANGLE] = 9, [FIGURE_DIAMOND] = 13, [FIGURE_STAR] = 3,
        [FIGURE_DELTA] = 8,    [FIGURE_LOZENGE] = 12,
    };

    return type[mark];
}

void look_mark(FILE *out, const struct device *d,
               const struct figure_layer *layer)
{
    const struct paint paint = paint_of(layer->style);

    fprintf(out, "pt %d ps %.4g lw %.4g lc rgb '%s'", look_type(layer->mark),
            layer->size * d->point, paint.width, paint.colour);
}
