/* gnuplot's own key has a size of its own making; ours is known before
 * anything is drawn. */
#include "key.h"

#include <math.h>

#include "hatch.h"
#include "look.h"
#include "palette.h"

enum { SWATCH = 12 }; /* px, the height of a shade */

static void put_at(FILE *out, const struct layout *p, double x, double y)
{
    fprintf(out, "screen %.6f,%.6f", layout_across(p, x), layout_up(p, y));
}

static void put_box(FILE *out, const struct layout *p, struct box b,
                    const char *look)
{
    fputs("set object rectangle from ", out);
    put_at(out, p, b.lo.x, b.lo.y);
    fputs(" to ", out);
    put_at(out, p, b.hi.x, b.hi.y);
    fprintf(out, " front fs solid %s\n", look);
}

/* White, so that what lies under a legend in the plot is hidden. */
static void put_ground(FILE *out, const struct layout *p, struct vec2 size)
{
    const double rim = 3;

    put_box(out, p,
            (struct box){ { p->legend.x - rim, p->legend.y - size.y - rim },
                          { p->legend.x + size.x, p->legend.y + rim } },
            "border lc rgb '#c0c0c0' fc rgb 'white' lw 0.8");
}

static void put_shade(FILE *out, const struct layout *p, struct vec2 at,
                      enum figure_role role)
{
    const struct paint paint = paint_of((struct figure_style){ .role = role });
    char look[80];

    snprintf(look, sizeof look, "border lc rgb '#808080' fc rgb '%s' lw 0.8",
             paint.colour);
    const struct box b = { { at.x, at.y - SWATCH / 2.0 },
                           { at.x + LEGEND_SAMPLE, at.y + SWATCH / 2.0 } };
    put_box(out, p, b, look);
    if (role == FIGURE_ABSENT)
        hatch_write(out, p, b, "front");
}

static void put_curve(FILE *out, const struct layout *p, struct vec2 at,
                      const struct figure_layer *curve)
{
    const struct paint paint = paint_of(curve->style);

    fputs("set arrow from ", out);
    put_at(out, p, at.x, at.y);
    fputs(" to ", out);
    put_at(out, p, at.x + LEGEND_SAMPLE, at.y);
    fputs(" nohead front ", out);
    look_line(out, p->device, &paint);
    fputc('\n', out);
}

static void put_mark(FILE *out, const struct layout *p, struct vec2 at,
                     const struct figure_layer *mark)
{
    fputs("set label '' at ", out);
    put_at(out, p, at.x + LEGEND_SAMPLE / 2.0, at.y);
    fputs(" point ", out);
    look_mark(out, p->device, mark);
    fputs(" front\n", out);
}

static void put_text(FILE *out, const struct layout *p, struct vec2 at,
                     struct label_part part, double room)
{
    fputs("set label ", out);
    label_write(out, part, room, p->script);
    fputs(" at ", out);
    put_at(out, p, at.x, at.y);
    fprintf(out, " left front font ',%.4g'\n", LAYOUT_FONT * p->device->font);
}

static void put_line(FILE *out, const struct layout *p, const struct legend *l,
                     const struct legend_line *line)
{
    struct vec2 at = { p->legend.x + line->at.x,
                       p->legend.y - line->at.y - LEGEND_LINE / 2.0 };

    if (!line->curve && !line->mark)
        put_shade(out, p, at, line->role);
    if (line->curve)
        put_curve(out, p, at, line->curve);
    if (line->mark)
        put_mark(out, p, at, line->mark);
    at.x += LEGEND_SAMPLE + LEGEND_SKIP;
    for (size_t k = 0; k < line->parts; k++, at.y -= LEGEND_LINE)
        put_text(out, p, at, line->part[k], l->text_room / LAYOUT_FONT);
}

void key_write(FILE *out, const struct layout *p, const struct legend *l)
{
    char more[32];

    if (l->count > 0 && p->page->legend == FIGURE_LEGEND_INSIDE)
        put_ground(out, p, l->size);
    for (size_t k = 0; k < l->count; k++)
        put_line(out, p, l, &l->line[k]);
    if (l->left_out == 0)
        return;
    const int size = snprintf(more, sizeof more, "(and %zu more)", l->left_out);
    put_text(out, p,
             (struct vec2){ p->legend.x,
                            p->legend.y - l->size.y + LEGEND_LINE / 2.0 },
             (struct label_part){ more, (size_t) size }, INFINITY);
}
