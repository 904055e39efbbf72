/* Private to the glTF reader (C++): types and functions that its files share. Functions that return a status fail with
 * HATCH_BAD_INPUT or HATCH_LIMIT. */
#ifndef HATCH_IO_GLTF_READER_H
#define HATCH_IO_GLTF_READER_H

#include <string>
#include <vector>

#include <tiny_gltf.h>

/* These C headers have a struct and a function of one name (hatch_arena_mark). In C++, -Wshadow warns that the function
 * hides the struct's constructor. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
extern "C" {
#include "io/gltf/gltf.h"
#include "io/gltf/check.h"
#include "io/glb/container.h"
#include "io/glb/glb.h"
#include "mesh/skin/influences.h"
}
#pragma GCC diagnostic pop

namespace hatch
{

/* The morph targets of a glTF mesh, and their weights. */
struct Morph {
    const std::vector<double> *rest; /* those of the first node that uses the mesh and has some, else the mesh's */
    size_t targets;                  /* most of a primitive with faces */
    bool varies;                     /* a node or an animation gives them other weights than at rest */
};

/* All is in the model, or in an arena: a copy is cheap. */
struct Reader {
    const tinygltf::Model &model;
    struct hatch_arena *arena, *scratch;
    struct hatch_scene *scene;
    struct hatch_mesh_notes *notes;
    struct hatch_err *err;
    uint32_t *node_of = nullptr;  /* per glTF node: index of the scene's node; HATCH_NONE outside the default scene */
    bool *image_noted = nullptr;  /* per image: whether notes already count it as missing */
    uint32_t *replaced = nullptr; /* read_floats counts here what it replaces by 0; NULL: it fails */
    uint32_t *users = nullptr;    /* per accessor: primitives with faces that have it as POSITION */
    Morph *morphs = nullptr;      /* per glTF mesh */
    uint32_t first_instance = 0;  /* node from which on all are instances; those of a node follow one another */
};

/* The vertices of a primitive, from `first` to before `end` of those that its attributes have. */
struct Range {
    uint32_t first, end, count;
};

/* Names a place in the file for messages: "mesh 3, primitive 0". */
std::string place(const char *what, size_t index);
std::string place(const char *what, size_t index, const char *part, size_t part_index);

/* Returns HATCH_BAD_INPUT with the message "where: what". */
enum hatch_status bad(Reader &r, const std::string &where, const std::string &what);

/* Fails unless index is -1 (no reference) or 0 .. count - 1. */
enum hatch_status check_index(Reader &r, int index, size_t count, const std::string &where, const char *what);

/* Reads an accessor as floats; normalised integers are divided by the largest value of their type. Fails for values
 * that are not finite.
 *   components  number of components that the accessor must have
 *   data        out: count * components, in r.arena
 *   range       the elements that are read and counted, which there are; NULL: all */
enum hatch_status read_floats(Reader &r, int accessor, int components, const std::string &where, float **data,
                              uint32_t *count, const Range *range = nullptr);

/* Reads an accessor of unsigned integers. Fails for a type's largest value (primitive restart, which glTF
 * excludes).
 *   data  out: count integers, in r.scratch */
enum hatch_status read_indices(Reader &r, int accessor, const std::string &where, uint32_t **data, uint32_t *count);

/* Finds the bytes of a buffer view; fails when they exceed the buffer.
 *   stride  out: bytes from element to element, 0 when unset */
enum hatch_status find_view(Reader &r, int view, const std::string &where, struct hatch_bytes *bytes, size_t *stride);

/* Decompresses the buffer views that EXT_meshopt_compression compresses: each becomes one of a buffer of its own.
 *   limit  its limit bounds the memory */
enum hatch_status expand_views(tinygltf::Model *model, const struct hatch_arena *limit, struct hatch_err *err);

/* Copies count numbers, which must be finite; if from is empty, to is unchanged.
 *   what  name of the property, for messages */
enum hatch_status copy_numbers(Reader &r, const std::vector<double> &from, size_t count, const std::string &where,
                               const char *what, double *to);
enum hatch_status copy_numbers(Reader &r, const std::vector<double> &from, size_t count, const std::string &where,
                               const char *what, float *to);

/* Normalises a node's rotation; fails when it is zero. */
enum hatch_status normalize_rotation(Reader &r, struct hatch_node *node, const std::string &where);

/* Finds the morph targets of all meshes, in time that is linear in the file. */
enum hatch_status find_morphs(Reader &r);

/* Keeps the name and the extras of an object of the file.
 *   extras  JSON as tinygltf prints it, without spaces; empty: none
 *   own     the member of extras that the writer adds itself and that is not kept; NULL: none */
enum hatch_status keep(Reader &r, const std::string &name, const std::string &extras, const char *own,
                       struct hatch_kept *kept);
template <class Object> enum hatch_status keep(Reader &r, const Object &from, const char *own, struct hatch_kept *kept)
{
    return keep(r, from.name, from.extras_json_string, own, kept);
}

/* Keeps the members of a material that are for writing alone. */
enum hatch_status keep_members(Reader &r, const tinygltf::Material &from, const std::string &where,
                               struct hatch_material *material);

/* Notes the parts of the file that are neither in the scene nor kept by it, except for meshes and vertices. */
void note_lost(Reader &r);

/* Returns the reference to a texture that a member of an extension is. */
tinygltf::TextureInfo info_of(const tinygltf::Value &texture);
/* Reads the use of a texture. If the image is missing, use->texture is HATCH_NONE.
 *   drawn  whether pictures show it; the notes then count a missing image */
enum hatch_status read_use(Reader &r, const tinygltf::TextureInfo &info, const std::string &where, bool drawn,
                           struct hatch_texture_use *use);

/* Applies the morph targets at rest to positions and normals, and keeps the targets in the mesh if a node or an
 * animation gives them other weights.
 *   index  of the glTF mesh */
enum hatch_status read_morph(Reader &r, const tinygltf::Primitive &primitive, size_t index, const std::string &where,
                             struct hatch_mesh *mesh);

/* Adds the normals of faces that targets move, to a mesh without normals. */
enum hatch_status add_moving_normals(Reader &r, size_t index, struct hatch_mesh *mesh);

/* Set the weights of a node, and convert those of an animation channel; both are then relative to the mesh's weights at
 * rest. */
enum hatch_status set_weights(Reader &r, size_t index, struct hatch_node *node);
enum hatch_status shift_weights(Reader &r, size_t node, const std::string &where,
                                struct hatch_animation_channel *channel);

/* Returns whether a primitive holds strokes. */
bool is_strokes(const tinygltf::Primitive &primitive);

/* Reads the primitives of a glTF mesh that hold the strokes of one of its surfaces.
 *   first    the first of them in the list; the surface comes before it
 *   surface  in, out: the strokes are added */
enum hatch_status read_strokes(Reader &r, const std::vector<tinygltf::Primitive> &list, size_t mesh, size_t first,
                               struct hatch_scene_mesh *surface);

/* Reads the attributes of a primitive.
 *   mesh   in, out: without attributes
 *   range  of the vertices that are read; NULL: all */
enum hatch_status read_attributes(Reader &r, const tinygltf::Primitive &primitive, const std::string &where,
                                  struct hatch_mesh *mesh, const Range *range = nullptr);

/* Each of these fills a part of the scene. read_all calls them in the order that they need. */
enum hatch_status read_nodes(Reader &r);
enum hatch_status read_meshes(Reader &r, uint32_t **first_mesh);
enum hatch_status attach_to_nodes(Reader &r, const uint32_t *first_mesh);
enum hatch_status add_instances(Reader &r);
enum hatch_status read_materials(Reader &r);
enum hatch_status read_images(Reader &r);
enum hatch_status read_cameras(Reader &r);
enum hatch_status read_lights(Reader &r);
enum hatch_status read_skins(Reader &r);
enum hatch_status read_animations(Reader &r);

} // namespace hatch

#endif
