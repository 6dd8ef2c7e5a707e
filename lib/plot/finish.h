/* finish.h -- what gnuplot cannot say of its files: how large they are on
 * paper; and what it should not say: when it drew them. */
#pragma once

#include "script.h"

/* Width and height in mm, and the page of what is drawn; spaces beside italics
 * stay (SVG 1.1, 10.15: else viewers may drop them). */
MUST_CHECK enum status finish_svg(const char *path, double width,
                                  const struct script_size *size);

/* The page in points; creation dates become 1 January 1970. */
MUST_CHECK enum status finish_pdf(const char *path,
                                  const struct script_size *size);

/* The resolution in dots per inch: a pHYs chunk (PNG, 2nd edition, 11.3.5.3).
 */
MUST_CHECK enum status finish_png(const char *path, double dpi);
