/* typed.h -- a graph, and formulas typed into it that must be read. */
#pragma once

#include "check.h"
#include "parse.h"

static struct formula f;

/* The node of a text. */
static int parsed(const char *text)
{
    struct fault why = { "" };
    int node = -1;
    const enum status s = formula_parse(&f, text, &node, &why);

    CHECK(s == STATUS_OK, "%s: %s", text, why.text);
    return node;
}
