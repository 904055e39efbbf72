/* Vertices that are one but for what textures need. */
#ifndef RENDER_WELD_H
#define RENDER_WELD_H

#include "mesh/mesh.h"

struct hatch_remap {
    uint32_t count;
    uint32_t *number; /* of each of the mesh's vertices: below count, in order of appearance */
    uint32_t *first;  /* of each number: its first vertex */
};

/* Numbers vertices by position and normal; the mesh has both. */
enum hatch_status hatch_remap_by_normal(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                        struct hatch_arena *scratch, struct hatch_remap *weld,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* The same by position and TEXCOORD_0; temporaries stay in the arena, too. */
enum hatch_status hatch_remap_by_texcoord(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                          struct hatch_remap *weld, struct hatch_err *err) HATCH_MUST_USE;

/* Adds the attributes that `from` has and `to` has not: vertex v gets those of from's vertex
 * origin_of[v]. Texture coordinates are left out. POSITION is filled. */
enum hatch_status hatch_remap_attributes(const struct hatch_mesh *from, const uint32_t *origin_of,
                                         struct hatch_arena *arena, struct hatch_mesh *to,
                                         struct hatch_err *err) HATCH_MUST_USE;

#endif
