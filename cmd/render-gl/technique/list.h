/* The techniques of --technique, in the order of its choices; the first is the default. Adding one adds a line. */
#ifndef RENDER_TECHNIQUE_LIST_H
#define RENDER_TECHNIQUE_LIST_H

#include "render-gl/technique/technique.h"

#define TECHNIQUES(X)                                                                                                  \
    X(tam)                                                                                                             \
    X(tam_flat)                                                                                                        \
    X(tam_face)                                                                                                        \
    X(tam_gouraud)                                                                                                     \
    X(tam_triple)                                                                                                      \
    X(tam_threshold)                                                                                                   \
    X(gouraud)                                                                                                         \
    X(rptam)                                                                                                           \
    X(volume)                                                                                                          \
    X(threshold)                                                                                                       \
    X(threshold_soft)

/* Technique NAME is technique_NAME of its file. */
#define TECHNIQUE_DECLARE(name) extern const struct technique technique_##name;
TECHNIQUES(TECHNIQUE_DECLARE)

/* TECHNIQUE_COUNT pointers and NULL. */
extern const struct technique *const techniques[];

#define TECHNIQUE_ONE(name) +1
enum { TECHNIQUE_COUNT = 0 TECHNIQUES(TECHNIQUE_ONE) };

/* The first technique with a feature of enum technique_feature that one has. */
const struct technique *technique_find(enum technique_feature feature);

#endif
