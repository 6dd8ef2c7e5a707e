/* Formulas: read, lowered to a tape and written, or refused in one line.  The
 * two rates are parted by a #. */
#include <string.h>

#include "fuzz.h"
#include "lines.h"
#include "parse.h"

static struct formula f;
static struct tape t;
static struct text_lines lines;

static struct plane_formulas open_plane(void)
{
    struct plane_formulas p = { .values = 0 };

    formula_init(&f);
    formula_leaf(&f, "a", FORMULA_POSITIVE_PARAMETER);
    formula_leaf(&f, "b", FORMULA_PARAMETER);
    p.state[0] = formula_leaf(&f, "v", FORMULA_POSITIVE_STATE);
    p.state[1] = formula_leaf(&f, "y", FORMULA_STATE);
    p.chart[0] = formula_leaf(&f, "x0", FORMULA_PARAMETER);
    p.chart[1] = p.at[1] = formula_leaf(&f, "y0", FORMULA_PARAMETER);
    p.at[0] = formula_of(&f, FUNCTION_EXP, p.chart[0]);
    return p;
}

/* Lines come in order: each calls and names what is there. */
static void write_tape(void)
{
    const int offset[] = { formula_leaf(&f, "X", FORMULA_STATE),
                           formula_leaf(&f, "Y", FORMULA_STATE) };
    struct tape_text made;

    text_of_tape(&f, &t, offset, &made);
    const int result[] = { made.rate[0], made.rate[1], made.scale };
    for (int i = 0; i < 3; i++)
        formula_name(&f, result[i], (const char *[]){ "fx", "fy", "s" }[i]);
    if (!text_write(&f, result, 3, &lines))
        return;
    for (size_t i = 0; i < lines.lines; i++)
        MUST(lines.line[i].name[0] && lines.line[i].text[0]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = calloc(size + 1, 1);
    struct plane_formulas p = open_plane();
    struct fault why = { "" };
    enum status s;

    MUST(text != NULL);
    if (size)
        memcpy(text, data, size);
    char *second = strchr(text, '#');
    if (second)
        *second++ = '\0';
    s = formula_parse(&f, text, &p.rate[0], &why);
    if (s == STATUS_OK)
        s = formula_parse(&f, second ? second : text, &p.rate[1], &why);
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE);
    if (s == STATUS_OK && (s = tape_lower(&t, &f, &p, &why)) == STATUS_OK)
        write_tape();
    MUST(s == STATUS_OK || s == STATUS_BAD_SCENE || s == STATUS_BAD_ARGUMENT);
    if (s != STATUS_OK)
        must_be_a_line(&why);
    free(text);
    return 0;
}
