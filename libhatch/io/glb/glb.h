/* Writes meshes and scenes as GLB, the binary form of glTF 2.0. The files pass the Khronos validator
 * without a warning, unless the numbers themselves are invalid. */
#ifndef HATCH_IO_GLB_GLB_H
#define HATCH_IO_GLB_GLB_H

#include "base/bytes.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/* Writes a mesh as a scene of one node. Indices have 16 bits where that suffices, else 32.
 *   mesh     has at least one face
 *   name     name of node and mesh
 *   comment  stored as asset.extras.hatch: random seed, options; may be NULL
 *   file     out: appended to; its arena is not scratch */
enum hatch_status hatch_glb_write(const struct hatch_mesh *mesh, const char *name, const char *comment,
                                  struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Writes a scene: nodes, meshes (a node's meshes as the primitives of one glTF mesh, in order), materials, textures,
 * cameras, lights, skins and animations, with the names and extras that are kept of them. A material with `outline` is
 * written as a blended one with extras {"hatch": "outline"}, whose baseColorTexture uses TEXCOORD_1. The strokes of a
 * mesh follow it as primitives of mode LINES, one per set, with extras {"hatch": {"family", "level", "angle", "gap"}}
 * (strokes(5)); a mesh with computed normals has extras {"hatch": {"normals": "computed"}}. hatch_gltf_read reads the
 * same scene back, except for parts that are not written: meshes without faces, sets without strokes, images that are
 * neither PNG nor JPEG nor WebP, skins without joints, animations without channels; levels of detail are written only,
 * as are meshes that no node draws, unless the scene has no nodes. Numbers are floats and read back exactly, unless
 * scene->rounding is set. HATCH_LIMIT also above 4 GiB.
 *   scene    the ranges of meshes of any two nodes are equal or disjoint
 *   comment  stored as asset.extras.hatch: random seed, options; may be NULL
 *   file     out: appended to; its arena is not scratch */
enum hatch_status hatch_glb_write_scene(const struct hatch_scene *scene, const char *comment,
                                        struct hatch_arena *scratch, struct hatch_buffer *file,
                                        struct hatch_err *err) HATCH_MUST_USE;

/* Returns whether an image is one of those that are written: a PNG or a JPEG. */
bool hatch_glb_can_hold(const struct hatch_texture *texture);

#endif
