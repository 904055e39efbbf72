/* Giving vertices once for each class of corners that they serve. */
#ifndef HATCH_MESH_SPLITS_H
#define HATCH_MESH_SPLITS_H

#include "mesh/mesh.h"

#define HATCH_NO_CLASS UINT32_MAX

/* The vertices afterwards: the old ones under their numbers, then the copies. */
struct hatch_splits {
    uint32_t count;
    uint32_t *origin;   /* per vertex: the old one */
    uint32_t *class_at; /* per vertex: of its corners; HATCH_NO_CLASS for one that no corner uses */
};

/* vertex, class_of: of each of the corner_count corners. indices: per corner its vertex afterwards; may be
 * vertex itself. The first class to ask keeps the old vertex. */
enum hatch_status hatch_splits_make(const uint32_t *vertex, const uint32_t *class_of, size_t corner_count,
                                    uint32_t vertex_count, struct hatch_arena *scratch, uint32_t *indices,
                                    struct hatch_splits *splits, struct hatch_err *err) HATCH_MUST_USE;

#endif
