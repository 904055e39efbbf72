/* Reads scenes from glTF 2.0: tinygltf behind our own checks. */
#ifndef HATCH_IO_GLTF_H
#define HATCH_IO_GLTF_H

#include "base/bytes.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/* Reads a companion file of a glTF; uri is relative, decoded, checked not to leave the folder. Its
 * failure is an error for a buffer and a note for an image. */
typedef enum hatch_status (*hatch_gltf_resolve)(void *context, const char *uri, struct hatch_arena *arena,
                                                struct hatch_bytes *bytes, struct hatch_err *err);

/* Reads GLB or JSON: nodes of the default scene (parents before children), triangles, strips and fans
 * as triangles, every accessor kind (sparse, interleaved, normalised), materials, embedded and outside
 * images (not decoded), cameras, KHR_lights_punctual, animations, skins. Missing normals are made flat
 * per the specification's rule. Morph targets count as they rest; where an animation or a node moves them
 * they are kept, with weights beside those at rest, and else noted. Points and lines are skipped.
 * Images that are not there are noted once where a material wants them, and it does without.
 * Known extensions: KHR_lights_punctual, KHR_mesh_quantization, KHR_texture_transform,
 * EXT_mesh_gpu_instancing (a node for each instance), EXT_texture_webp and _avif, of KHR_texture_basisu
 * the image that it replaces, and of KHR_materials_* what changes the base colour.
 * HATCH_BAD_INPUT for what the format forbids and for a required extension that is not known, by
 * name. resolve: NULL where there is no folder. */
enum hatch_status hatch_gltf_read(struct hatch_bytes file, hatch_gltf_resolve resolve, void *context,
                                  struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_scene *scene,
                                  struct hatch_mesh_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

#endif
