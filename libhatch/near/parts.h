/* Steps of hatch_near_find: choosing near faces, and cutting them. Internal to near. */
#ifndef HATCH_NEAR_PARTS_H
#define HATCH_NEAR_PARTS_H

#include "base/bytes.h"
#include "near/near.h"

/* A list of faces of an item: of its surface or of its patches. */
struct hatch_near_faces {
    const uint32_t *indices;
    const uint32_t *vertex_of; /* converts an index to a vertex of the item's mesh; NULL: indices are such vertices */
    uint32_t count;            /* of faces */
};

/* The lists of faces of an item; ordinary meshes have only the first. */
enum { HATCH_NEAR_SURFACE, HATCH_NEAR_PATCHES, HATCH_NEAR_LISTS };

/* Returns the vertex at corner k, 0 .. 2, of a face. */
static inline uint32_t hatch_near_corner(const struct hatch_near_faces *faces, size_t face, size_t k)
{
    uint32_t index = faces->indices[3 * face + k];
    return faces->vertex_of ? faces->vertex_of[index] : index;
}

/* Bounding sphere of a block of successive faces, in the unit scene. */
struct hatch_near_sphere {
    double center[3], radius;
};

#define HATCH_NEAR_BLOCK 64u /* faces per block */

/* Data of an item, kept between frames. */
struct hatch_near_shape {
    double *positions; /* 3 per vertex, world coordinates; NULL: not computed for this pose */
    struct hatch_near_sphere *blocks[HATCH_NEAR_LISTS]; /* per list: bounding spheres of its blocks */
    uint32_t *points; /* per vertex: number of the point that it is welded to; NULL: not computed yet */
    uint32_t *marks;  /* per point: number of the last frame in which it was on a near face */
};

/* State of one call. */
struct hatch_near_frame {
    struct hatch_near *near;
    const struct hatch_unit_scene *scene;
    const struct hatch_near_options *options;
    const struct hatch_view *view;
    double reach; /* perspective: distance within which faces are near, unless large texture coordinates extend it;
                     orthographic: float error over HATCH_NEAR_PIXELS */
    double half_diagonal; /* half the picture's diagonal plus a margin, for an orthographic view */
    double nearest;       /* distance of the nearest face found so far */
};

/* A list of faces of an item, to be searched for near ones. */
struct hatch_near_target {
    const struct hatch_item *item;
    struct hatch_near_shape *shape;
    int list; /* HATCH_NEAR_SURFACE or HATCH_NEAR_PATCHES */
    struct hatch_near_faces faces;
};

/* The near faces of a list, and the faces to cut: the near ones and those that share a point with one. Both arrays are
 * in ascending order. */
struct hatch_near_choice {
    uint32_t near_count, piece_count;
    uint32_t *near_faces, *piece_faces;
};

/* Returns whether the item's bounding box is within reach of the eye. */
bool hatch_near_touches(const struct hatch_near_frame *frame, const struct hatch_item *item);

/* Fills the item's lists of faces and returns their number: HATCH_NEAR_LISTS for lapped textures, else 1.
 *   item  index into the scene's items */
int hatch_near_lists(const struct hatch_near_frame *frame, uint32_t item,
                     struct hatch_near_target lists[HATCH_NEAR_LISTS]);

/* Computes the positions and bounding spheres of an item at the pose, unless they are computed already.
 *   item  index into the scene's items */
enum hatch_status hatch_near_shape_make(struct hatch_near_frame *frame, uint32_t item,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Chooses the near faces of a list and those around them.
 *   choice  out: in the arena of the frame */
enum hatch_status hatch_near_choose(struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                    struct hatch_near_choice *choice, struct hatch_err *err) HATCH_MUST_USE;

/* Adds the pieces of the chosen faces to a buffer of struct hatch_near_vertex. */
enum hatch_status hatch_near_cut_faces(const struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                       const struct hatch_near_choice *choice, struct hatch_buffer *buffer,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
