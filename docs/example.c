/* v_plus of a law on a slope: how fast the block has to be pushed, from long
 * rest, to slide for ever.
 *
 *     cc example.c $(pkg-config --cflags --libs slipway) -o example
 *     ./example dieterich_gen 0.34
 */
#include <slipway/slipway.h>
#include <stdio.h>

int main(int argc, char *argv[])
{
    const char *law = argc > 1 ? argv[1] : "dieterich_gen";
    const char *slope = argc > 2 ? argv[2] : "0.34";
    slipway_scene *scene = NULL;
    slipway_study *study = NULL;
    slipway_fault why = { "" };
    slipway_number v;

    slipway_status s = slipway_scene_new(&scene);
    if (s == SLIPWAY_OK)
        s = slipway_scene_set(scene, "law.preset", law);
    if (s == SLIPWAY_OK)
        s = slipway_scene_set(scene, "slope.alpha", slope);
    if (s == SLIPWAY_OK)
        s = slipway_study_run(scene, NULL, &study, &why);
    if (s == SLIPWAY_OK)
        s = slipway_study_number(study, "v_plus", &v);
    if (s != SLIPWAY_OK)
        fprintf(stderr, "%s\n", why.text);
    else if (v.reason == NULL)
        printf("v_plus = %.15g, to %.1e\n", v.value, v.error);
    else
        printf("v_plus does not exist: %s\n", v.reason);
    slipway_study_free(study);
    slipway_scene_free(scene);
    return s == SLIPWAY_OK ? 0 : s == SLIPWAY_BAD_SCENE ? 2 : 3;
}
