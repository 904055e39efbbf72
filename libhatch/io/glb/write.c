#include <assert.h>

#include "io/glb/container.h"
#include "io/glb/parts.h"

static enum hatch_status print_asset(struct hatch_glb *glb, const char *comment)
{
    const struct hatch_kept *kept = &glb->scene->asset;
    HATCH_TRY(hatch_glb_put(glb, "\"asset\":{\"version\":\"2.0\",\"generator\":\"hatch\""));
    if (kept->name)
        HATCH_TRY(hatch_glb_string(glb, "copyright", kept->name));
    if (!comment)
        return hatch_glb_close_kept(glb, kept);
    HATCH_TRY(hatch_glb_put(glb, ",\"extras\":{"));
    HATCH_TRY(hatch_glb_string(glb, "hatch", comment));
    HATCH_TRY(hatch_glb_close_extras(glb, kept));
    return hatch_glb_put(glb, "}");
}

static enum hatch_status print_json(struct hatch_glb *glb, const char *comment)
{
    struct hatch_buffer *json = &glb->json;
    HATCH_TRY(hatch_glb_put(glb, "{"));
    HATCH_TRY(print_asset(glb, comment));
    HATCH_TRY(hatch_glb_print_nodes(glb));
    HATCH_TRY(hatch_glb_print_meshes(glb));
    HATCH_TRY(hatch_glb_print_looks(glb));
    HATCH_TRY(hatch_glb_print_motion(glb));
    HATCH_TRY(hatch_glb_print_views(glb));
    HATCH_TRY(hatch_buffer_print(json, glb->err, "}"));
    while (json->size % 4)
        HATCH_TRY(hatch_buffer_add(json, " ", 1, glb->err));
    return HATCH_OK;
}

static enum hatch_status write_chunks(const struct hatch_glb *glb, struct hatch_buffer *file)
{
    struct hatch_bytes json = {glb->json.data, glb->json.size};
    HATCH_TRY(hatch_glb_add_container(json, glb->size, file, glb->err));
    if (glb->size > 0)
        hatch_glb_put_views(glb, file->data + file->size - glb->size);
    return HATCH_OK;
}

enum hatch_status hatch_glb_write_scene(const struct hatch_scene *scene, const char *comment,
                                        struct hatch_arena *scratch, struct hatch_buffer *file, struct hatch_err *err)
{
    assert(file->arena != scratch);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_glb glb = {.scene = scene, .scratch = scratch, .err = err, .json = {.arena = scratch}};
    enum hatch_status status = hatch_glb_plan(&glb);
    if (status == HATCH_OK)
        status = print_json(&glb, comment);
    if (status == HATCH_OK)
        status = write_chunks(&glb, file);
    hatch_arena_rewind(scratch, mark);
    return status;
}

enum hatch_status hatch_glb_write(const struct hatch_mesh *mesh, const char *name, const char *comment,
                                  struct hatch_arena *scratch, struct hatch_buffer *file, struct hatch_err *err)
{
    assert(mesh->face_count > 0 && mesh->vertex_count > 0);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_scene scene;
    enum hatch_status status = hatch_scene_of_mesh(mesh, scratch, &scene, err);
    if (status == HATCH_OK) {
        scene.nodes[0].kept.name = scene.meshes[0].whole.name = name;
        status = hatch_glb_write_scene(&scene, comment, scratch, file, err);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
