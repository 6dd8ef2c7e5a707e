/* Where the series of a tape stand, and the sums of all steps at once. */
#include "tape_course.h"

enum { ALL = JET_SLOTS * JET_SIZE };

/* ---- places -------------------------------------------------------------- */

int tape_kind_slots(enum step_kind kind)
{
    switch (kind) {
        case STEP_LINEAR:
        case STEP_SCALED:
            return 0;
        case STEP_GROWTH:
        case STEP_EXP:
        case STEP_LN1P:
        case STEP_PRODUCT:
        case STEP_QUOTIENT:
            return 1;
        case STEP_FRICTION:
            return 3;
        default:
            return 2;
    }
}

int tape_step_slots(const struct real_tape *t, const struct real_tape_entry *n)
{
    int slots = tape_kind_slots(n->kind);

    for (int j = 0; n->kind == STEP_SCALED && j < n->form.terms; j++) {
        const int reg = t->term[n->form.first + j].reg;
        if (real_tape_grows(t, reg))
            slots += tape_kind_slots(t->step[reg - 2].kind);
    }
    return slots;
}

int tape_rate_slots(const struct real_tape_rate *r)
{
    return is_fixed(r) ? 0 : r->mantissa.terms == 0 ? 1 : 2;
}

static int place_part(struct tape_plane *p, int part, int from, int to,
                      int *kept)
{
    const int first_rate = part ? 2 : 0, rates = part ? p->t.rates : 2;
    int used = 0;

    for (int i = from; i < to; i++) {
        p->slot[i] = (short) used;
        p->kept[i] = (short) *kept;
        const int slots =
            p->t.step[i].idle ? 0 : tape_step_slots(&p->t, &p->t.step[i]);
        used += slots;
        *kept += KEPT * slots + 1;
    }
    for (int i = first_rate; i < rates; i++) {
        p->rate_slot[i] = (short) used;
        p->rate_kept[i] = (short) *kept;
        used += tape_rate_slots(&p->t.rate[i]);
        *kept += KEPT;
    }
    return used;
}

bool tape_jet_slots(struct tape_plane *p)
{
    int used = 0, kept = 0, width[2];

    width[0] = place_part(p, 0, 0, p->t.rate_steps, &kept);
    width[1] = place_part(p, 1, p->t.rate_steps, p->t.steps, &kept);
    for (int i = 0; i < 2; i++) {
        p->odd[i] = width[i] % 2;
        p->width[i] = width[i] + p->odd[i];
        p->rows[i] = used;
        used += (2 * JET_SIZE + 1) * p->width[i];
    }
    p->registers = used;
    p->keep = used + p->t.steps + 2;
    return p->keep + kept <= ALL;
}

/* ---- sums ---------------------------------------------------------------- */

/* Four numbers where pairs stand. */
typedef double four __attribute__((vector_size(32), aligned(16), may_alias));

/* Of `fours` neighbours. */
#define SUMS(fours)                                                            \
    do {                                                                       \
        four s[fours];                                                         \
        for (int i = 0; i < (fours); i++)                                      \
            s[i] = (four){ 0 };                                                \
        for (size_t j = 1; j < k; j++)                                         \
            for (int i = 0; i < (fours); i++)                                  \
                s[i] += *(const four *) (a + j * width + 2 * i) *              \
                        *(const four *) (b + (k - j) * width + 2 * i);         \
        for (int i = 0; i < (fours); i++)                                      \
            *(four *) (sum + 2 * i) = s[i];                                    \
    } while (0)

static inline __attribute__((always_inline)) void sums(size_t k, size_t width,
                                                       const jet_pair *a,
                                                       const jet_pair *b,
                                                       jet_pair *sum)
{
    size_t left = width;

    for (; left >= 16; left -= 16, a += 16, b += 16, sum += 16)
        SUMS(8);
    switch (left / 2) {
        case 7:
            SUMS(7);
            break;
        case 6:
            SUMS(6);
            break;
        case 5:
            SUMS(5);
            break;
        case 4:
            SUMS(4);
            break;
        case 3:
            SUMS(3);
            break;
        case 2:
            SUMS(2);
            break;
        case 1:
            SUMS(1);
            break;
        default:
            break;
    }
}

void tape_sums_plain(size_t k, size_t width, const jet_pair *a,
                     const jet_pair *b, jet_pair *sum)
{
    sums(k, width, a, b, sum);
}

#ifdef __x86_64__
/* The same numbers: neighbours never meet, and nothing is fused. */
__attribute__((target("avx2"))) static void sums_avx2(size_t k, size_t width,
                                                      const jet_pair *a,
                                                      const jet_pair *b,
                                                      jet_pair *sum)
{
    sums(k, width, a, b, sum);
}

bool tape_sums_wide(size_t k, size_t width, const jet_pair *a,
                    const jet_pair *b, jet_pair *sum)
{
    if (!__builtin_cpu_supports("avx2"))
        return false;
    sums_avx2(k, width, a, b, sum);
    return true;
}
#else
bool tape_sums_wide(size_t k, size_t width, const jet_pair *a,
                    const jet_pair *b, jet_pair *sum)
{
    (void) k, (void) width, (void) a, (void) b, (void) sum;
    return false;
}
#endif

void tape_sums(const struct tape_plane *p, struct jet_work *w, size_t k,
               int part)
{
    const size_t width = (size_t) p->width[part];
    jet_pair *a = &w->slot[0][0] + p->rows[part], *b = a + JET_SIZE * width,
             *sum = b + JET_SIZE * width;

    if (!tape_sums_wide(k, width, a, b, sum))
        tape_sums_plain(k, width, a, b, sum);
}
