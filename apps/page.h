/* page.h -- the gallery as one page of HTML, which needs nothing but the files
 * beside it. */
#ifndef APPS_PAGE_H
#define APPS_PAGE_H

#include <stddef.h>

#include "status.h"

enum { PAGE_PANELS = 8, PAGE_NAME = 256 };

/* One figure; texts borrowed.  Files lie beside the page. */
struct page_figure {
    char name[PAGE_NAME];
    char panel[PAGE_PANELS][PAGE_NAME]; /* without .svg, .png, .gp, .dat */
    size_t panels;
    const char *title, *comment; /* the scene's; the comment's lines joined */
    const char *command;         /* that makes the figure */
    const char *failure;         /* why there are no files; NULL: there are */
};

struct page {
    const struct page_figure *figure;
    size_t count;
    const char *version;
    int has_scripts; /* .gp and .dat beside each picture */
};

/* The page as text, owned by the caller; NULL where memory is short. */
char *page_text(const struct page *p);

#endif
