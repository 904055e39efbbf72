/* Writes meshes and scenes as GLB, the binary form of glTF 2.0. */
#ifndef HATCH_IO_GLB_GLB_H
#define HATCH_IO_GLB_GLB_H

#include "base/bytes.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/* Writes one mesh as GLB: no warning from the Khronos validator. Attributes by their names; indices as
 * 16 or 32 bits as needed. comment: asset.extras.hatch (seed, options), may be NULL. */
enum hatch_status hatch_glb_write(const struct hatch_mesh *mesh, const char *name, const char *comment,
                                  struct hatch_arena *scratch, struct hatch_buffer *file,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Writes a scene: nodes, meshes (those of one node as primitives of one glTF mesh, in their order), materials,
 * textures, cameras, lights, skins, animations; no warning from the Khronos validator that the scene's numbers
 * do not earn. What hatch_gltf_read reads from it is the scene again, but for what cannot be written: meshes
 * without faces, images that are no PNG or JPEG, skins without joints, animations that move nothing. A
 * material with `outline` is written as a blended one whose baseColorTexture uses TEXCOORD_1, with extras
 * {"hatch": "outline"}. scene: two nodes' meshes are the same range or have none in common. comment: as above.
 * HATCH_LIMIT over 4 GiB. */
enum hatch_status hatch_glb_write_scene(const struct hatch_scene *scene, const char *comment,
                                        struct hatch_arena *scratch, struct hatch_buffer *file,
                                        struct hatch_err *err) HATCH_MUST_USE;

#endif
