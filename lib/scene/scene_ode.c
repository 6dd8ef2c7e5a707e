#include "scene_ode.h"

#include <stdlib.h>
#include <string.h>

#include "text.h"
#include "xpp_model.h"

bool scene_is_ode(const char *path)
{
    const size_t size = strlen(path);

    return size > 4 && strcmp(path + size - 4, ".ode") == 0;
}

enum status scene_of_ode(const char *path, const char *text, char **scene,
                         struct fault *why)
{
    const char *slash = strrchr(path, '/');
    struct xpp_model *model = malloc(sizeof *model);
    struct fault found = { "" };
    char *made = NULL;

    if (model == NULL)
        return STATUS_NO_MEMORY;
    enum status status = xpp_model_read(text, path, model, &found);
    if (status == STATUS_OK) {
        made = xpp_model_scene(model, slash ? slash + 1 : path);
        status = made ? STATUS_OK : STATUS_NO_MEMORY;
    }
    free(model);
    if (status == STATUS_OK)
        *scene = made;
    else if (status == STATUS_BAD_SCENE)
        text_show(found.text, why->text, sizeof why->text);
    return status;
}
