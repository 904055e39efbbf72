/* The patches' faces of a lapped texture, grouped by the surface's faces that they lie on. */
#ifndef HATCH_MEASURE_LAPPED_FACES_H
#define HATCH_MEASURE_LAPPED_FACES_H

#include "image/image.h"
#include "scene/scene.h"

/* A face of a patch. Two lie on one face of the surface when group and points are equal. */
struct hatch_lapped_face {
    uint32_t group;       /* first mesh of the node that uses the patch */
    uint32_t point[3];    /* numbers of the corners' positions, ascending */
    uint32_t patch, face; /* index of the patch; index of the face in it */
    uint8_t corner[3];    /* the face's corner at point[i] */
};

struct hatch_lapped_faces {
    uint32_t count;                 /* of the patches' faces */
    struct hatch_lapped_face *list; /* grouped by faces of the surface, in drawing order within each */
    uint32_t surface_count;         /* of the surface's faces */
    uint32_t *first;                /* surface_count + 1: per face of the surface, the first entry in list */
    const struct hatch_scene_mesh **patches;
    const struct hatch_image **masks; /* per patch */
    uint32_t patch_count;
};

/* Finds the faces of all patches that nodes of the scene use.
 *   masks  per texture, as for hatch_measure_lapped
 *   faces  out: in scratch
 * HATCH_BAD_INPUT when there is no patch, or one has no texture coordinates or outline. */
enum hatch_status hatch_lapped_faces_find(const struct hatch_scene *scene, const struct hatch_image *masks,
                                          struct hatch_arena *scratch, struct hatch_lapped_faces *faces,
                                          struct hatch_err *err) HATCH_MUST_USE;

/* Whether two faces lie on one face of the surface. */
bool hatch_lapped_faces_coincide(const struct hatch_lapped_face *a, const struct hatch_lapped_face *b);

#endif
