/* Splits vertices so that all face corners that use a vertex have the same class. A class is a number that the caller
 * gives to corners that may share a vertex. */
#ifndef HATCH_MESH_SPLITS_H
#define HATCH_MESH_SPLITS_H

#include "mesh/mesh.h"

#define HATCH_NO_CLASS UINT32_MAX

/* The vertices after splitting: the old ones under their old indices, then the copies. */
struct hatch_splits {
    uint32_t count;
    uint32_t *origin;   /* per vertex: the old vertex */
    uint32_t *class_at; /* per vertex: class of its corners; HATCH_NO_CLASS where no corner uses it */
    uint32_t *indices;  /* per corner: its vertex */
};

/* Splits vertices. The class of the first corner that uses a vertex keeps the old index; copies
 * are numbered in the order of the first corners that use them. Takes time proportional to the corners and vertices.
 *   vertex    per corner
 *   class_of  per corner; below corner_count + vertex_count
 *   splits    out: its arrays are in scratch */
enum hatch_status hatch_splits_make(const uint32_t *vertex, const uint32_t *class_of, size_t corner_count,
                                    uint32_t vertex_count, struct hatch_arena *scratch, struct hatch_splits *splits,
                                    struct hatch_err *err) HATCH_MUST_USE;

#endif
