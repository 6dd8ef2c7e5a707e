#include "command.h"

#include <string.h>

/* clang-format off */
static const struct command table[] = {
    { "portrait", "[SCENE.yaml]", "phase portrait: HDF5 file and picture",
      "slipway portrait --law spinodal_gen --alpha 0.34 --figure a.svg",
      command_portrait },
    { "study", "SCENE.yaml", "all that the scene's products ask for",
      "slipway study scenes/fig07b.yaml", command_study },
    { "plan", "SCENE.yaml", "the stages a study would run; runs nothing",
      "slipway plan scenes/fig07b.yaml", command_plan },
    { "knees", "[SCENE.yaml]", "critical velocities, knees, static friction",
      "slipway knees --law dieterich_gen --alpha 0.34 --json", command_knees },
    { "basin", "[SCENE.yaml]", "which states stop and which slide, as a map",
      "slipway basin --law spinodal_gen --alpha 0.34 --figure basin.png",
      command_basin },
    { "sweep", "SCENE.yaml", "the numbers of knees over a key, or a grid of two",
      "slipway sweep scenes/sweep.yaml", command_sweep },
    { "push", "[SCENE.yaml]", "one state: stops or slides, and what changes it",
      "slipway push --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10",
      command_push },
    { "simulate", "[SCENE.yaml]", "the motion from a start: events, phases",
      "slipway simulate --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10",
      command_simulate },
    { "rabinowicz", "[SCENE.yaml]", "impact experiments: l_k, and fits to data",
      "slipway rabinowicz scenes/rabinowicz.yaml", command_rabinowicz },
    { "gallery", "[-o DIR]", "every figure of the paper, with a page of HTML",
      "slipway gallery -o outputs/gallery", command_gallery },
    { "check", "TABLE.csv...", "do stored numbers still hold? or --record them",
      "slipway check --record scenes/fig07b.yaml -o fig07b.csv", command_check },
    { "workprec", "[SCENE.yaml]", "error against run time, ours and others'",
      "slipway workprec --quick", command_workprec },
    { "stress", "[SCENE.yaml]", "stiff and extreme cases, held to 113 bits",
      "slipway stress --quick", command_stress },
    { "laws", "", "the friction laws and their formulas",
      "slipway laws", command_laws },
    { "info", "FILE.h5 [scene]", "what a result file holds; prints its scene",
      "slipway info outputs/fig07b.h5 scene", command_info },
    { "help", "[COMMAND]", "this list, or one command",
      "slipway help knees", command_help },
};
/* clang-format on */

enum { COMMANDS = sizeof table / sizeof *table };

/* How many letters differ, roughly: enough to guess a typing slip. */
static size_t misspelling(const char *a, const char *b)
{
    size_t same = 0;
    const size_t n = strlen(a), m = strlen(b);

    while (same < n && same < m && a[same] == b[same])
        same++;
    size_t tail = 0;
    while (tail + same < n && tail + same < m &&
           a[n - 1 - tail] == b[m - 1 - tail])
        tail++;
    return (n > m ? n : m) - same - tail;
}

const struct command *command_find(const char *name, const char **nearest)
{
    size_t least = 3;

    for (int i = 0; i < COMMANDS; i++) {
        const size_t wrong = misspelling(name, table[i].name);
        if (wrong == 0)
            return &table[i];
        if (wrong < least) {
            least = wrong;
            *nearest = table[i].name;
        }
    }
    return NULL;
}

void command_list(FILE *out)
{
    fprintf(out, "Commands:\n");
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "  %-10s %-15s %s\n", table[i].name, table[i].arguments,
                table[i].text);
    fprintf(out, "\nExamples:\n");
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "  %s\n", table[i].example);
    fprintf(out, "\nExit status: 0 done (also when something does not exist), "
                 "1 a check failed,\n2 wrong command line or scene, 3 "
                 "numerical failure, 4 file trouble.\n");
}

enum exit_code command_fail(enum status s, const char *text)
{
    fprintf(stderr, "slipway: %s\n", text[0] ? text : status_text(s));
    switch (s) {
        case STATUS_BAD_SCENE:
        case STATUS_BAD_ARGUMENT:
            return EXIT_USAGE;
        case STATUS_IO:
        case STATUS_NO_GNUPLOT:
            return EXIT_FILE;
        case STATUS_STOPPED:
            return EXIT_INTERRUPT;
        default:
            return EXIT_NUMBER;
    }
}

enum exit_code command_unwritten(void)
{
    return command_fail(STATUS_IO, "cannot write to standard output");
}

enum exit_code command_allow(const struct options *o, size_t arguments)
{
    if (o->files <= arguments)
        return EXIT_DONE;
    fprintf(stderr,
            "slipway: %s: %s: one argument too many (see slipway help "
            "%s)\n",
            o->command, o->file[arguments], o->command);
    return EXIT_USAGE;
}

void command_describe(FILE *out, const struct command *c)
{
    fprintf(out, "slipway %s %s\n  %s\nExample:\n  %s\n", c->name, c->arguments,
            c->text, c->example);
}

enum exit_code command_help(const struct options *o)
{
    const char *nearest = NULL;

    if (o->files == 0) {
        printf("Usage: slipway COMMAND [SCENE.yaml] [options]   (options: "
               "slipway --help)\n\n");
        command_list(stdout);
        return EXIT_DONE;
    }
    if (command_allow(o, 1) != EXIT_DONE)
        return EXIT_USAGE;
    const struct command *c = command_find(o->file[0], &nearest);
    if (c == NULL) {
        fprintf(stderr, "slipway: no command '%s'%s%s%s\n", o->file[0],
                nearest ? ", did you mean " : "", nearest ? nearest : "",
                nearest ? "?" : "");
        return EXIT_USAGE;
    }
    command_describe(stdout, c);
    return EXIT_DONE;
}
