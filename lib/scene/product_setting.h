/* product_setting.h -- a scene's products as --set writes them. */
#pragma once

#include <stddef.h>

/* All products there are fit into so many bytes. */
enum { PRODUCT_SETTING = 512 };

/* Writes "products=[folds, knees]" of bits 1 << enum product, in the order of
 * that enum, into line. */
void product_setting(unsigned products, char line[PRODUCT_SETTING]);
