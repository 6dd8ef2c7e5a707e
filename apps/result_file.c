#include "result_file.h"

#include <stdio.h>

#include "ensemble_file.h"
#include "provenance.h"
#include "store_results.h"

enum status result_file_begin(struct store **out, const char *path,
                              const struct scene *scene, const char *untitled,
                              bool large, struct fault *why)
{
    const char *title = scene && scene->title[0] ? scene->title : untitled;

    store_silence();
    const enum status s = large ? store_create_on_disk(path, title, out, why)
                                : store_create(path, title, out, why);
    if (s == STATUS_OK)
        why->text[0] = '\0';
    return s;
}

enum status result_file_end(struct store **out, const char *path, enum status s,
                            struct fault *why)
{
    const bool told = why->text[0] != '\0';

    if (!told && (s == STATUS_OK || s == STATUS_IO))
        s = store_commit(*out, why);
    else if (!told)
        snprintf(why->text, sizeof why->text, "%.300s: %s", path,
                 status_text(s));
    store_free(out);
    return s;
}

enum status result_file_write(const char *command, const struct results *all,
                              const struct scene *scene,
                              const struct ensemble *drawn,
                              const char *untitled, const char *path,
                              const struct monitor *monitor, struct fault *why)
{
    struct store *out;
    enum status s =
        result_file_begin(&out, path, scene, untitled, drawn != NULL, why);

    if (s != STATUS_OK)
        return s;
    s = provenance_put(command, scene, out);
    if (s == STATUS_OK)
        s = store_put_results(out, all, monitor);
    if (s == STATUS_OK && drawn)
        s = ensemble_file_put(drawn, out, why);
    return result_file_end(&out, path, s, why);
}
