/* Private to the GLB writer: types and functions that its files share. */
#ifndef HATCH_IO_GLB_PARTS_H
#define HATCH_IO_GLB_PARTS_H

#include "io/glb/glb.h"

enum hatch_glb_component {
    HATCH_GLB_I8 = 5120,
    HATCH_GLB_U8,
    HATCH_GLB_I16,
    HATCH_GLB_U16,
    HATCH_GLB_U32 = 5125,
    HATCH_GLB_F32
};
enum hatch_glb_target { HATCH_GLB_OTHER = 0, HATCH_GLB_VERTICES = 34962, HATCH_GLB_INDICES = 34963 };

/* A part of the buffer: an accessor, or an image. It has a buffer view of its own, or goes on in that of the part
 * before it. */
struct hatch_glb_view {
    enum hatch_glb_component component; /* type of the numbers in the file */
    enum hatch_glb_target target;
    const void *data;    /* array of floats; of uint32_t for indices; of bytes for images */
    size_t count;        /* number of elements; of bytes for images */
    uint32_t components; /* numbers per element: 1 .. 4, or 16 for a matrix */
    bool normalized;     /* integers stand for 0 .. 1 or, with a sign, for -1 .. 1 */
    bool bounds;         /* whether the format requires min and max */
    bool goes_on;        /* whether it is in the buffer view of the part before it; both have numbers of one type */
    size_t offset, size; /* bytes in the buffer */
};

/* A set of strokes or a part of one, written as a primitive of lines. */
struct hatch_glb_lines {
    struct hatch_curve_set part;
    struct hatch_mesh vertices; /* in scratch */
    uint32_t first, indices;    /* indices of the accessors of its POSITION and its indices */
};

/* A glTF texture with its sampler, which has the same index. */
struct hatch_glb_texture {
    const struct hatch_texture_use *use; /* the first of its uses */
    uint32_t next;                       /* index of the next one with the same image, or HATCH_NONE */
};

/* State of writing one file. An accessor has the same index as its part of the buffer; images, which have no accessors,
 * come last. */
struct hatch_glb {
    const struct hatch_scene *scene;
    struct hatch_arena *scratch;
    struct hatch_err *err;
    struct hatch_buffer json;
    struct hatch_glb_view *views;
    uint32_t view_count, accessor_count;
    uint32_t image_view;    /* index of the buffer view of the first image */
    size_t size;            /* size of the buffer in bytes */
    bool quantized;         /* whether an accessor needs KHR_mesh_quantization */
    uint32_t *group_size;   /* per scene mesh: how many meshes the glTF mesh that begins here holds; 0 inside one */
    uint32_t *group;        /* per scene mesh: index of the glTF mesh that begins here; HATCH_NONE without faces */
    uint32_t *mesh_first;   /* per scene mesh: index of the accessor of its POSITION; HATCH_NONE without faces */
    uint32_t *mesh_indices; /* per scene mesh with faces: index of the accessor of its indices */
    struct hatch_glb_lines **lines; /* per scene mesh: its strokes */
    uint32_t *line_count;           /* per scene mesh: number of them */
    uint32_t *skin;                 /* per skin: index in the file; HATCH_NONE without joints */
    uint32_t skin_first;            /* index of the accessor of the first skin's matrices */
    uint32_t channel_first;         /* index of the accessor of the first animation channel's times */
    uint32_t *image;         /* per texture: index of its image in the file; HATCH_NONE if of no kind that is written */
    uint32_t *image_texture; /* per texture: index of the first glTF texture that has its image, or HATCH_NONE */
    struct hatch_glb_texture *textures; /* of the file */
    uint32_t texture_count;
};

/* Returns the number of slots for textures that a material has: base colour, normals, those of its kept members. */
uint32_t hatch_glb_slot_count(const struct hatch_material *material);

#define HATCH_GLB_WEBP "webp"

/* Returns the kind of an image, as its media type ends: "png", "jpeg" or HATCH_GLB_WEBP, which needs EXT_texture_webp;
 * NULL for kinds that are not written. */
const char *hatch_glb_image_kind(const struct hatch_texture *texture);

/* Returns the use of a material's texture in a slot, 0 .. hatch_glb_slot_count - 1, or NULL when there is no texture
 * that can be written. */
const struct hatch_texture_use *hatch_glb_slot(const struct hatch_glb *glb, const struct hatch_material *material,
                                               uint32_t slot);

/* Returns whether a kept member of a material is written: all textures that it has are. */
bool hatch_glb_has_member(const struct hatch_glb *glb, const struct hatch_kept_member *member);

/* Returns the index in the file of the texture of a use; HATCH_NONE if there is none yet. */
uint32_t hatch_glb_find_texture(const struct hatch_glb *glb, const struct hatch_texture_use *use);

/* Lists a mesh's attributes in the order in which they are written and read: POSITION first, then the others by name. A
 * copy of a file is therefore identical to it. Leaves out morph targets. Returns the number of attributes listed. */
uint32_t hatch_glb_order(const struct hatch_mesh *mesh, uint32_t order[HATCH_MESH_ATTRIBUTES_MAX]);

/* The functions below append JSON. Those with a key, and hatch_glb_comma, first write a comma, except at the start of
 * an object or array. */
enum hatch_status hatch_glb_comma(struct hatch_glb *glb);
enum hatch_status hatch_glb_put(struct hatch_glb *glb, const char *json);       /* json as it is */
enum hatch_status hatch_glb_open_array(struct hatch_glb *glb, const char *key); /* key and bracket */
enum hatch_status hatch_glb_key(struct hatch_glb *glb, const char *key);        /* key and colon */
/* Appends key and colon; key is UTF-8 from a file and is escaped. */
enum hatch_status hatch_glb_escaped_key(struct hatch_glb *glb, const char *key);
/* Appends key and string, which is UTF-8 from a file and is escaped. */
enum hatch_status hatch_glb_string(struct hatch_glb *glb, const char *key, const char *value);
/* Append key and value; floats have nine significant digits, which identify them exactly. */
enum hatch_status hatch_glb_number(struct hatch_glb *glb, const char *key, float value);
enum hatch_status hatch_glb_integer(struct hatch_glb *glb, const char *key, uint32_t value);
enum hatch_status hatch_glb_numbers(struct hatch_glb *glb, const char *key, const float *values, uint32_t count);
/* Appends key and values, with as many significant digits as identify each, up to 17. */
enum hatch_status hatch_glb_doubles(struct hatch_glb *glb, const char *key, const double *values, uint32_t count);

/* Opens an object, with the name that is kept of it. */
enum hatch_status hatch_glb_open_named(struct hatch_glb *glb, const struct hatch_kept *kept);
/* Prints the extras that are kept of an object. */
enum hatch_status hatch_glb_print_extras(struct hatch_glb *glb, const struct hatch_kept *kept);
/* Closes an object, with the extras that are kept of it. */
enum hatch_status hatch_glb_close_kept(struct hatch_glb *glb, const struct hatch_kept *kept);
/* Closes extras to which the writer has added members: those that are kept follow, if they are members. */
enum hatch_status hatch_glb_close_extras(struct hatch_glb *glb, const struct hatch_kept *kept);

/* Lays out the buffer and assigns all indices; the members scene, scratch and err must be set. */
enum hatch_status hatch_glb_plan(struct hatch_glb *glb);
/* Adds the images as parts of the buffer, and numbers the textures in the order of the materials. */
enum hatch_status hatch_glb_plan_textures(struct hatch_glb *glb);
/* Adds a part of the buffer, and the parts of a mesh's attributes. */
void hatch_glb_add_view(struct hatch_glb *glb, struct hatch_glb_view view);
void hatch_glb_add_attributes(struct hatch_glb *glb, const struct hatch_mesh *mesh);
/* Sets the type of an attribute's numbers in the file: that of the format or, with scene->rounding, integers. */
void hatch_glb_choose_numbers(struct hatch_glb *glb, const struct hatch_mesh *mesh,
                              const struct hatch_mesh_attribute *attribute, struct hatch_glb_view *view);
/* Return the size of a number in the file, and of an element; elements of vertices begin at multiples of 4 bytes. */
size_t hatch_glb_number_bytes(enum hatch_glb_component component);
size_t hatch_glb_stride(const struct hatch_glb_view *view);
/* Writes the numbers of an accessor; padding stays as it is. */
void hatch_glb_put_numbers(const struct hatch_glb_view *view, uint8_t *at);
/* Returns how many scene meshes of a glTF mesh, from `first` on, can share the accessors of their vertices.
 *   end  one after the last of the glTF mesh */
uint32_t hatch_glb_count_shared(const struct hatch_glb *glb, uint32_t first, uint32_t end);
/* Adds scene meshes that share accessors. */
enum hatch_status hatch_glb_add_shared(struct hatch_glb *glb, uint32_t first, uint32_t count);
/* Writes the JSON of the buffer, its views and accessors. */
enum hatch_status hatch_glb_print_views(struct hatch_glb *glb);
/* Fills the buffer's glb->size bytes. */
void hatch_glb_put_views(const struct hatch_glb *glb, uint8_t *at);

/* Write the JSON of the scene. */
enum hatch_status hatch_glb_print_nodes(struct hatch_glb *glb);
enum hatch_status hatch_glb_print_meshes(struct hatch_glb *glb);
enum hatch_status hatch_glb_print_looks(struct hatch_glb *glb);  /* materials, textures, cameras, lights */
enum hatch_status hatch_glb_print_motion(struct hatch_glb *glb); /* skins, animations */

#endif
