#include "command.h"

#include <string.h>

#include "completion.h"
#include "manual.h"
#include "reference.h"
#include "text.h"

/* clang-format off */
static const struct command table[] = {
    { "portrait", "[SCENE.yaml]", "phase portrait: HDF5 file and picture",
      "Finds the equilibria, the nullclines and the saddle's stable and "
      "unstable manifolds, follows trajectories, and draws them in the "
      "scene's window. Without a scene, a law and a slope are enough (--law, "
      "--alpha).",
      "slipway portrait --law spinodal_gen --alpha 0.34 --figure a.svg",
      command_portrait },
    { "study", "SCENE.yaml", "all that the scene's products ask for",
      "Runs the stages that the scene's products need and no others, writes "
      "output.hdf5, draws output.figure and prints the numbers. A scene with "
      "a sweep, with measured release distances or with starts alone is "
      "handed to the command it is for.",
      "slipway study scenes/fig07b.yaml", command_study },
    { "plan", "SCENE.yaml", "the stages a study would run; runs nothing",
      "Says which stages a study of this scene would run, what each costs and "
      "which files it would write.",
      "slipway plan scenes/fig07b.yaml", command_plan },
    { "knees", "[SCENE.yaml]", "critical velocities, knees, static friction",
      "Prints the critical velocities v_plus and v_minus at which the "
      "saddle's stable manifold ends, its knees, the persistence length, "
      "static friction, the folds and the paper's estimates, each with its "
      "error or the reason why it does not exist.",
      "slipway knees --law dieterich_gen --alpha 0.34 --json", command_knees },
    { "basin", "[SCENE.yaml]", "which states stop and which slide, as a map",
      "Labels every state of a grid with its fate, by the stable manifold as "
      "boundary; a thousand cells are followed forward in time to check it. "
      "Products margin, slip, time, friction and peak add a field each.",
      "slipway basin --law spinodal_gen --alpha 0.34 --figure basin.png",
      command_basin },
    { "sweep", "SCENE.yaml", "a study over a key, or a grid of two",
      "Computes what the scene's products ask for, else the numbers of knees, "
      "at every value of one key of the scene, or of two, and adds points "
      "where the curves bend. Maps (basins, margin, slip, time, friction, "
      "peak) need -o. A sweep that was killed goes on with --resume.",
      "slipway sweep scenes/sweep.yaml", command_sweep },
    { "push", "[SCENE.yaml]", "one state: stops or slides, and what changes it",
      "Says of the state of --v and --psi whether it stops or slides for "
      "ever, how far and how long it slides, and which smallest kick would "
      "change its fate. --states reads many from a CSV file.",
      "slipway push --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10",
      command_push },
    { "simulate", "[SCENE.yaml]", "the motion from a start: events, phases",
      "Follows the block from each of the scene's starts, or from that of --v "
      "and --psi: slip, time, friction, events and phases until it rests or "
      "leaves.",
      "slipway simulate --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10",
      command_simulate },
    { "rabinowicz", "[SCENE.yaml]", "impact experiments: l_k, and fits to data",
      "Computes the critical release distance l_k of a law at each slope; "
      "from measured ones (--data) static friction, the memory length and "
      "friction against slip.",
      "slipway rabinowicz scenes/rabinowicz.yaml", command_rabinowicz },
    { "export", "[SCENE.yaml]", "the system as input of XPPAUT or AUTO-07p",
      "Writes law, slope and saddle for XPPAUT (--as xppaut, a file NAME.ode) "
      "or for AUTO-07p (--as auto: equations NAME.c, constants c.NAME and "
      "c.NAME.folds, a script NAME.auto). Parameters keep their names there. "
      "XPPAUT traces the saddle's stable manifold (--form arclength) or a "
      "motion (--form time).",
      "slipway export --law spinodal_gen --alpha 0.34 --as xppaut -o slope.ode",
      command_export },
    { "gallery", "[-o DIR]", "every figure of the paper, with a page of HTML",
      "Runs every scene that draws a figure and writes each as SVG, PNG and "
      "HDF5, with a page, index.html, that shows them all. Scenes are looked "
      "for in ./scenes, then beside the source or the installed program.",
      "slipway gallery -o outputs/gallery", command_gallery },
    { "check", "TABLE.csv...", "do stored numbers still hold? or --record them",
      "Computes the numbers of a table again and compares them within the "
      "errors stored with them. --record makes such a table from scenes.",
      "slipway check --record scenes/fig07b.yaml -o fig07b.csv",
      command_check },
    { "workprec", "[SCENE.yaml]", "error against run time, ours and others'",
      "Races the manifold's Taylor steps against other methods: error against "
      "run time and evaluations.",
      "slipway workprec --quick", command_workprec },
    { "stress", "[SCENE.yaml]", "stiff and extreme cases, held to 113 bits",
      "Runs a catalogue of stiff and extreme cases and holds every error bar "
      "to the same number computed in 113 bits.",
      "slipway stress --quick", command_stress },
    { "laws", "", "the friction laws and their formulas",
      "Lists the presets, the equations of the paper they come from and the "
      "parameters they use.",
      "slipway laws", command_laws },
    { "info", "FILE.h5 [scene]", "what a result file holds; its scene; --rerun",
      "Lists groups and data sets of a result file; with the word scene, "
      "prints the scene that makes it again. --rerun makes it again and "
      "compares: \"same bytes\", or one line for each thing that differs and "
      "exit 1.",
      "slipway info outputs/fig07b.h5 scene", command_info },
    { "help", "[COMMAND]", "this list, or one command",
      "Lists the commands, or explains one. --as writes a man page, the "
      "completions of a shell (bash, zsh, fish), or a reference: the keys of "
      "scenes (scene), what files hold (hdf5), exit codes and words (words).",
      "slipway help knees", command_help },
};
/* clang-format on */

enum { COMMANDS = sizeof table / sizeof *table };

const struct command *command_at(size_t i)
{
    return i < COMMANDS ? &table[i] : NULL;
}

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
    char line[2048]; /* one, whatever a file is called */

    text_show(text[0] ? text : status_text(s), line, sizeof line);
    fprintf(stderr, "slipway: %s\n", line);
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

enum exit_code command_with_scene(
    const struct options *o,
    enum status (*read)(const struct options *o, struct scene *scene,
                        struct fault *why),
    enum exit_code (*run)(const struct options *o, const struct scene *scene))
{
    struct scene scene;
    struct fault why = { "" };
    const enum status s = read(o, &scene, &why);

    if (s != STATUS_OK)
        return command_fail(s, why.text);
    const enum exit_code code = run(o, &scene);
    scene_free(&scene);
    return code;
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

/* In lines of at most 76 letters, two to the right. */
static void put_wrapped(FILE *out, const char *text)
{
    while (*text) {
        size_t n = strlen(text);
        if (n > 74)
            for (n = 74; n > 0 && text[n] != ' ';)
                n--;
        fprintf(out, "  %.*s\n", (int) n, text);
        text += n;
        text += strspn(text, " ");
    }
}

void command_describe(FILE *out, const struct command *c)
{
    fprintf(out, "slipway %s %s\n  %s\n", c->name, c->arguments, c->text);
    put_wrapped(out, c->about);
    fprintf(out, "Example:\n  %s\n", c->example);
}

/* What --as can write besides the pages of single commands. */
static enum exit_code help_as(const char *format)
{
    enum status status = STATUS_OK;

    if (strcmp(format, "man") == 0)
        manual_print(stdout);
    else if (strcmp(format, "scene") == 0)
        reference_scene(stdout);
    else if (strcmp(format, "hdf5") == 0)
        status = reference_hdf5(stdout);
    else if (strcmp(format, "words") == 0)
        reference_words(stdout);
    else
        return completion_print(stdout, format);
    return status == STATUS_OK ? EXIT_DONE : command_fail(status, "");
}

enum exit_code command_help(const struct options *o)
{
    const char *nearest = NULL;

    if (o->as && strcmp(o->as, "man") != 0)
        return command_allow(o, 0) ? EXIT_USAGE : help_as(o->as);
    if (o->files == 0 && o->as)
        return help_as(o->as);
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
    if (o->as)
        manual_print_command(stdout, c);
    else
        command_describe(stdout, c);
    return EXIT_DONE;
}
