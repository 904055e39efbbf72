#include "render-gl/seeds.h"

#include <string.h>

/* std140, as in shaders/seeds.glsl */
struct layer_block {
    float turn[4];       /* cosine, sine of the strokes' direction; offset of their ranks */
    int32_t at[4];       /* seeds, the first of them, the first of its lists, texels along a side */
    float darkness[20];  /* HATCH_RPTAM_STEPS */
};

struct seeds_block {
    float stroke[4];     /* length, width in pixels, ink, side of the tile in pixels */
    float fade[4];       /* overlap with depth, with tone; law, size */
    int32_t counts[4];   /* layers, whether all seeds are looked at */
    struct layer_block layers[HATCH_RPTAM_LAYERS_MAX];
};

/* Four floats a seed: u, v, the tone's rank, four times the number and the tile that it stays in. First all
 * of a layer, then the lists one after the other, so that the shader finds a list's seeds by one read each. */
static void put_seed(const struct hatch_rptam_layer *layer, uint32_t seed, float to[4])
{
    to[0] = (float)((double)layer->places[seed].u * 0x1p-64);
    to[1] = (float)((double)layer->places[seed].v * 0x1p-64);
    to[2] = (float)layer->tone_rank[seed];
    to[3] = (float)(4 * seed + layer->stays_in[seed]);
}

/* What the buffers hold, and how much of it there is. */
struct packed {
    struct seeds_block block;
    float *seeds;
    int32_t *lists; /* two a texel */
    size_t seed_count, list_count;
};

static void pack_layer(const struct hatch_rptam_layer *layer, struct packed *packed, struct layer_block *to)
{
    const float *own = packed->seeds + 4 * packed->seed_count;
    const struct hatch_coverage *coverage = &layer->coverage;
    size_t texels = (size_t)coverage->side * coverage->side;
    *to = (struct layer_block){
        .turn = {(float)layer->cosine, (float)layer->sine, (float)layer->rank_offset},
        .at = {(int32_t)layer->count, (int32_t)packed->seed_count, (int32_t)packed->list_count,
               (int32_t)coverage->side}};
    for (uint32_t step = 0; step < HATCH_RPTAM_STEPS; step++)
        to->darkness[step] = (float)layer->darkness[step];
    for (uint32_t k = 0; k < layer->count; k++)
        put_seed(layer, k, packed->seeds + 4 * packed->seed_count++);
    for (size_t t = 0; t < texels; t++) {
        packed->lists[2 * packed->list_count] = (int32_t)packed->seed_count;
        for (uint32_t i = coverage->first[t]; i < coverage->first[t + 1]; i++)
            memcpy(packed->seeds + 4 * packed->seed_count++, own + 4 * (size_t)coverage->ids[i], 4 * sizeof *own);
        packed->lists[2 * packed->list_count++ + 1] = (int32_t)packed->seed_count;
    }
}

static enum hatch_status pack(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                              struct packed *packed, struct hatch_err *err)
{
    const struct hatch_rptam_style *style = &rptam->style;
    size_t seeds = 0, lists = 0;
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_coverage *coverage = &rptam->layers[i].coverage;
        size_t texels = (size_t)coverage->side * coverage->side;
        lists += texels;
        seeds += rptam->layers[i].count + coverage->first[texels];
    }
    *packed = (struct packed){
        .block = {.stroke = {(float)style->length_px, (float)style->width_px, (float)style->ink,
                             (float)style->tile_px},
                  .fade = {(float)style->overlap, (float)style->tone_overlap, style->law == HATCH_FADE_PAPER,
                           style->fade_size},
                  .counts = {(int32_t)rptam->layer_count, all}}};
    packed->seeds = HATCH_NEW(scratch, float, 4 * seeds, err);
    packed->lists = packed->seeds ? HATCH_NEW(scratch, int32_t, 2 * lists, err) : NULL;
    if (!packed->lists)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < rptam->layer_count; i++)
        pack_layer(&rptam->layers[i], packed, &packed->block.layers[i]);
    return HATCH_OK;
}

static GLuint make_buffer(const void *data, size_t size)
{
    GLuint buffer;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, (GLsizeiptr)size, data, 0);
    return buffer;
}

static GLuint make_stroke(const struct hatch_image *image)
{
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_R32F, (GLsizei)image->width, (GLsizei)image->height);
    glTextureSubImage2D(texture, 0, 0, 0, (GLsizei)image->width, (GLsizei)image->height, GL_RED, GL_FLOAT,
                        image->pixels);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

/* A buffer that shaders read as a texture. */
static GLuint make_view(GLuint buffer, GLenum format)
{
    GLuint texture;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    glTextureBuffer(texture, format, buffer);
    return texture;
}

enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct gpu_seeds *seeds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct packed packed;
    GLint most;
    enum hatch_status status = pack(rptam, all, scratch, &packed, err);
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (status == HATCH_OK && packed.seed_count > (size_t)most)
        status = hatch_fail(err, HATCH_LIMIT, "the lists of strokes are too long for the GPU: %zu of %d",
                            packed.seed_count, most);
    if (status == HATCH_OK) {
        *seeds = (struct gpu_seeds){
            .layers = make_buffer(&packed.block, sizeof packed.block),
            .seeds = make_buffer(packed.seeds, 4 * sizeof *packed.seeds * packed.seed_count),
            .lists = make_buffer(packed.lists, 2 * sizeof *packed.lists * packed.list_count),
            .stroke = make_stroke(&rptam->stroke)};
        seeds->seeds_view = make_view(seeds->seeds, GL_RGBA32F);
        seeds->lists_view = make_view(seeds->lists, GL_RG32I);
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}

void seeds_bind(const struct gpu_seeds *seeds)
{
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, seeds->layers);
    glBindTextureUnit(4, seeds->stroke);
    glBindTextureUnit(5, seeds->seeds_view);
    glBindTextureUnit(6, seeds->lists_view);
}

void seeds_free(struct gpu_seeds *seeds)
{
    glDeleteTextures(1, &seeds->seeds_view);
    glDeleteTextures(1, &seeds->lists_view);
    glDeleteTextures(1, &seeds->stroke);
    glDeleteBuffers(1, &seeds->layers);
    glDeleteBuffers(1, &seeds->seeds);
    glDeleteBuffers(1, &seeds->lists);
    *seeds = (struct gpu_seeds){0};
}
