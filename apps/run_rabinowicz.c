/* slipway rabinowicz: critical release distances of a law, and what measured
 * ones say of it. */
#include "output.h"
#include "picture_rabinowicz.h"
#include "progress.h"

static enum status check(const struct options *o, const struct scene *c,
                         struct fault *why)
{
    if (c->figure && !c->rabinowicz.data) {
        snprintf(why->text, sizeof why->text,
                 "rabinowicz: %.300s: a figure shows data, expected --data",
                 c->figure);
        return STATUS_BAD_ARGUMENT;
    }
    return output_check(o, c, c->figure, picture_rabinowicz_panel, why);
}

static enum status draw(const struct options *o, const struct scene *c,
                        const struct release *r, struct fault *why)
{
    struct panels p = PANELS_EMPTY;
    const enum status s =
        c->figure ? picture_rabinowicz(r, c->title, &p, why) : STATUS_OK;

    return s ? s : output_draw(o, &c->paper, &p, c->figure, why);
}

static enum exit_code run(const struct options *o, const struct scene *c)
{
    struct release r = { .row = NULL };
    struct fault why = { "" };
    const struct results all = { .table = release_tables, .run = &r };

    enum status s = check(o, c, &why);
    if (s == STATUS_OK)
        s = release_run(&r, c, progress_monitor(o), &why);
    progress_end();
    if (s == STATUS_OK)
        s = output_write(o, "rabinowicz", &all, c, NULL,
                         "Rabinowicz's experiment", &why);
    if (s == STATUS_OK)
        s = draw(o, c, &r, &why);
    const enum exit_code code = s == STATUS_OK ? output_print(o, &all, NULL)
                                               : command_fail(s, why.text);
    release_free(&r);
    return code;
}

enum exit_code command_rabinowicz(const struct options *o)
{
    return command_with_scene(o, NULL, run);
}
