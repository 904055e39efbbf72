/* The faces of a lapped scene: which of different patches are one face of the surface. */
#ifndef HATCH_MEASURE_LAPPED_SHEETS_H
#define HATCH_MEASURE_LAPPED_SHEETS_H

#include "image/image.h"
#include "scene/scene.h"

/* A patch's face. Two lie at one place when group and points are equal. */
struct hatch_sheet {
    uint32_t group;    /* the first mesh of those that a node draws together */
    uint32_t point[3]; /* numbers of the corners' positions, rising */
    uint32_t patch, face;
    uint8_t corner[3]; /* of the face: which has point[i] */
};

struct hatch_sheets {
    uint32_t count;
    struct hatch_sheet *list; /* those at one place side by side, in drawing order */
    uint32_t face_count;
    uint32_t *first; /* face_count + 1: per place into list */
    const struct hatch_scene_mesh **patches;
    const struct hatch_image **masks; /* per patch */
    uint32_t patch_count;
};

/* All patches that nodes of the scene draw. HATCH_BAD_INPUT when there is none, or one lacks texture
 * coordinates or its mask. Memory: scratch. */
enum hatch_status hatch_sheets_make(const struct hatch_scene *scene, const struct hatch_image *masks,
                                    struct hatch_arena *scratch, struct hatch_sheets *sheets,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Is sheet b at the place of a? */
bool hatch_sheets_same(const struct hatch_sheet *a, const struct hatch_sheet *b);

#endif
