#include "product_setting.h"

#include <stdio.h>

#include "scene.h"

void product_setting(unsigned products, char line[PRODUCT_SETTING])
{
    const char *before = "";
    int used = snprintf(line, PRODUCT_SETTING, "products=[");

    for (int p = 0; p < PRODUCTS; p++)
        if (products & 1u << p) {
            used += snprintf(line + used, PRODUCT_SETTING - (size_t) used,
                             "%s%s", before, product_names[p]);
            before = ", ";
        }
    snprintf(line + used, PRODUCT_SETTING - (size_t) used, "]");
}
