#include "scene_slope.h"

#include <string.h>

#include "scene_ensemble.h"

#define BIT(p) (1u << PRODUCT_##p)

const unsigned scene_slopeless = BIT(FOLDS) | BIT(FRICTION_LAW) |
                                 BIT(SPRING_BLOCK) | BIT(BIFURCATION) |
                                 BIT(FOLD_CURVES) | BIT(CHI);

static const char expected[] = "expected 'slope: {alpha: RAD}' or --alpha RAD";

/* The first of them that takes a slope; NULL if none does. */
static const char *first_of(unsigned products)
{
    for (int p = 0; p < PRODUCTS; p++)
        if (products & ~scene_slopeless & 1u << p)
            return product_names[p];
    return NULL;
}

/* Where the scene says so. */
static struct place place_of(const struct node *root, const char *product)
{
    const struct node *list = node_find(root, "products");
    size_t i = 0;

    while (i < list->count && strcmp(list->child[i]->text, product) != 0)
        i++;
    return i < list->count ? list->child[i]->at : list->at;
}

enum status scene_slope_check(const struct node *root, const struct scene *s,
                              struct fault *why)
{
    const struct node *slope = node_find(root, "slope");
    const char *product = first_of(s->products);

    if (scene_has_slope(s) || (s->products && product == NULL) ||
        scene_ensemble_has(s, "slope.alpha"))
        return STATUS_OK;
    if (product)
        return place_blame(place_of(root, product), why,
                           "products: no slope for %s, %s", product, expected);
    if (s->rabinowicz.slopes > 0)
        return STATUS_OK;
    return place_blame(slope ? slope->at : root->at, why, "no slope, %s",
                       expected);
}

enum status scene_slope_demand(const struct scene *s, unsigned products,
                               struct fault *why)
{
    const struct place at = { s->file, false, 0, 0 };
    const char *product = first_of(products);

    if (scene_has_slope(s) || product == NULL)
        return STATUS_OK;
    return place_blame(at, why, "no slope for %s, %s", product, expected);
}
