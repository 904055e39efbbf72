/* The techniques of --technique, in the order of the option's choices; the first is the default. A new technique needs
 * a line in TECHNIQUES. */
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
    X(threshold_soft)                                                                                                  \
    X(traced)                                                                                                          \
    X(strokes)                                                                                                         \
    X(solid)

/* Declares a variable technique_NAME for each NAME of the list. It is defined in technique/NAME.c. */
#define TECHNIQUE_DECLARE(name) extern const struct technique technique_##name;
TECHNIQUES(TECHNIQUE_DECLARE)

/* TECHNIQUE_COUNT pointers, ended by NULL. */
extern const struct technique *const techniques[];

#define TECHNIQUE_ONE(name) +1
enum { TECHNIQUE_COUNT = 0 TECHNIQUES(TECHNIQUE_ONE) };

/* Returns the first technique with a feature; at least one technique must have it. */
const struct technique *technique_find(enum technique_feature feature);

#endif
