/* pushed.h -- push.h at a law and a slope, for its tests. */
#pragma once

#include "push.h"
#include "slope.h"

/* Must not move. */
struct pushed {
    struct scene scene;
    struct push push;
};

static inline void push_make(struct pushed *p, const char *law,
                             const char *alpha)
{
    struct fault why;

    slope_scene(&p->scene, law, NULL, alpha, ((const char *const[]){ NULL }));
    const enum status s = push_init(&p->push, &p->scene, NULL, &why);
    CHECK(s == STATUS_OK, "%s", why.text);
}

static inline void pushed_free(struct pushed *p)
{
    push_free(&p->push);
    push_free(&p->push);
    scene_free(&p->scene);
}

static inline struct push_answer answer(const struct pushed *p, double v,
                                        double psi)
{
    struct push_answer a;
    const enum status s =
        push_find(&p->push, (struct push_state){ v, psi }, NULL, &a);

    CHECK(s == STATUS_OK, "(%g, %g): %s", v, psi, status_text(s));
    return a;
}
