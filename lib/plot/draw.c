#include "draw.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "finish.h"
#include "gnuplot.h"
#include "litter.h"
#include "script.h"
#include "status.h"

/* ---- workshop ------------------------------------------------------------ */

enum workshop_file {
    WORKSHOP_SCRIPT,
    WORKSHOP_DATA,
    WORKSHOP_FIGURE,
    WORKSHOP_FILES
};

struct workshop {
    char *folder;               /* owned: the temporary folder */
    char *name[WORKSHOP_FILES]; /* owned: names in it */
    char *made[WORKSHOP_FILES]; /* owned: paths in it */
    char *goal[WORKSHOP_FILES]; /* owned: where they belong */
};

#define WORKSHOP_EMPTY ((struct workshop){ .folder = NULL })

/* The first n bytes of a text and another, as a new string. */
static char *workshop_join(const char *a, size_t n, const char *b)
{
    const size_t m = strlen(b);
    char *s = malloc(n + m + 1);
    if (s) {
        memcpy(s, a, n);
        memcpy(s + n, b, m + 1);
    }
    return s;
}

static char *join_path(const char *folder, const char *name)
{
    const size_t n = strlen(folder);
    char *slashed = workshop_join(folder, n, "/");
    char *s = slashed ? workshop_join(slashed, n + 1, name) : NULL;
    free(slashed);
    return s;
}

/* Fills the names; false when memory is out. */
static bool name_files(struct workshop *w, const char *path, const char *base)
{
    const char *dot = strrchr(base, '.');
    const size_t stem = dot ? (size_t) (dot - base) : strlen(base);
    const size_t before = (size_t) (base - path);
    const char *const endings[] = { [WORKSHOP_SCRIPT] = ".gp",
                                    [WORKSHOP_DATA] = ".dat",
                                    [WORKSHOP_FIGURE] = dot ? dot : "" };
    for (int k = 0; k < WORKSHOP_FILES; k++) {
        w->name[k] = workshop_join(base, stem, endings[k]);
        w->goal[k] = workshop_join(path, before + stem, endings[k]);
        w->made[k] = w->name[k] ? join_path(w->folder, w->name[k]) : NULL;
        if (!w->name[k] || !w->goal[k] || !w->made[k])
            return false;
    }
    return true;
}

static enum status io_fault(struct fault *fault, const char *path)
{
    snprintf(fault->text, sizeof fault->text, "cannot write %.300s: %s", path,
             strerror(errno));
    return STATUS_IO;
}

static bool has_control(const char *name)
{
    for (; *name; name++)
        if ((unsigned char) *name < ' ' || *name == 0x7f)
            return true;
    return false;
}

/* Removes the folder with what is still in it; leaves WORKSHOP_EMPTY. */
static void workshop_close(struct workshop *w)
{
    for (int k = 0; k < WORKSHOP_FILES; k++) {
        if (w->made[k])
            unlink(w->made[k]);
        litter_drop(w->made[k]);
        free(w->name[k]);
        free(w->made[k]);
        free(w->goal[k]);
    }
    if (w->folder)
        rmdir(w->folder);
    litter_drop(w->folder);
    free(w->folder);
    *w = WORKSHOP_EMPTY;
}

/* For path = DIR/NAME.ext: makes the folder; the files are NAME.gp, NAME.dat,
 * NAME.ext.  STATUS_IO where it cannot be made, STATUS_BAD_ARGUMENT for a name
 * with control characters. */
static enum status workshop_open(const char *path, struct workshop *w,
                                 struct fault *fault)
{
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    *w = WORKSHOP_EMPTY;
    if (has_control(base)) {
        snprintf(fault->text, sizeof fault->text,
                 "the name of the figure holds a control character");
        return STATUS_BAD_ARGUMENT;
    }
    char *folder =
        workshop_join(path, (size_t) (base - path), ".figure-XXXXXX");
    if (!folder)
        return STATUS_NO_MEMORY;
    if (!mkdtemp(folder)) {
        free(folder);
        return io_fault(fault, path);
    }
    w->folder = folder;
    litter_add(folder);
    if (name_files(w, path, base)) {
        for (int k = 0; k < WORKSHOP_FILES; k++)
            litter_add(w->made[k]);
        return STATUS_OK;
    }
    workshop_close(w);
    return STATUS_NO_MEMORY;
}

/* Moves a file to its goal. */
static enum status workshop_deliver(const struct workshop *w,
                                    enum workshop_file which,
                                    struct fault *fault)
{
    if (rename(w->made[which], w->goal[which]) != 0)
        return io_fault(fault, w->goal[which]);
    return STATUS_OK;
}

static enum status check_axis(const struct figure_axis *a, const char *name,
                              struct fault *fault)
{
    if (isfinite(a->lo) && isfinite(a->hi) && a->lo < a->hi &&
        (!a->is_log || a->lo > 0))
        return STATUS_OK;
    snprintf(fault->text, sizeof fault->text,
             "the %s axis of the figure cannot run from %.17g to %.17g%s", name,
             a->lo, a->hi, a->is_log ? " on a log scale" : "");
    return STATUS_BAD_ARGUMENT;
}

static enum status refuse_page(const struct figure_page *p, struct fault *fault)
{
    char height[48] = "";

    if (p->height > 0)
        snprintf(height, sizeof height, " x %g", p->height);
    snprintf(fault->text, sizeof fault->text,
             "a figure of %g%s mm has no room for a plot with letters of %g pt",
             p->width, height, p->type);
    return STATUS_BAD_ARGUMENT;
}

/* Type of 0.1 pt on 10 m would be drawn, but no PNG of it. */
static enum status check_page(const struct figure_page *p, struct fault *fault)
{
    const double dots = fmax(p->width, p->height) / 25.4 * fmax(p->dpi, 72);

    return p->width > 0 && p->height >= 0 && p->type > 0 && dots <= 30000
               ? STATUS_OK
               : refuse_page(p, fault);
}

static enum status check_figure(const struct figure *f, struct fault *fault)
{
    enum status s = check_page(&f->page, fault);
    if (s == STATUS_OK)
        s = check_axis(&f->x, "x", fault);
    if (s == STATUS_OK)
        s = check_axis(&f->y, "y", fault);
    return s;
}

static enum status refuse_ending(const char *path, struct fault *fault)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    snprintf(fault->text, sizeof fault->text,
             "%.300s: unknown figure format '%.80s', expected .svg, .pdf or "
             ".png",
             path, dot ? dot : "");
    return STATUS_BAD_ARGUMENT;
}

/* Closes a file that may be NULL; false if it is, or anything went wrong. */
static bool close_file(FILE *file)
{
    if (!file)
        return false;
    const bool failed = ferror(file) != 0;
    return fclose(file) == 0 && !failed;
}

static enum status write_script(const struct figure *f, const struct device *d,
                                const struct workshop *w,
                                struct script_size *size, struct fault *fault)
{
    const struct script_names names = { w->name[WORKSHOP_FIGURE],
                                        w->name[WORKSHOP_DATA] };
    FILE *script = fopen(w->made[WORKSHOP_SCRIPT], "w");
    FILE *data = fopen(w->made[WORKSHOP_DATA], "w");
    enum status s = STATUS_OK;
    if (script && data)
        s = script_write(f, d, &names, script, data, size);
    const bool script_ok = close_file(script);
    const bool data_ok = close_file(data);
    if (s == STATUS_BAD_ARGUMENT)
        return refuse_page(&f->page, fault);
    if (s != STATUS_OK || (script_ok && data_ok))
        return s;
    return io_fault(fault, w->goal[WORKSHOP_DATA]);
}

/* gnuplot does not notice that a disk is full. */
static enum status check_whole(const struct device *d, const struct workshop *w,
                               struct fault *fault)
{
    char end[16] = "";
    FILE *file = fopen(w->made[WORKSHOP_FIGURE], "rb");
    size_t n = 0;
    if (file && fseek(file, -(long) sizeof end, SEEK_END) != 0)
        rewind(file);
    if (file)
        n = fread(end, 1, sizeof end, file);
    if (file)
        fclose(file);
    if (memmem(end, n, d->last, strlen(d->last)))
        return STATUS_OK;
    snprintf(fault->text, sizeof fault->text,
             "gnuplot ended without an error but %s %.300s%s",
             n == 0 ? "drew nothing into" : "did not draw all of",
             w->goal[WORKSHOP_FIGURE], n == 0 ? "" : ": is the disk full?");
    return STATUS_NO_GNUPLOT;
}

/* What gnuplot cannot say: how large the page is, and not when it was made. */
static enum status draw_finish(const struct figure *f, const struct device *d,
                               const struct script_size *size, const char *path)
{
    switch (d->kind) {
        case DEVICE_SVG:
            return finish_svg(path, f->page.width, size);
        case DEVICE_PDF:
            return finish_pdf(path, size);
        default:
            return finish_png(path, f->page.dpi);
    }
}

static enum status draw_make(const struct figure *f, const struct device *d,
                             const struct workshop *w, struct fault *fault)
{
    struct script_size size;
    enum status s = write_script(f, d, w, &size, fault);

    if (s == STATUS_OK)
        s = gnuplot_run(w->folder, w->name[WORKSHOP_SCRIPT], fault);
    if (s == STATUS_OK)
        s = check_whole(d, w, fault);
    if (s == STATUS_OK)
        s = draw_finish(f, d, &size, w->made[WORKSHOP_FIGURE]);
    return s == STATUS_IO ? io_fault(fault, w->goal[WORKSHOP_FIGURE]) : s;
}

static enum status draw_deliver(const struct workshop *w, bool keep_script,
                                struct fault *fault)
{
    enum status s = workshop_deliver(w, WORKSHOP_FIGURE, fault);
    if (s == STATUS_OK && keep_script)
        s = workshop_deliver(w, WORKSHOP_DATA, fault);
    if (s == STATUS_OK && keep_script)
        s = workshop_deliver(w, WORKSHOP_SCRIPT, fault);
    return s;
}

/* In a workshop of its own, WORKSHOP_EMPTY where it could not be opened. */
static enum status make_at(const struct figure *f, const char *path,
                           struct workshop *w, struct fault *fault)
{
    const struct device *device = device_find(path);
    enum status s = f->status;

    if (s != STATUS_OK) {
        snprintf(fault->text, sizeof fault->text, "%.300s: %s", path,
                 status_text(s));
        return s;
    }
    if (!device)
        return refuse_ending(path, fault);
    s = check_figure(f, fault);
    if (s == STATUS_OK)
        s = workshop_open(path, w, fault);
    return s == STATUS_OK ? draw_make(f, device, w, fault) : s;
}

enum status figures_write(const struct figure f[], const char *const path[],
                          size_t count, bool keep_script, struct fault *fault)
{
    struct workshop w[FIGURES_MAX];
    enum status s = STATUS_OK;

    assert(count <= FIGURES_MAX);
    for (size_t i = 0; i < count; i++)
        w[i] = WORKSHOP_EMPTY;
    for (size_t i = 0; i < count && s == STATUS_OK; i++)
        s = make_at(&f[i], path[i], &w[i], fault);
    for (size_t i = 0; i < count && s == STATUS_OK; i++)
        s = draw_deliver(&w[i], keep_script, fault);
    for (size_t i = 0; i < count; i++)
        workshop_close(&w[i]);
    return s;
}
