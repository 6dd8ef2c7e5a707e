#include "batch_points.h"

#include <stdlib.h>

#include "scene_shape.h"

#define BIT(p) (1u << PRODUCT_##p)

enum status batch_points_init(struct batch_points *p, const struct scene *scene)
{
    const unsigned none = BIT(EQUILIBRIA) | BIT(MANIFOLDS);

    *p = (struct batch_points){ .scene = *scene };
    if (scene->system)
        p->scene.products = scene->products ? scene->products : none;
    else
        p->scene.products &= ~scene_shape_curves;
    p->scene.ensemble.scattered = 0;
    p->scene.proved = false;
    p->scene.products = sweep_point_products(&p->scene, false);
    enum status status = sweep_dims_init(&p->dims, &p->scene);
    if (status == STATUS_OK)
        status = sweep_columns_init(&p->columns, &p->scene, &p->dims);
    if (status != STATUS_OK)
        batch_points_free(p);
    return status;
}

void batch_points_free(struct batch_points *p)
{
    sweep_columns_free(&p->columns);
    sweep_dims_free(&p->dims);
}

bool batch_points_has(const struct batch_points *p, size_t k)
{
    const struct sweep_column *c = &p->columns.at[k];

    return c->codes == NULL && c->entries == 1;
}

enum status batch_points_there(const struct batch_points *p, bool there[])
{
    struct sweep_point *point = malloc(sizeof *point);
    enum status status = point ? STATUS_OK : STATUS_NO_MEMORY;

    if (status == STATUS_OK)
        status = sweep_point_begin(point, &p->scene);
    if (status == STATUS_OK)
        status = sweep_point_run(point, p->scene.products, NULL);
    for (size_t k = 0; k < p->columns.count && status == STATUS_OK; k++) {
        const struct quantity q =
            batch_points_has(p, k)
                ? sweep_column_quantity(&p->columns.at[k], point, 0)
                : quantity_none("");
        there[k] = quantity_exists(&q);
    }
    if (status == STATUS_OK)
        sweep_point_free(point);
    free(point);
    return status;
}
