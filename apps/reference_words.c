#include "reference.h"

#include "catalogue.h"
#include "equilibrium.h"
#include "extremum.h"
#include "fate.h"
#include "moment.h"
#include "records.h"
#include "stress_judge.h"
#include "texts.h"
#include "transient.h"
#include "workprec_rank.h"
#include "workprec_task.h"

enum { MEANINGS = 16 };

/* A list of words and what each means. */
static const struct word_list {
    const char *name, *where;
    const char *const *words; /* NULL-ended, as are the meanings */
    const char *meaning[MEANINGS];
} lists[] = {
    { "type",
      "of a steady state",
      equilibrium_type_names,
      { "eigenvalues of both signs: its stable manifold is the separatrix",
        "both eigenvalues negative: nearby states end here",
        "one eigenvalue is zero: exactly at a fold of the slope",
        "both eigenvalues positive", "complex eigenvalues" } },
    { "upper_end, lower_end",
      "how a branch of the saddle's stable manifold ends, followed backward "
      "in time",
      end_names,
      { "psi grows without bound and v tends to v_plus",
        "psi grows without bound and so does v: no v_plus",
        "psi tends to 0 (-infinity where it is a logarithm), v to v_minus",
        "v = 0 is met at a finite psi, psi_at_v0: no v_minus",
        "the curve leaves the numbers that doubles hold before it ends" } },
    { "fate",
      "of a state: label, exit_reason and push",
      fate_names,
      { "tends to the creep node, the slower of the stable ones",
        "tends to the sliding node, the faster one",
        "v = 0 after a finite time", "v tends to 0, but never gets there",
        "v grows without bound",
        "too near the boundary to tell, or not to be followed" } },
    { "transient_end",
      "why a run of simulate ends",
      transient_end_names,
      { "v = 0", "next to a stable node, see cell_arrest",
        "trajectories.until.time", "trajectories.until.slip",
        "far faster than start and saddle, and ever faster",
        "far slower than both, and no rest to come",
        "could not be followed further",
        "next to the separatrix, nearer than numbers can be had" } },
    { "proved",
      "of a cell of `/basin`",
      label_proof_names,
      { "it has the label, which is a theorem",
        "its row meets the stable manifold there, as far as that is proved, or "
        "its label is undecided",
        "its row meets the manifold beyond what is proved of it" } },
    { "what",
      "of an event of simulate",
      moment_names,
      { "v passes that of the saddle", "v passes v_minus", "v passes v_plus",
        "v passes a value asked for", "psi passes a value asked for",
        "psi is least", "psi is largest", "friction is least",
        "friction is largest", "the block is slowest", "the block is fastest",
        "|mu - tan(alpha)| falls below level",
        "|mu - tan(alpha)| rises above level", "next to a stable node",
        "v = 0" } },
    { "kind",
      "of an extremum of steady-state friction",
      extremum_names,
      { "saddle and creep node meet above its slope",
        "saddle and sliding node meet below its slope" } },
    { "outcome",
      "of a case of stress",
      stress_outcome_names,
      { "every number is within its bar and has its digits",
        "no lie, but digits are missing, or the oracle cannot tell",
        "what was asked for does not exist", "the program said it could not",
        "a number is off by more than its bar" } },
    { "status",
      "of a run of workprec",
      workprec_status_names,
      { "done", "says the method itself",
        "says it succeeded, and is far off" } },
};

void markdown_text(FILE *out, const char *text)
{
    for (; *text; text++)
        fprintf(out, "%s%c", *text == '|' ? "\\" : "", *text);
}

void markdown_words(FILE *out, const char *const *words)
{
    for (size_t i = 0; words[i]; i++)
        fprintf(out, "%s`%s`", i ? " " : "", words[i]);
}

static void put_exits(FILE *out)
{
    fputs("\n## Exit codes\n\n| code | meaning |\n|---|---|\n", out);
    for (const struct exit_line *e = exit_lines; e->code; e++)
        fprintf(out, "| %s | %s |\n", e->code, e->text);
}

static void put_list(FILE *out, const struct word_list *l)
{
    fprintf(out,
            "\n## `%s`\n\n%s\n\n| code | word | meaning |\n|---|---|---|\n",
            l->name, l->where);
    for (int i = 0; l->words[i]; i++) {
        fprintf(out, "| %d | `%s` | ", i, l->words[i]);
        markdown_text(out, i < MEANINGS && l->meaning[i] ? l->meaning[i] : "");
        fputs(" |\n", out);
    }
}

static void put_quantities(FILE *out)
{
    fputs("\n## `quantity`\n\nof a run of workprec, and how its error is "
          "measured\n\n| code | word | meaning |\n|---|---|---|\n",
          out);
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        fprintf(out, "| %d | `%s` | %s |\n", q, workprec_quantity_names[q],
                workprec_quantity_texts[q]);
}

void reference_words(FILE *out)
{
    fputs(text_words, out);
    put_exits(out);
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        put_list(out, &lists[i]);
    put_quantities(out);
}
