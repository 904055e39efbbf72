/* Finds the place on a mesh that is nearest to a point. */
#ifndef HATCH_MESH_NEAREST_NEAREST_H
#define HATCH_MESH_NEAREST_NEAREST_H

#include "mesh/mesh.h"

/* A tree of boxes around the faces. Boxes of long thin faces that run across the axes hold little but air; their nodes
 * have capsules, too (Larsen et al., "Fast proximity queries with swept sphere volumes", ICRA 2000). */
struct hatch_nearest {
    uint32_t face_count, leaf_count; /* leaf_count: a power of two; leaf i has the faces with places in the list from
                                        i * face_count / leaf_count to the next leaf's */
    uint32_t *faces;                 /* the list */
    uint32_t *place;                 /* per face: its place in the list */
    float *corners;                  /* 9 per place */
    float *boxes; /* 6 per node: low, high; node 1 is the root, 2 i and 2 i + 1 are the children of i */
    float *spans; /* 7 per node: two ends of a segment, and the radius of the capsule around it that holds the faces;
                     a radius of INFINITY: the box is as good a bound; NULL: few nodes have a capsule */
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

/* Returns whether a face is at most `distance` from a point. */
bool hatch_nearest_is_near(const struct hatch_nearest *nearest, uint32_t face, const double point[3], double distance);

#define HATCH_NEAREST_LIST_MAX 16u

/* The faces of which one is the nearest to any point of a ball. */
struct hatch_nearest_list {
    double center[3];
    uint32_t count;
    struct {
        double distance; /* from the centre; increasing */
        uint32_t place;
    } items[HATCH_NEAREST_LIST_MAX];
};

/* Lists the faces for a ball. Returns false where they are more than HATCH_NEAREST_LIST_MAX.
 *   hint  as above */
bool hatch_nearest_gather(const struct hatch_nearest *nearest, const double center[3], double radius, uint32_t hint,
                          struct hatch_nearest_list *list);

/* Finds the nearest place to a point of the list's ball. */
void hatch_nearest_find_listed(const struct hatch_nearest *nearest, const struct hatch_nearest_list *list,
                               const double point[3], struct hatch_nearest_place *place);

#endif
