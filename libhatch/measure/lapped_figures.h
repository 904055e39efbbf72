/* Measurements of lapped textures, from the values in the file: patches in drawing order, their texture coordinates and
 * outlines; hatchstat(1) has the formulas. */
#ifndef HATCH_MEASURE_LAPPED_FIGURES_H
#define HATCH_MEASURE_LAPPED_FIGURES_H

#include "base/progress.h"
#include "image/image.h"
#include "scene/scene.h"

/* Indices of percentiles: 50 %, 95 %, 99 % and the maximum. */
enum { HATCH_LAPPED_P50, HATCH_LAPPED_P95, HATCH_LAPPED_P99, HATCH_LAPPED_MAX, HATCH_LAPPED_SHARES };

struct hatch_lapped_figures {
    uint32_t patches;     /* meshes that nodes use and whose material has an outline */
    uint32_t hidden;      /* patches that are visible at no sample */
    uint32_t faces;       /* faces of the surface: coincident faces of patches count once */
    uint32_t patch_faces; /* faces of all patches */
    double overlap;       /* patch_faces / faces */
    uint32_t samples;
    double covered;                      /* share of the samples at which a patch has opacity 1 */
    double opacity_min;                  /* least joint opacity of all patches at a sample */
    uint32_t flipped;                    /* patch faces whose texture is mirrored or has no area */
    double stretch[HATCH_LAPPED_SHARES]; /* larger / smaller singular value of patch faces */
    double area[HATCH_LAPPED_SHARES]; /* texture area per area of patch faces, relative to the mean, or the inverse of
                                         this ratio if that is larger */
    double angle_deg[HATCH_LAPPED_SHARES];      /* between the direction in which u rises and _HATCH_DIR, 0 .. 90; NaN
                                                   without a field */
    double angle_area_deg[HATCH_LAPPED_SHARES]; /* the same, weighted by area */
};

/* Measures all patches that nodes use, in the coordinates of their meshes: transforms of nodes do not count.
 *   masks     image of each texture of the scene; its pixels are NULL if the texture is not an outline. Channel A is
 *             the opacity; without it the mask is opaque
 *   samples   at least 1; uniform by area
 *   seed      random seed of the samples
 *   progress  NULL: nobody is told
 * HATCH_BAD_INPUT when there is no patch, or one has no texture coordinates or outline. */
enum hatch_status hatch_measure_lapped(const struct hatch_scene *scene, const struct hatch_image *masks,
                                       uint32_t samples, uint64_t seed, const struct hatch_progress *progress,
                                       struct hatch_arena *scratch, struct hatch_lapped_figures *figures,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
