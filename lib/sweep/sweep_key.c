#include "sweep_key.h"

#include <stddef.h>
#include <string.h>

#include "schema.h"
#include "sweep_journal.h"

static const struct sweep_key table[] = {
    { "slope.alpha", "rad", "slope angle" },
    { "slope.alpha_deg", "degree", "slope angle" },
    { "slope.tan_alpha", "1", "tangent of the slope angle" },
    { "material.mu_star", "1", "friction coefficient at V_star" },
    { "material.a", "1", "direct effect a" },
    { "material.b", "1", "evolution effect b" },
    { "material.L", "m", "characteristic length L" },
    { "material.V_star", "m/s", "characteristic slip rate V_star" },
    { "material.c", "1", "parameter c of the law" },
    { "material.R", "1", "parameter R of the law" },
    { "material.V_c", "V_star", "cut-off slip rate" },
    { "gravity", "m/s^2", "gravity" },
    { "accuracy.rtol", "1", "relative tolerance of the computation" },
};

struct sweep_key sweep_key_of(const char *path)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].path, path) == 0)
            return table[i];
    if (strncmp(path, "system.", 7) == 0)
        return (struct sweep_key){ path, "1", "parameter" };
    const struct schema_key *k = schema_find(path);
    return (struct sweep_key){ path, k && k->unit ? k->unit : "1",
                               k ? k->text : path };
}

uint64_t sweep_key_sum(const struct scene *c, const char *version)
{
    uint64_t sum = sweep_journal_nil;

    for (const char *line = c->overrides; *line;) {
        const size_t size = strcspn(line, "\n") + 1;
        if (strncmp(line, "output.", 7) != 0 &&
            strncmp(line, "output=", 7) != 0)
            sum = sweep_journal_sum(sum, line, size);
        line += size;
    }
    sum = sweep_journal_sum(sum, c->text, strlen(c->text) + 1);
    sum = sweep_journal_sum(sum, &c->products, sizeof c->products);
    return version ? sweep_journal_sum(sum, version, strlen(version)) : sum;
}
