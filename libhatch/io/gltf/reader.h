/* Private to the glTF reader (C++): what its files share. */
#ifndef HATCH_IO_GLTF_READER_H
#define HATCH_IO_GLTF_READER_H

#include <string>

#include <tiny_gltf.h>

/* C may give a struct and a function one name (hatch_arena_mark); C++ sees a hidden constructor. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
extern "C" {
#include "io/gltf/gltf.h"
#include "io/gltf/check.h"
}
#pragma GCC diagnostic pop

namespace hatch
{

struct Reader {
    const tinygltf::Model &model;
    struct hatch_arena *arena, *scratch;
    struct hatch_scene *scene;
    struct hatch_mesh_notes *notes;
    struct hatch_err *err;
    uint32_t *node_of = nullptr;  /* per glTF node: the scene's node, or HATCH_NONE */
    bool *image_missed = nullptr; /* per image: a material wants it, it is not there, and that is noted */
};

/* "mesh 3, primitive 0": where a sentence about the file points. */
std::string place(const char *what, size_t index);
std::string place(const char *what, size_t index, const char *part, size_t part_index);

/* Fails with HATCH_BAD_INPUT: "where: what". */
enum hatch_status bad(Reader &r, const std::string &where, const std::string &what);

/* -1 stands for nothing; else fails unless 0 <= index < count. */
enum hatch_status check_index(Reader &r, int index, size_t count, const std::string &where, const char *what);

/* Reads an accessor as floats, count * components of them, in the arena; integers are widened, or
 * divided by their type's range where the accessor is normalised. Sparse values are laid over it.
 * Every number is checked to be finite. */
enum hatch_status read_floats(Reader &r, int accessor, int components, const std::string &where, float **data,
                              uint32_t *count);

/* Reads an accessor of unsigned integers; those of a type's largest value are refused (primitive
 * restart, which glTF does not have). In scratch. */
enum hatch_status read_indices(Reader &r, int accessor, const std::string &where, uint32_t **data, uint32_t *count);

/* The bytes that a buffer view covers, checked against its buffer. */
enum hatch_status find_view(Reader &r, int view, const std::string &where, struct hatch_bytes *bytes, size_t *stride);

/* Copies numbers of the file, each finite once it is a float; where the file has none, to stays. */
enum hatch_status copy_numbers(Reader &r, const std::vector<double> &from, size_t count, const std::string &where,
                               const char *what, float *to);

/* Brings a node's rotation to length 1; one of no length is refused. */
enum hatch_status set_rotation(Reader &r, struct hatch_node *node, const std::string &where);

/* How far each morph target of a mesh counts at rest: a node may say it for its mesh; and for a node that draws one. */
const std::vector<double> &rest_weights(const Reader &r, size_t mesh);
const std::vector<double> &node_weights(const Reader &r, size_t node);

/* Moves positions and normals as the targets do at rest, and keeps the targets where something moves them. index: of
 * the file's mesh. */
enum hatch_status read_morph(Reader &r, const tinygltf::Primitive &primitive, size_t index, const std::string &where,
                             struct hatch_mesh *mesh);

/* A node's weights beside those of its mesh at rest; and an animation's, which are read. */
enum hatch_status set_weights(Reader &r, size_t index, struct hatch_node *node);
enum hatch_status shift_weights(Reader &r, size_t node, const std::string &where,
                                struct hatch_animation_channel *channel);

/* Each fills its part of the scene. Nodes come first. */
enum hatch_status read_nodes(Reader &r);
enum hatch_status read_meshes(Reader &r, uint32_t **first_mesh);
enum hatch_status attach(Reader &r, const uint32_t *first_mesh);
enum hatch_status add_instances(Reader &r);
enum hatch_status read_materials(Reader &r);
enum hatch_status read_images(Reader &r);
enum hatch_status read_cameras(Reader &r);
enum hatch_status read_lights(Reader &r);
enum hatch_status read_skins(Reader &r);
enum hatch_status read_animations(Reader &r);

} // namespace hatch

#endif
