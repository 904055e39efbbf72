/* Faces so near the eye that floats cannot place them: they are cut into pieces, in pairs of doubles, of which floats
 * carry the remainder (near/pieces.h). A ring of faces around them is drawn both ways, so that no gap opens between the
 * two ways of rounding. */
#ifndef HATCH_NEAR_NEAR_H
#define HATCH_NEAR_NEAR_H

#include "scene/unit_scene.h"
#include "view/view.h"

#define HATCH_NEAR_PIXELS 0.02 /* largest error of floats that is accepted, in pixels of the picture */

/* A corner of a piece, as a vertex stage reads it. */
struct hatch_near_vertex {
    float place[3];        /* in the camera's coordinates */
    float uv[2];           /* from the piece's origin */
    float weight[3];       /* barycentric coordinates in the face */
    uint32_t corner[3];    /* vertices of the face */
    uint32_t origin[2][4]; /* of u and of v: hatch_piece_fixed */
};

/* How a list of faces is drawn: ranges of its index buffer, and pieces. */
struct hatch_near_cut {
    bool is_cut;          /* else all faces are drawn from the index buffer */
    uint32_t range_count; /* ranges of indices, in 32-bit words: */
    int *counts;          /* indices of each */
    const void **offsets; /* byte offset of each, as OpenGL takes it */
    int first, count;     /* the pieces' corners, in vertices */
};

struct hatch_near_item {
    struct hatch_near_cut surface, patches; /* patches: of lapped meshes */
};

struct hatch_near_shape;

/* Zeroed to begin with; hatch_near_free releases it. */
struct hatch_near {
    bool is_open;
    struct hatch_arena kept, posed, frame; /* for the scene, for a pose, for a frame */
    uint32_t pose_number, frame_number;
    struct hatch_near_shape *shapes;    /* per item */
    struct hatch_near_item *items;      /* per item, of this frame; NULL: no pieces */
    struct hatch_near_vertex *vertices; /* of this frame's pieces */
    size_t vertex_count;
    double plane; /* distance of the last frame's near plane */
};

struct hatch_near_options {
    bool pieces;                   /* else only the near plane is looked for */
    double turn[2];                /* cosine and sine that turn and scale texture coordinates */
    const struct hatch_tile *tile; /* part of the picture that is drawn */
    uint64_t max_memory;           /* bytes, of each arena */
};

/* Finds the near faces of a posed scene and cuts them into pieces; moves the view's near plane, where that is
 * automatic, before the nearest face. HATCH_LIMIT when memory does not suffice. */
enum hatch_status hatch_near_find(struct hatch_near *near, const struct hatch_unit_scene *scene,
                                  const struct hatch_near_options *options, struct hatch_view *view,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* The item's cuts in this frame, or NULL: all its faces are drawn from the index buffer. */
const struct hatch_near_item *hatch_near_item_at(const struct hatch_near *near, uint32_t item);

/* Leaves *near zeroed. */
void hatch_near_free(struct hatch_near *near);

#endif
