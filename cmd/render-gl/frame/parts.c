#include "render-gl/frame/parts.h"

#include <math.h>

#include "render-gl/gpu/bindings.h"

void frame_use_item(const struct scene *scene, uint32_t index, float lightness, const struct gpu_program *program)
{
    const struct scene_item *item = &scene->items[index];
    const struct hatch_item *unit = &scene->unit.items[index];
    float axes[9];
    glUseProgram(program->name);
    if (item->base_texture)
        glBindTextureUnit(UNIT_BASE, item->base_texture);
    if (item->normals)
        glBindTextureUnit(UNIT_NORMALS, item->normals);
    const struct hatch_item_rest rest = hatch_item_rest(&scene->unit, index);
    glUniform1ui(UNIFORM_ITEM, index);
    glUniform1ui(UNIFORM_MATERIAL, scene->unit.scene->meshes[unit->mesh].material);
    glUniform4f(UNIFORM_REST, (float)rest.offset[0], (float)rest.offset[1], (float)rest.offset[2],
                (float)(1 / rest.unit));
    for (int k = 0; k < 9; k++)
        axes[k] = (float)rest.axes[k / 3][k % 3];
    glUniformMatrix3fv(UNIFORM_REST_AXES, 1, GL_TRUE, axes);
    glUniform1f(UNIFORM_REST_LOG, (float)log2(rest.scale));
    glUniform1f(UNIFORM_NORMAL_STRENGTH, item->normals_strength);
    glUniformMatrix4fv(UNIFORM_UNIT_FROM_MESH, 1, GL_FALSE, unit->to_unit);
    glUniformMatrix3fv(UNIFORM_NORMAL_FROM_MESH, 1, GL_FALSE, unit->normal);
    glVertexAttrib2fv(ATTRIBUTE_REPEAT, unit->repeat); /* where vertices have none */
    glUniform4f(UNIFORM_BASE, lightness, item->base_lod, unit->alpha_cutoff, 0.0f);
    glFrontFace(unit->mirrored ? GL_CW : GL_CCW);
}

void frame_part_draw(struct frame_part part)
{
    glBindVertexArray(part.vertex_array);
    if (part.pieces)
        glDrawArrays(GL_TRIANGLES, part.cut->first, part.cut->count);
    else if (part.cut)
        glMultiDrawElements(GL_TRIANGLES, part.cut->counts, GL_UNSIGNED_INT, part.cut->offsets,
                            (GLsizei)part.cut->range_count);
    else
        glDrawElements(GL_TRIANGLES, (GLsizei)part.count, GL_UNSIGNED_INT,
                       (const void *)(sizeof(uint32_t) * part.first));
}

struct frame_part frame_part_of_surface(const struct scene *scene, uint32_t index, const struct hatch_near_item *near)
{
    const struct hatch_unit_mesh *mesh = &scene->unit.meshes[scene->unit.items[index].mesh];
    const struct scene_item *item = &scene->items[index];
    return (struct frame_part){.vertex_array = mesh->patches ? item->surface_array : item->vertex_array,
                               .count = 3 * mesh->surface->face_count,
                               .cut = near ? &near->surface : NULL};
}
