/* Reads scenes from glTF 2.0. tinygltf parses the file; sizes, indices and numbers are checked before and after
 * that. */
#ifndef HATCH_IO_GLTF_GLTF_H
#define HATCH_IO_GLTF_GLTF_H

#include "base/bytes.h"
#include "mesh/mesh.h"
#include "scene/scene.h"

/* A callback that reads the companion files of a glTF (buffers, images). */
struct hatch_gltf_resolver {
    /* Reads one file. A failure is an error if the file is a buffer; an image that cannot be read is only counted in
     * the notes.
     *   uri    decoded, relative, inside the glTF's folder
     *   bytes  out: the file's content, in arena */
    enum hatch_status (*read)(void *context, const char *uri, struct hatch_arena *arena, struct hatch_bytes *bytes,
                              struct hatch_err *err);
    void *context;
};

/* Reads GLB or JSON: the nodes of the default scene, parents before children, and the meshes that they draw (all meshes
 * of a file whose scene has no nodes); levels of detail are not read; triangles, strips and fans as triangles;
 * accessors of every kind (sparse, interleaved, normalised); materials, images (not decoded), cameras, lights,
 * animations and skins; names and extras of all these. A vertex has JOINTS_0 and WEIGHTS_0 alone: where more than four
 * joints move it, the four heaviest, scaled to the sum of all weights (mesh/skin/influences.h). Missing normals become
 * flat normals, as the format demands. Morph targets are applied with the mesh's weights at rest. They are also kept if
 * a node or an animation gives other weights; these are then stored relative to those at rest. Points, lines, morph
 * targets that are not kept, and images that a material uses but that cannot be read are counted in notes. Extensions:
 * KHR_lights_punctual, KHR_mesh_quantization, KHR_texture_transform, EXT_mesh_gpu_instancing (one node per instance),
 * EXT_meshopt_compression, EXT_texture_webp, EXT_texture_avif and KHR_texture_basisu (their fallback images),
 * KHR_materials_* (the base colour; most are kept for writing).
 *   resolver  NULL: no companion file can be read
 *   scene     out: in arena; unchanged on failure
 *   notes     in, out: counts are added
 * HATCH_BAD_INPUT for violations of the format and for other required extensions, which err names. */
enum hatch_status hatch_gltf_read(struct hatch_bytes file, const struct hatch_gltf_resolver *resolver,
                                  struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_scene *scene,
                                  struct hatch_mesh_notes *notes, struct hatch_err *err) HATCH_MUST_USE;

#endif
