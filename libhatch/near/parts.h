/* The steps of hatch_near_find: which faces are near, and their pieces. Private to near. */
#ifndef HATCH_NEAR_PARTS_H
#define HATCH_NEAR_PARTS_H

#include "base/bytes.h"
#include "near/near.h"

/* A list of an item's faces: those of its surface, or of its patches. */
struct hatch_near_faces {
    const uint32_t *indices;
    const uint32_t *vertex_of; /* vertex of each index; NULL: indices are vertices */
    uint32_t count;
};

enum { HATCH_NEAR_SURFACE, HATCH_NEAR_PATCHES, HATCH_NEAR_LISTS };

static inline uint32_t hatch_near_corner(const struct hatch_near_faces *faces, size_t face, size_t k)
{
    uint32_t index = faces->indices[3 * face + k];
    return faces->vertex_of ? faces->vertex_of[index] : index;
}

/* Bounding ball of a block of successive faces, in the unit scene. */
struct hatch_near_ball {
    double center[3], radius;
};

#define HATCH_NEAR_BLOCK 64u /* faces in a block */

/* Data of an item that are kept from frame to frame. */
struct hatch_near_shape {
    double *positions;                                /* 3 per vertex, in the world; NULL: not computed for this pose */
    struct hatch_near_ball *blocks[HATCH_NEAR_LISTS]; /* of each list's faces */
    uint32_t *points;                                 /* of each vertex: number of its position; NULL: unset */
    uint32_t *marks;                                  /* of each point: last frame in which a near face has it */
};

struct hatch_near_frame {
    struct hatch_near *near;
    const struct hatch_unit_scene *scene;
    const struct hatch_near_options *options;
    const struct hatch_view *view;
    double reach;   /* distance within which faces are near, where uv_reach is below 2; orthographic: over 1 where
                       floats resolve nothing in the picture */
    double half;    /* half the picture's diagonal, orthographic */
    double nearest; /* distance of the nearest face so far */
};

/* One list of one item. */
struct hatch_near_target {
    const struct hatch_item *item;
    struct hatch_near_shape *shape;
    int list;
    struct hatch_near_faces faces;
};

/* The faces of a list that are near, rising, and those that become pieces: the near ones and their ring. */
struct hatch_near_choice {
    uint32_t near_count, piece_count;
    uint32_t *near_faces, *piece_faces;
};

/* Whether anything of the item is within reach. */
bool hatch_near_touches(const struct hatch_near_frame *frame, const struct hatch_item *item);

/* The item's lists of faces; returns how many it has: 1, or HATCH_NEAR_LISTS where it is lapped. */
int hatch_near_lists(const struct hatch_near_frame *frame, uint32_t item,
                     struct hatch_near_target lists[HATCH_NEAR_LISTS]);

/* Computes an item's shape at the pose, unless that is done. */
enum hatch_status hatch_near_shape_make(struct hatch_near_frame *frame, uint32_t item,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Chooses faces of a list, and marks the points of near ones. */
enum hatch_status hatch_near_choose(struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                    struct hatch_near_choice *choice, struct hatch_err *err) HATCH_MUST_USE;

/* Adds the pieces of the chosen faces to a buffer of struct hatch_near_vertex. */
enum hatch_status hatch_near_cut_faces(const struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                       const struct hatch_near_choice *choice, struct hatch_buffer *buffer,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
