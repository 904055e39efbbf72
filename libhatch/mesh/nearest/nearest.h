/* Finds the place on a mesh that is nearest to a point. */
#ifndef HATCH_MESH_NEAREST_NEAREST_H
#define HATCH_MESH_NEAREST_NEAREST_H

#include "mesh/mesh.h"

/* A tree of boxes around the faces. */
struct hatch_nearest {
    uint32_t face_count, leaf_count; /* leaf_count: a power of two; leaf i has the faces with places in the list from
                                        i * face_count / leaf_count to the next leaf's */
    uint32_t *faces;                 /* the list */
    uint32_t *place;                 /* per face: its place in the list */
    float *corners;                  /* 9 per place */
    float *boxes; /* 6 per node: low, high; node 1 is the root, 2 i and 2 i + 1 are the children of i */
};

struct hatch_nearest_place {
    double distance;
    uint32_t face;
    double share[3]; /* barycentric coordinates */
};

/* Makes the tree.
 *   mesh  has faces */
enum hatch_status hatch_nearest_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_nearest *nearest,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Finds the nearest place to a point.
 *   hint   a face that may be near, with which the search begins; of equally near faces, it is taken */
void hatch_nearest_find(const struct hatch_nearest *nearest, const double point[3], uint32_t hint,
                        struct hatch_nearest_place *place);

/* Returns whether any place is at most `distance` from a point.
 *   hint  in, out: as above; the face found */
bool hatch_nearest_within(const struct hatch_nearest *nearest, const double point[3], double distance, uint32_t *hint);

#endif
