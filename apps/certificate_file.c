#include "certificate_file.h"

#include <stdlib.h>

#include "command.h"
#include "output.h"
#include "replace.h"

enum status certificate_check(const struct options *o,
                              const struct scene *scene, struct fault *why)
{
    if (o->certificate == NULL)
        return STATUS_OK;
    if (!scene->proved)
        return command_refuse(why,
                              "--certificate %s: nothing is proved, expected a "
                              "slope or a system, and --proved",
                              o->certificate);
    return output_path_check(o, scene, o->certificate, why);
}

enum status certificate_write(const struct options *o, json_t *proof,
                              struct fault *why)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    if (out == NULL) {
        json_decref(proof);
        return STATUS_NO_MEMORY;
    }
    const bool whole = json_write(proof, out);
    enum status status =
        fclose(out) == 0 && whole ? STATUS_OK : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = replace_file(o->certificate, text, size, why);
    free(text);
    if (status == STATUS_OK)
        output_tell(o, o->certificate);
    return status;
}
