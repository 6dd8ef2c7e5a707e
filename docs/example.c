/* v_plus of a law on a slope: how fast the block has to be pushed, from long
 * rest, to slide for ever.
 *
 *     cc example.c $(pkg-config --cflags --libs slipway) -o example
 *     ./example dieterich_gen 0.34
 */
#include <slipway/scene.h>
#include <slipway/study.h>
#include <stdio.h>

int main(int argc, char *argv[])
{
    char law[64], slope[64], *setting[] = { law, slope, "products=[knees]" };
    struct scene scene;
    struct study study;
    struct fault why;

    snprintf(law, sizeof law, "law.preset=%s",
             argc > 1 ? argv[1] : "dieterich_gen");
    snprintf(slope, sizeof slope, "slope.alpha=%s",
             argc > 2 ? argv[2] : "0.34");
    if (scene_read(&scene, NULL, setting, 3, &why) != STATUS_OK) {
        fprintf(stderr, "%s\n", why.text);
        return 2;
    }
    const enum status status = study_run(&study, &scene, NULL, &why);
    const struct quantity v = study.critical.v_plus;
    if (status != STATUS_OK)
        fprintf(stderr, "%s\n", why.text);
    else if (quantity_exists(&v))
        printf("v_plus = %.15g, to %.1e\n", v.value, v.error);
    else
        printf("v_plus does not exist: %s\n", v.reason);
    study_free(&study);
    scene_free(&scene);
    return status == STATUS_OK ? 0 : 3;
}
