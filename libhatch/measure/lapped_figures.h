/* The figures of a lapped parametrization, of the file's own values: patches in drawing order, their
 * texture coordinates, the mask. hatchstat(1) writes their formulas. */
#ifndef HATCH_MEASURE_LAPPED_FIGURES_H
#define HATCH_MEASURE_LAPPED_FIGURES_H

#include "image/image.h"
#include "scene/scene.h"

enum { HATCH_LAPPED_P50, HATCH_LAPPED_P95, HATCH_LAPPED_P99, HATCH_LAPPED_MAX, HATCH_LAPPED_SHARES };

struct hatch_lapped_figures {
    uint32_t patches;     /* meshes whose material is an outline */
    uint32_t hidden;      /* of them: later cores hide every sample */
    uint32_t faces;       /* of the surface: those of patches at the same places are one */
    uint32_t patch_faces; /* of all patches */
    double overlap;       /* patch_faces / faces */
    uint32_t samples;
    double covered;                             /* share of them at which some patch has opacity 1 */
    double opacity_min;                         /* of all patches over each other, at the sample where it is least */
    uint32_t flipped;                           /* patch faces whose texture is mirrored or has no area */
    double stretch[HATCH_LAPPED_SHARES];        /* of patch faces: larger over smaller singular value */
    double area[HATCH_LAPPED_SHARES];           /* texture area over area, in units of the whole's, or the inverse,
                                                   whichever is larger */
    double angle_deg[HATCH_LAPPED_SHARES];      /* between rising u and _HATCH_DIR; NaN where no face has one */
    double angle_area_deg[HATCH_LAPPED_SHARES]; /* the same, each face weighed by its area */
};

/* Measures every lapped mesh that a node draws. masks: per texture of the scene, its pixels; pixels NULL
 * for one that is not a mask. Channel A is the opacity; without it all of the square is opaque. samples:
 * at least 1, uniform by area and chosen by seed. HATCH_BAD_INPUT when there is no patch, or one has no
 * texture coordinates or mask. */
enum hatch_status hatch_measure_lapped(const struct hatch_scene *scene, const struct hatch_image *masks,
                                       uint32_t samples, uint64_t seed, struct hatch_arena *scratch,
                                       struct hatch_lapped_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
