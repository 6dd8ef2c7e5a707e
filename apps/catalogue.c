#include "catalogue.h"

#include <stdint.h>
#include <string.h>

#include "spell.h"

/* clang-format off */
const struct command command_table[COMMANDS] = {
    [COMMAND_PORTRAIT] = { "portrait", 1, "[SCENE.yaml]",
      "phase portrait: HDF5 file and picture",
      "Finds the equilibria, the nullclines and the saddle's stable and "
      "unstable manifolds, follows trajectories, and draws them in the "
      "scene's window. Without a scene, a law and a slope are enough (--law, "
      "--alpha).",
      "slipway portrait --law spinodal_gen --alpha 0.34 --figure a.svg" },
    [COMMAND_STUDY] = { "study", 1, "SCENE.yaml",
      "all that the scene's products ask for",
      "Runs the stages that the scene's products need and no others, writes "
      "output.hdf5, draws output.figure and prints the numbers. A scene with "
      "a sweep, with measured release distances or with starts alone is "
      "handed to the command it is for.",
      "slipway study scenes/fig07b.yaml" },
    [COMMAND_PLAN] = { "plan", 1, "SCENE.yaml",
      "the stages a study would run; runs nothing",
      "Says which stages a study of this scene would run, what each costs and "
      "which files it would write.",
      "slipway plan scenes/fig07b.yaml" },
    [COMMAND_KNEES] = { "knees", 1, "[SCENE.yaml]",
      "critical velocities, knees, static friction",
      "Prints the critical velocities v_plus and v_minus at which the "
      "saddle's stable manifold ends, its knees, the persistence length, "
      "static friction, the folds and the paper's estimates, each with its "
      "error or the reason why it does not exist.",
      "slipway knees --law dieterich_gen --alpha 0.34 --json" },
    [COMMAND_BASIN] = { "basin", 1, "[SCENE.yaml]",
      "which states stop and which slide, as a map",
      "Labels every state of a grid with its fate, by the stable manifold as "
      "boundary; a thousand cells are followed forward in time to check it. "
      "Products margin, slip, time, friction and peak add a field each.",
      "slipway basin --law spinodal_gen --alpha 0.34 --figure basin.png" },
    [COMMAND_SWEEP] = { "sweep", 1, "SCENE.yaml",
      "a study over a key, or a grid of two",
      "Computes what the scene's products ask for, else the numbers of knees, "
      "at every value of one key of the scene, or of two, and adds points "
      "where the curves bend. Maps (basins, margin, slip, time, friction, "
      "peak) need -o. A sweep that was killed goes on with --resume.",
      "slipway sweep scenes/sweep.yaml" },
    [COMMAND_ENSEMBLE] = { "ensemble", 1, "SCENE.yaml",
      "many materials: distributions, probabilities",
      "Draws materials and slopes from the scene's ensemble, or takes them "
      "from a CSV file, and tells of each number its mean, its quantiles and "
      "how often it exists, of each push the probability of each fate, and "
      "which parameter makes which part of a number's variance. -o keeps every "
      "draw. A run that was killed goes on with --resume.",
      "slipway ensemble scenes/ensemble.yaml --draws 1000" },
    [COMMAND_MERGE] = { "merge", 1, "SCENE.yaml",
      "joins shares of a sweep or an ensemble",
      "Takes what 'slipway sweep SCENE --shard I/N -o FILE.h5', or ensemble, "
      "left in FILE.h5.part.I-of-N, computes what is missing of an interrupted "
      "share and the points that refinement adds, and writes what one run "
      "would have written.",
      "slipway merge scenes/sweep.yaml -o outputs/sweep.h5" },
    [COMMAND_PUSH] = { "push", 1, "[SCENE.yaml]",
      "one state: stops or slides, and what changes it",
      "Says of the state of --v and --psi whether it stops or slides for "
      "ever, how far and how long it slides, and which smallest kick would "
      "change its fate. --states reads many from a CSV file. With inputs "
      "X +- S: how likely it stops. Of a system of formulas: whereto --state "
      "goes.",
      "slipway push --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10" },
    [COMMAND_SIMULATE] = { "simulate", 1, "[SCENE.yaml]",
      "the motion from a start: events, phases",
      "Follows the block from each of the scene's starts, or from that of --v "
      "and --psi: slip, time, friction, events and phases until it rests or "
      "leaves.",
      "slipway simulate --law dieterich_gen --alpha 0.34 --v 1e3 --psi 10" },
    [COMMAND_RABINOWICZ] = { "rabinowicz", 1, "[SCENE.yaml]",
      "impact experiments: l_k, and fits to data",
      "Computes the critical release distance l_k of a law at each slope; "
      "from measured ones (--data) static friction, the memory length and "
      "friction against slip.",
      "slipway rabinowicz scenes/rabinowicz.yaml" },
    [COMMAND_EXPORT] = { "export", 1, "[SCENE.yaml]",
      "the system as input of XPPAUT or AUTO-07p",
      "Writes law, slope and saddle for XPPAUT (--as xppaut, a file NAME.ode) "
      "or for AUTO-07p (--as auto: equations NAME.c, constants c.NAME and "
      "c.NAME.folds, a script NAME.auto). Parameters keep their names there. "
      "XPPAUT traces the saddle's stable manifold (--form arclength) or a "
      "motion (--form time).",
      "slipway export --law spinodal_gen --alpha 0.34 --as xppaut -o slope.ode" },
    [COMMAND_IMPORT] = { "import", 1, "MODEL.ode",
      "a model of XPPAUT as a scene",
      "Writes the planar autonomous system of an .ode file of XPPAUT as a "
      "scene, which can be changed and run (portrait, study); these commands "
      "take the .ode file itself, too. What is not planar, not autonomous or "
      "not analytic is refused with its line and the reason.",
      "slipway import scenes/brusselator.ode -o brusselator.yaml" },
    [COMMAND_GALLERY] = { "gallery", 0, "[-o DIR]",
      "every figure of the paper, with a page of HTML",
      "Runs every scene that draws a figure and writes each as SVG, PNG and "
      "HDF5, with a page, index.html, that shows them all. Scenes are looked "
      "for in ./scenes, then beside the source or the installed program.",
      "slipway gallery -o outputs/gallery" },
    [COMMAND_CHECK] = { "check", SIZE_MAX, "TABLE.csv...",
      "do stored numbers still hold? or --record them",
      "Computes the numbers of a table again and compares them within the "
      "errors stored with them. --record makes such a table from scenes.",
      "slipway check --record scenes/fig07b.yaml -o fig07b.csv" },
    [COMMAND_WORKPREC] = { "workprec", 1, "[SCENE.yaml]",
      "error against run time, ours and others'",
      "Races the manifold's Taylor steps against other methods: error against "
      "run time and evaluations. Of a system of formulas it races the stable "
      "branches of a saddle.",
      "slipway workprec --quick" },
    [COMMAND_STRESS] = { "stress", 1, "[SCENE.yaml]",
      "stiff and extreme cases, held to 113 bits",
      "Runs a catalogue of stiff and extreme cases and holds every error bar "
      "to the same number computed in 113 bits. Of a system of formulas the "
      "cases are itself and its parameters times random factors of 2/3 to "
      "3/2.",
      "slipway stress --quick" },
    [COMMAND_LAWS] = { "laws", 1, "[NAME]",
      "the friction laws and their formulas",
      "Lists the presets, the equations of the paper they come from and the "
      "parameters they use; with --as scene NAME, writes one as formulas of a "
      "scene.",
      "slipway laws --as scene spinodal_gen" },
    [COMMAND_INFO] = { "info", 2, "FILE.h5 [scene]",
      "what a result file holds; its scene; --rerun",
      "Lists groups and data sets of a result file; with the word scene, "
      "prints the scene that makes it again. --rerun makes it again and "
      "compares: \"same bytes\", or one line for each thing that differs and "
      "exit 1.",
      "slipway info outputs/fig07b.h5 scene" },
    [COMMAND_HELP] = { "help", SIZE_MAX, "[COMMAND]",
      "this list, or one command",
      "Lists the commands, or explains one. --as writes a man page, the "
      "completions of a shell (bash, zsh, fish), or a reference: the keys of "
      "scenes (scene), what files hold (hdf5), exit codes and words (words).",
      "slipway help knees" },
};
/* clang-format on */

const struct exit_line exit_lines[] = {
    { "0", "done, also when something does not exist" },
    { "1", "a check failed" },
    { "2", "wrong command line or scene" },
    { "3", "numerical failure" },
    { "4", "file trouble" },
    { "130", "interrupted" },
    { NULL, NULL },
};

const struct command *command_find(const char *name)
{
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, command_table[i].name) == 0)
            return &command_table[i];
    return NULL;
}

const char *command_nearest(const char *name)
{
    const char *names[COMMANDS + 1] = { NULL };

    for (int i = 0; i < COMMANDS; i++)
        names[i] = command_table[i].name;
    return spell_nearest(name, names);
}
