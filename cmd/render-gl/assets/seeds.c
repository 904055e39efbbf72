#include "render-gl/assets/seeds.h"

#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "seed/pack.h"

static enum hatch_status upload(const struct hatch_rptam_packed *packed, struct seeds *seeds, struct hatch_err *err)
{
    const struct {
        const void *data;
        size_t size_bytes;
        GLenum format;
    } views[SEEDS_VIEWS] = {{packed->strokes, 4 * packed->stroke_count, GL_RGBA8},
                            {packed->seeds, 4 * sizeof *packed->seeds * packed->seed_count, GL_RGBA32UI},
                            {packed->lists, 2 * sizeof *packed->lists * packed->list_count, GL_RG32I},
                            {packed->progress, sizeof packed->progress, GL_RG32F},
                            {packed->seed_numbers, sizeof *packed->seed_numbers * packed->seed_count, GL_R32UI}};
    size_t texels = packed->seed_count > packed->list_count ? packed->seed_count : packed->list_count;
    HATCH_TRY(gpu_check_texels(texels, "overlapping strokes", err));
    seeds->layers = gpu_buffer_make(&packed->block, sizeof packed->block);
    for (int i = 0; i < SEEDS_VIEWS; i++) {
        seeds->buffers[i] = gpu_buffer_make(views[i].data, views[i].size_bytes);
        seeds->views[i] = gpu_texture_of_buffer(views[i].format, seeds->buffers[i]);
    }
    return gpu_check_memory(err, "the coverage lists");
}

enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct seeds *seeds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct hatch_rptam_packed packed;
    struct seeds made = {.shrink = rptam->style.fade_size};
    enum hatch_status status = hatch_rptam_pack(rptam, all, scratch, &packed, err);
    if (status == HATCH_OK)
        status = upload(&packed, &made, err);
    made.vary = status == HATCH_OK && packed.varied;
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *seeds = made;
    else
        seeds_free(&made);
    return status;
}

void seeds_use(const struct seeds *seeds)
{
    glBindBufferBase(GL_UNIFORM_BUFFER, BLOCK_TECHNIQUE, seeds->layers);
    for (GLuint i = 0; i < SEEDS_VIEWS; i++)
        glBindTextureUnit(UNIT_TECHNIQUE + i, seeds->views[i]);
}

void seeds_free(struct seeds *seeds)
{
    glDeleteTextures(SEEDS_VIEWS, seeds->views);
    glDeleteBuffers(SEEDS_VIEWS, seeds->buffers);
    glDeleteBuffers(1, &seeds->layers);
    *seeds = (struct seeds){.layers = 0};
}
