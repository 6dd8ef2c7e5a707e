#include "legend.h"

#include <math.h>
#include <string.h>

#include "label.h"

static void legend_add(struct legend *l, struct legend_line line)
{
    if (!line.text)
        return;
    for (size_t k = 0; k < l->count; k++)
        if (strcmp(l->line[k].text, line.text) == 0)
            return;
    if (l->count == LEGEND_MAX) {
        l->left_out++;
        return;
    }
    l->width = fmax(l->width, label_width(line.text));
    l->line[l->count++] = line;
}

struct legend legend_of(const struct figure *f)
{
    struct legend l = { .count = 0 };
    for (size_t k = 0; k < f->layer_count; k++)
        if (f->layers[k].kind != FIGURE_REGION)
            legend_add(&l,
                       (struct legend_line){ f->layers[k].entry, &f->layers[k],
                                             f->layers[k].style.role });
    for (size_t k = 0; f->raster && k < f->raster->shade_count; k++)
        legend_add(&l, (struct legend_line){ f->raster->entry[k], NULL,
                                             f->raster->role[k] });
    for (size_t k = 0; k < f->layer_count; k++)
        if (f->layers[k].kind == FIGURE_REGION)
            legend_add(&l, (struct legend_line){ f->layers[k].entry, NULL,
                                                 f->layers[k].style.role });
    return l;
}
