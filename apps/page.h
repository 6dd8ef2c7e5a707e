/* page.h -- the gallery as one page of HTML, which needs nothing but the files
 * beside it. */
#pragma once

#include "gallery_entry.h"

/* The page as text, owned by the caller; NULL where memory is short.  scripts:
 * .gp and .dat lie beside each picture. */
char *page_text(const struct gallery_entry entry[], size_t count, bool scripts);
