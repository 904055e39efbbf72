/* Faces so near the eye that floats cannot resolve their position. They are cut into pieces in double-double
 * arithmetic; a piece's vertices are floats, with positions relative to the eye and texture coordinates relative to the
 * piece's first corner (near/subdivide.h). The faces around the near ones are drawn both from the index buffer and as
 * pieces, so that their different rounding opens no gap. */
#ifndef HATCH_NEAR_NEAR_H
#define HATCH_NEAR_NEAR_H

#include "scene/unit_scene.h"
#include "view/view.h"

#define HATCH_NEAR_PIXELS 0.02 /* largest accepted error of float positions, in pixels */

/* A vertex of a piece, as a vertex shader reads it. */
struct hatch_near_vertex {
    float position[3];     /* camera coordinates: right, up, back */
    float place[3];        /* in the texture, relative to origin */
    float weight[3];       /* barycentric coordinates in the face; their sum is 1 */
    uint32_t corner[3];    /* the face's vertices, as indices into the item's mesh */
    uint32_t origin[3][4]; /* place in the texture of the piece's first corner, as fixed-point numbers of
                              hatch_piece_fixed */
};

/* How a list of faces is drawn: ranges of its index buffer, and pieces for the faces between the ranges. */
struct hatch_near_cut {
    bool is_cut;          /* false: all faces are drawn from the index buffer; the other members are zero */
    uint32_t range_count; /* number of ranges of the index buffer */
    int *counts;          /* per range: number of indices */
    const void **offsets; /* per range: byte offset, as glMultiDrawElements expects it */
    int first, count;     /* range of the pieces' vertices in hatch_near.vertices */
};

struct hatch_near_item {
    struct hatch_near_cut surface, patches; /* patches: of lapped textures only */
};

struct hatch_near_shape;

/* Data kept between frames. Starts zeroed; hatch_near_free releases it. */
struct hatch_near {
    bool is_open;                          /* the arenas are initialized */
    struct hatch_arena kept, posed, frame; /* until hatch_near_free, the next pose, the next frame */
    uint32_t pose_number, frame_number;    /* of the last call; pose_number as in struct hatch_unit_scene */
    struct hatch_near_shape *shapes;       /* per item */
    struct hatch_near_item *items;         /* per item, of the last frame; NULL: no pieces */
    struct hatch_near_vertex *vertices;    /* of the pieces of the last frame */
    size_t vertex_count;
};

/* Where a vertex lies in the texture. */
enum hatch_near_places {
    HATCH_NEAR_NONE,      /* no pieces are made: only the near plane is set */
    HATCH_NEAR_TEXCOORDS, /* at its texture coordinates: u, v and 0 */
    HATCH_NEAR_REST       /* at its place in a solid texture: struct hatch_item_rest */
};

struct hatch_near_options {
    enum hatch_near_places places;
    double turn[2];                /* cosine and sine of the rotation of texture coordinates, times their scale */
    const struct hatch_tile *tile; /* part of the picture that is drawn */
    uint64_t max_memory;           /* limit of each arena, bytes */
};

/* Finds the near faces of a posed scene and cuts them into pieces. Where the view's near plane is automatic, it is
 * moved in front of the nearest face. The scene must be the same in all calls. */
enum hatch_status hatch_near_find(struct hatch_near *near, const struct hatch_unit_scene *scene,
                                  const struct hatch_near_options *options, struct hatch_view *view,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Returns how an item is drawn in the frame of the last call; NULL: all its faces are drawn from the index buffer.
 *   item  index into the scene's items */
const struct hatch_near_item *hatch_near_item_at(const struct hatch_near *near, uint32_t item);

/* Releases all memory and zeroes *near. */
void hatch_near_free(struct hatch_near *near);

#endif
