/* slipway import: a model of XPPAUT as a scene. */
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "json.h"
#include "output.h"
#include "replace.h"
#include "scene_ode.h"
#include "text_file.h"
#include "xpp_model.h"

static enum status convert(const struct options *o, char **scene,
                           struct fault *why)
{
    char *text = NULL;
    size_t size;

    if (o->files == 0)
        return fault_set(why, STATUS_BAD_ARGUMENT,
                         "import: expected a model, NAME.ode");
    const char *file = output_path(o);
    enum status s = output_standard_check(o, why);
    if (s == STATUS_OK && file)
        s = output_path_check(o, NULL, file, why);
    if (s == STATUS_OK)
        s = text_file_read(o->file[0], XPP_SIZE, &text, &size, why);
    if (s == STATUS_OK)
        s = scene_of_ode(o->file[0], text, scene, why);
    free(text);
    if (s == STATUS_OK && file)
        s = replace_file(file, *scene, strlen(*scene), why);
    return s;
}

static bool tell(const struct options *o, const char *scene)
{
    if (o->json)
        return json_print(json_pack("{s:s}", "scene", scene));
    if (output_path(o))
        return o->quiet || printf("wrote %s\n", o->output) > 0;
    return fputs(scene, stdout) >= 0;
}

enum exit_code command_import(const struct options *o)
{
    char *scene = NULL;
    struct fault why = { "" };
    const enum status s = convert(o, &scene, &why);
    enum exit_code code = EXIT_DONE;

    if (s != STATUS_OK)
        code = command_fail(s, why.text);
    else if (!tell(o, scene))
        code = command_unwritten();
    free(scene);
    return code;
}
