/* The steps of near/near.c: which faces are near, and their pieces. */
#ifndef RENDER_NEAR_PARTS_H
#define RENDER_NEAR_PARTS_H

#include "base/bytes.h"
#include "render-gl/near/near.h"

/* A list of an item's faces: those of its surface, or of its patches. */
struct near_faces {
    const uint32_t *indices;
    const uint32_t *vertex_of; /* of what indices are; NULL: indices are vertices */
    uint32_t count;
};

static inline uint32_t near_corner(const struct near_faces *faces, size_t face, size_t k)
{
    uint32_t index = faces->indices[3 * face + k];
    return faces->vertex_of ? faces->vertex_of[index] : index;
}

/* Around a block of faces that follow one another, in the unit scene. */
struct near_ball {
    double center[3], radius;
};

#define NEAR_BLOCK 64u /* faces in a block */

/* What is kept of an item from frame to frame. */
struct near_shape {
    double *positions;           /* three a vertex, in the world; NULL: not made for this pose */
    struct near_ball *blocks[2]; /* of the surface's faces, and of the patches' */
    uint32_t *points;            /* of each vertex: one number at each position; NULL: nothing was near yet */
    uint32_t *marks;             /* of each point: the last frame in which a near face has it */
    float *repeats;              /* two a vertex, or NULL */
    uint32_t repeats_set;        /* of the item when they were read */
};

/* A frame's measures. */
struct near_frame {
    const struct gpu_scene *scene;
    const struct hatch_view *view;
    double reach; /* faces nearer than that are near, where uv_reach is below 2; orthographic: over 1
                     floats hold nothing in the picture */
    double half;  /* of the picture's diagonal, orthographic */
    uint32_t number;
    double nearest; /* distance of the nearest face so far */
};

/* The faces of a list that are near, rising, and those that are to be pieces: they, and their ring. */
struct near_choice {
    uint32_t near_count, piece_count;
    uint32_t *near_faces, *piece_faces;
};

/* Is anything of the item within reach? */
bool near_touches(const struct near_frame *frame, const struct gpu_item *item);

/* Makes of the item's shape what the pose and the repeats need. */
enum hatch_status near_shape_make(const struct gpu_scene *scene, const struct gpu_item *item, struct hatch_arena *kept,
                                  struct hatch_arena *posed, struct near_shape *shape,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* which: 0 the surface's faces, 1 the patches'. Marks the points of near faces. kept: for the shape's points;
 * arena: for the choice. */
enum hatch_status near_choose(struct near_frame *frame, const struct gpu_item *item, struct near_shape *shape,
                              const struct near_faces *faces, int which, struct hatch_arena *kept,
                              struct hatch_arena *arena, struct near_choice *choice,
                              struct hatch_err *err) HATCH_MUST_USE;

/* The item's lists of faces; returns how many it has: 1, or 2 with patches. */
int near_lists(const struct gpu_scene *scene, const struct gpu_item *item, struct near_faces lists[2]);

/* Adds the pieces of the chosen faces to the buffer, as the vertex stage reads them. */
enum hatch_status near_cut_faces(const struct near_frame *frame, const struct near_wish *wish,
                                 const struct gpu_item *item, const struct near_shape *shape,
                                 const struct near_faces *faces, const struct near_choice *choice,
                                 struct hatch_buffer *buffer, struct hatch_err *err) HATCH_MUST_USE;

/* What the vertex stage reads of a piece's corner. */
struct near_vertex {
    float place[3];  /* in the camera's coordinates */
    float uv[2];     /* from the piece's origin */
    float weight[3]; /* of the face's corners */
    uint32_t corner[3];
    uint32_t origin[2][4]; /* of u and of v: hatch_piece_fixed */
};

#endif
