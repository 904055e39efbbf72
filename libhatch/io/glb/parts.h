/* What the files of the GLB writer share. */
#ifndef HATCH_IO_GLB_PARTS_H
#define HATCH_IO_GLB_PARTS_H

#include "io/glb/glb.h"

enum hatch_glb_component { HATCH_GLB_U8 = 5121, HATCH_GLB_U16 = 5123, HATCH_GLB_U32 = 5125, HATCH_GLB_F32 = 5126 };
enum hatch_glb_target { HATCH_GLB_OTHER = 0, HATCH_GLB_VERTICES = 34962, HATCH_GLB_INDICES = 34963 };

/* A buffer view, and but for images the one accessor that reads it. */
struct hatch_glb_view {
    enum hatch_glb_component component; /* in the file */
    enum hatch_glb_target target;
    const void *data;    /* floats; uint32_t for indices; bytes for images */
    size_t count;        /* of elements; of bytes for images */
    uint32_t components; /* 1 .. 4, 16 for a matrix */
    bool bounds;         /* the format wants the least and the largest of each component */
    size_t offset, size; /* bytes in the buffer */
};

/* A file in the making. The accessors' numbers are those of their views; images' views come last. */
struct hatch_glb {
    const struct hatch_scene *scene;
    const char *name; /* of the first node and mesh; may be NULL */
    struct hatch_arena *scratch;
    struct hatch_err *err;
    struct hatch_buffer json;
    struct hatch_glb_view *views;
    uint32_t view_count, accessor_count;
    size_t size;            /* of the buffer */
    uint32_t *group_size;   /* per scene mesh: how many make one mesh of the file from here; 0 inside of one */
    uint32_t *group;        /* per scene mesh: the file's mesh that begins there, or HATCH_NONE */
    uint32_t *mesh_first;   /* per scene mesh: the accessor of its POSITION, or HATCH_NONE: it has no faces */
    uint32_t *skin;         /* per skin: its number in the file, or HATCH_NONE: it has no joints */
    uint32_t skin_first;    /* the accessor of the first one's matrices */
    uint32_t channel_first; /* the accessor of the first animation's first times */
    uint32_t *image;        /* per texture: the file's image, or HATCH_NONE: no PNG and no JPEG */
    uint32_t *texture;      /* HATCH_GLB_WRAPS per texture: the file's texture and sampler, or HATCH_NONE */
};

#define HATCH_GLB_WRAPS 9u /* ways to wrap in u and in v */

#define HATCH_GLB_USES 2u /* a material's textures: of its colour, of its normals */

/* What a material reads of its texture, below HATCH_GLB_USES, or NULL: it has none that can be written. */
const struct hatch_texture_use *hatch_glb_use(const struct hatch_glb *glb, const struct hatch_material *material,
                                              uint32_t number);

/* The number in the file of a texture that is used. */
static inline uint32_t *hatch_glb_texture(struct hatch_glb *glb, const struct hatch_texture_use *use)
{
    return &glb->texture[HATCH_GLB_WRAPS * use->texture + 3u * use->wrap[0] + use->wrap[1]];
}

/* The order in which a mesh's attributes are written, and read: POSITION, the others by their names; so that
 * a copy has the bytes of what it copies. Morph targets are no attributes of the file. Returns how many are. */
uint32_t hatch_glb_order(const struct hatch_mesh *mesh, uint32_t order[HATCH_MESH_ATTRIBUTES_MAX]);

/* JSON: a comma is written before all but the first of a list. */
enum hatch_status hatch_glb_next(struct hatch_glb *glb);
enum hatch_status hatch_glb_put(struct hatch_glb *glb, const char *json); /* as it stands */
enum hatch_status hatch_glb_open(struct hatch_glb *glb, const char *key); /* key and bracket */
enum hatch_status hatch_glb_key(struct hatch_glb *glb, const char *key);
/* A string; what is not plain ASCII becomes a question mark. */
enum hatch_status hatch_glb_text(struct hatch_glb *glb, const char *text);
/* A key that a file made up: UTF-8, escaped where JSON wants it, and a colon. */
enum hatch_status hatch_glb_name(struct hatch_glb *glb, const char *name);
/* Key and number; nine digits, which name a float exactly. */
enum hatch_status hatch_glb_number(struct hatch_glb *glb, const char *key, float value);
enum hatch_status hatch_glb_index(struct hatch_glb *glb, const char *key, uint32_t value);
enum hatch_status hatch_glb_numbers(struct hatch_glb *glb, const char *key, const float *values, uint32_t count);

/* Lays out the buffer and gives everything its number; needs scene, scratch and err. */
enum hatch_status hatch_glb_plan(struct hatch_glb *glb);
/* The JSON of the buffer, its views and accessors. */
enum hatch_status hatch_glb_print_views(struct hatch_glb *glb);
/* Fills the buffer's bytes. */
void hatch_glb_put_views(const struct hatch_glb *glb, uint8_t *at);

/* The JSON of all that stands in the scene. */
enum hatch_status hatch_glb_print_nodes(struct hatch_glb *glb);
enum hatch_status hatch_glb_print_meshes(struct hatch_glb *glb);
enum hatch_status hatch_glb_print_looks(struct hatch_glb *glb);  /* materials, textures, cameras, lights */
enum hatch_status hatch_glb_print_motion(struct hatch_glb *glb); /* skins, animations */

#endif
