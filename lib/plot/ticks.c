#include "ticks.h"

#include <math.h>
#include <string.h>

#include "label.h"
#include "mark.h"

enum { LABELS_MAX = 8 };

/* Decades between labels, and between the small ticks (0: at 2 ... 9). */
static const int decade_steps[][2] = {
    { 1, 0 },   { 2, 1 },   { 3, 1 },   { 5, 1 },    { 10, 5 },
    { 20, 10 }, { 30, 10 }, { 50, 10 }, { 100, 50 }, { 200, 100 },
};

/* px: multiples of a step may be beyond an end that they are. */
static const double rounding = 1e-6;

/* Receives one tick; text "" for a small one. */
struct tick_sink {
    FILE *out; /* NULL: only measure */
    double script;
    double (*place)(double); /* NULL: as it is */
    size_t count, labels;
    double gap, free; /* px: labels are so far apart; the next is from there */
    double width;
    struct tick_label *kept; /* TICKS_LABELS of them; NULL: nobody asks */
    size_t kept_count;
};

/* A label, whose marks (mark.h) need no escape here. */
void ticks_put(FILE *out, const char *text, double script)
{
    for (; *text; text++)
        if (*text == MARK_SUPER && script > 1)
            fprintf(out, "^{/*%.3g ", script);
        else if (*text == MARK_SUPER)
            fputs("^{", out);
        else
            fputc(*text == MARK_END ? '}' : *text, out);
}

/* Whether there is room for a label there, which is taken. */
static bool has_room(struct tick_sink *k, double pixel)
{
    if (k->labels > 0 && pixel < k->free)
        return false;
    k->labels++;
    k->free = pixel + k->gap;
    return true;
}

static void ticks_tick(struct tick_sink *k, const struct scale *s, double at,
                       const char *text)
{
    const double pixel = scale_pixel(s, at);

    if (!(pixel >= -rounding && pixel <= s->pixels + rounding))
        return;
    at = fmin(fmax(at, s->lo), s->hi);
    if (text[0] != '\0' && !has_room(k, pixel))
        text = "";
    if (k->out) {
        fputs(k->count ? ", '" : "'", k->out);
        ticks_put(k->out, text, k->script);
        fprintf(k->out, "' %.15g %d", k->place ? k->place(at) : at,
                text[0] == '\0');
    }
    if (k->kept && text[0] != '\0' && at > s->lo && at < s->hi &&
        k->kept_count < TICKS_LABELS) {
        struct tick_label *label = &k->kept[k->kept_count++];
        label->at = at;
        snprintf(label->text, sizeof label->text, "%s", text);
    }
    k->count++;
    k->width = fmax(k->width, label_width(text));
}

/* "10^-6" with a true minus sign, "2x10^..." where the factor is not 1. */
static void power_text(char text[64], double factor, int exponent)
{
    char front[32] = "";
    if (factor != 1)
        snprintf(front, sizeof front, "%.6g\xc3\x97", factor);
    snprintf(text, 64, "%s10" SUPER("%s%d"), front,
             exponent < 0 ? "\xe2\x88\x92" : "",
             exponent < 0 ? -exponent : exponent);
}

static void number_text(char text[64], double value, double step, double top)
{
    if (value == 0) {
        snprintf(text, 64, "0");
    } else if (top >= 1e-3 && top < 1e5) {
        const int places = (int) fmax(0, -floor(log10(step) + 1e-9));
        snprintf(text, 64, "%s%.*f", value < 0 ? "\xe2\x88\x92" : "", places,
                 fabs(value));
    } else {
        const int n = (int) floor(log10(top) + 1e-9);
        char tail[64];
        power_text(tail, fabs(value) * pow(10, -n), n);
        snprintf(text, 64, "%s%.60s", value < 0 ? "\xe2\x88\x92" : "", tail);
    }
}

static int labels_fit(const struct scale *s, double spacing)
{
    return (int) fmin(LABELS_MAX, fmax(2, s->pixels / spacing + 1));
}

static void linear_ticks(struct tick_sink *k, const struct scale *s, int labels)
{
    const double least = s->hi / (labels - 1) - s->lo / (labels - 1);
    const double power = pow(10, floor(log10(least)));
    const double m = least / power;
    const double factor = m <= 1 ? 1 : m <= 2 ? 2 : m <= 5 ? 5 : 10;
    const double step = factor * power;
    const int parts = factor == 2 ? 4 : 5;
    const double top = fmax(fabs(s->lo), fabs(s->hi));
    const double first = ceil(s->lo / step - 1e-9) - 1;
    for (int i = 0; i <= labels + 2; i++) {
        char text[64];
        const double at = (first + i) * step;
        number_text(text, at, step, top);
        ticks_tick(k, s, at, text);
        for (int j = 1; j < parts; j++)
            ticks_tick(k, s, at + step * j / parts, "");
    }
}

/* Labels at every `step` decades; small ticks in between. */
static void decade_ticks(struct tick_sink *k, const struct scale *s, int step,
                         int small)
{
    const int first = (int) floor(s->a), last = (int) ceil(s->b);
    for (int n = first; n <= last; n++) {
        char text[64] = "";
        if (n % step == 0)
            power_text(text, 1, n);
        if (n % step == 0 || (small > 0 && n % small == 0))
            ticks_tick(k, s, pow(10, n), text);
        for (int m = 2; small == 0 && m < 10; m++)
            ticks_tick(k, s, m * pow(10, n), "");
    }
}

/* Less than two decades: 1, 2, 5 times powers of ten; 1, 3 if short of room. */
static void mantissa_ticks(struct tick_sink *k, const struct scale *s,
                           int labels)
{
    const char *labelled = 3 * (s->b - s->a) + 1 <= labels ? "125" : "13";
    const int first = (int) floor(s->a), last = (int) ceil(s->b);
    for (int n = first; n <= last; n++) {
        for (int m = 1; m < 10; m++) {
            char text[64] = "";
            const double at = m * pow(10, n);
            if (strchr(labelled, '0' + m))
                number_text(text, at, pow(10, n), at);
            ticks_tick(k, s, at, text);
        }
    }
}

/* ---- how densely --------------------------------------------------------- */

/* From coarse to fine: decades, parts of them, a linear scale. */
enum { DECADES = sizeof decade_steps / sizeof decade_steps[0] };
enum { MANTISSA = DECADES, LINEAR, FINEST = LINEAR + 3 * LABELS_MAX };

static void ticks_at(struct tick_sink *k, const struct scale *s, int labels,
                     int density)
{
    const int *step = decade_steps[DECADES - 1 - density % DECADES];

    if (density >= LINEAR)
        linear_ticks(k, s, labels + density - LINEAR);
    else if (density == MANTISSA)
        mantissa_ticks(k, s, labels);
    else
        decade_ticks(k, s, step[0], step[1]);
}

/* As dense as there is room for. */
static int first_density(const struct scale *s, int labels)
{
    const double decades = s->b - s->a;
    int i = 0;

    if (!s->is_log || decades < 0.7)
        return LINEAR;
    if (decades < 2)
        return MANTISSA;
    while (i + 1 < DECADES && decades / decade_steps[i][0] + 1 > labels)
        i++;
    return DECADES - 1 - i;
}

/* Closer, then denser, where less than three labels would be left. */
static void all_ticks(struct tick_sink *k, const struct scale *s,
                      double spacing)
{
    static const double close[] = { 0.9, 0.72, 0.58, 0.46 };
    enum { WAYS = sizeof close / sizeof *close };
    const int labels = labels_fit(s, spacing);
    int way = WAYS * first_density(s, labels);

    for (; way < WAYS * FINEST; way++) {
        struct tick_sink trial = { .gap = close[way % WAYS] * spacing };
        ticks_at(&trial, s, labels, way / WAYS);
        if (trial.labels >= 3)
            break;
    }
    k->gap = close[way % WAYS] * spacing;
    ticks_at(k, s, labels, way / WAYS);
}

void ticks_write(FILE *out, const struct scale *s, double spacing,
                 double script, double place(double))
{
    struct tick_sink k = { .out = out, .script = script, .place = place };

    fputc('(', out);
    all_ticks(&k, s, spacing);
    fputc(')', out);
}

size_t ticks_labels(const struct scale *s, double spacing,
                    struct tick_label label[TICKS_LABELS])
{
    struct tick_sink k = { .out = NULL, .kept = label };

    all_ticks(&k, s, spacing);
    return k.kept_count;
}

double ticks_width(const struct scale *s, double spacing)
{
    struct tick_sink k = { .out = NULL };

    all_ticks(&k, s, spacing);
    return k.width;
}
