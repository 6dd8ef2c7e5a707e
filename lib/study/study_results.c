#include "study_results.h"

_Static_assert((int) STAGES + (int) PRODUCTS <= 64, "a bit for each");

/* Their order is that of the groups of a file. */
#define TABLES(T)                                                              \
    T(steady)                                                                  \
    T(manifold)                                                                \
    T(critical)                                                                \
    T(taylor)                                                                  \
    T(estimate)                                                                \
    T(sensitivity)                                                             \
    T(portrait)                                                                \
    T(basin)                                                                   \
    T(diagram)

#define DECLARE(name) extern const struct result name##_results[];
#define LIST(name)    name##_results,

TABLES(DECLARE)

const struct result *const study_tables[] = { TABLES(LIST) NULL };

struct results study_results(const struct study *s)
{
    return (struct results){
        .table = study_tables,
        .run = s,
        .kept = &s->kept,
        .asked = s->stages | (uint64_t) s->scene->products << STAGES,
    };
}

enum status study_numbers(struct result_numbers *n, uint64_t bits)
{
    const struct results all = { .table = study_tables, .asked = bits };

    return result_numbers_init(n, &all);
}

enum status study_keep(struct study *s, uint64_t bits)
{
    const struct results all = study_results(s);

    return result_keep(&s->kept, &all, bits);
}
