#include "render-gl/seeds.h"

#include <string.h>

/* std430, as in shaders/seeds.glsl */
struct layer_block {
    float turn[4];       /* cosine, sine of the strokes' direction; offset of their ranks */
    uint32_t at[4];      /* seeds, the first of them, the first of its lists, texels along a side */
    float darkness[20];  /* HATCH_RPTAM_STEPS */
};

struct seeds_block {
    float stroke[4];     /* length, width in pixels, ink, side of the tile in pixels */
    float fade[4];       /* overlap with depth, with tone; law, size */
    uint32_t counts[4];  /* layers, whether all seeds are looked at */
    struct layer_block layers[HATCH_RPTAM_LAYERS_MAX];
};

static void fill_block(const struct hatch_rptam *rptam, bool all, struct seeds_block *block)
{
    const struct hatch_rptam_style *style = &rptam->style;
    uint32_t seed = 0, list = 0;
    *block = (struct seeds_block){
        .stroke = {(float)style->length_px, (float)style->width_px, (float)style->ink, (float)style->tile_px},
        .fade = {(float)style->overlap, (float)style->tone_overlap, style->law == HATCH_FADE_PAPER,
                 style->fade_size},
        .counts = {rptam->layer_count, all}};
    for (uint32_t i = 0; i < rptam->layer_count; i++) {
        const struct hatch_rptam_layer *layer = &rptam->layers[i];
        uint32_t side = layer->coverage.side, texels = side * side;
        struct layer_block *to = &block->layers[i];
        *to = (struct layer_block){.turn = {(float)layer->cosine, (float)layer->sine,
                                            (float)layer->rank_offset},
                                   .at = {layer->count, seed, list, side}};
        for (uint32_t step = 0; step < HATCH_RPTAM_STEPS; step++)
            to->darkness[step] = (float)layer->darkness[step];
        seed += layer->count;
        list += texels + 1 + layer->coverage.first[texels];
    }
}

/* Per seed: u, v, the tone's rank, the tile that it stays in. */
static float *pack_seeds(const struct hatch_rptam *rptam, uint32_t count, struct hatch_arena *scratch,
                         struct hatch_err *err)
{
    float *packed = HATCH_NEW(scratch, float, 4 * (size_t)count, err), *next = packed;
    for (uint32_t i = 0; packed && i < rptam->layer_count; i++)
        for (uint32_t k = 0; k < rptam->layers[i].count; k++, next += 4) {
            const struct hatch_rptam_layer *layer = &rptam->layers[i];
            next[0] = (float)((double)layer->places[k].u * 0x1p-64);
            next[1] = (float)((double)layer->places[k].v * 0x1p-64);
            next[2] = (float)hatch_rptam_tone_rank(k, layer->count);
            next[3] = layer->stays_in[k];
        }
    return packed;
}

/* Per layer: where each texel's list begins, counted from the first list, then the lists. */
static uint32_t *pack_lists(const struct hatch_rptam *rptam, size_t count, struct hatch_arena *scratch,
                            struct hatch_err *err)
{
    uint32_t *packed = HATCH_NEW(scratch, uint32_t, count, err), *next = packed;
    for (uint32_t i = 0; packed && i < rptam->layer_count; i++) {
        const struct hatch_coverage *coverage = &rptam->layers[i].coverage;
        size_t texels = (size_t)coverage->side * coverage->side;
        memcpy(next, coverage->first, (texels + 1) * sizeof *next);
        next += texels + 1;
        memcpy(next, coverage->ids, coverage->first[texels] * sizeof *next);
        next += coverage->first[texels];
    }
    return packed;
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

enum hatch_status seeds_upload(const struct hatch_rptam *rptam, bool all, struct hatch_arena *scratch,
                               struct gpu_seeds *seeds, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct seeds_block block;
    fill_block(rptam, all, &block);
    const struct layer_block *last = &block.layers[rptam->layer_count - 1];
    const struct hatch_coverage *coverage = &rptam->layers[rptam->layer_count - 1].coverage;
    size_t texels = (size_t)coverage->side * coverage->side;
    uint32_t seed_count = last->at[1] + last->at[0];
    size_t list_count = last->at[2] + texels + 1 + coverage->first[texels];
    float *packed = pack_seeds(rptam, seed_count, scratch, err);
    uint32_t *lists = packed ? pack_lists(rptam, list_count, scratch, err) : NULL;
    if (lists)
        *seeds = (struct gpu_seeds){.layers = make_buffer(&block, sizeof block),
                                    .seeds = make_buffer(packed, 4 * sizeof *packed * seed_count),
                                    .lists = make_buffer(lists, sizeof *lists * list_count),
                                    .stroke = make_stroke(&rptam->stroke)};
    hatch_arena_rewind(scratch, mark);
    return lists ? HATCH_OK : HATCH_LIMIT;
}

void seeds_bind(const struct gpu_seeds *seeds)
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, seeds->layers);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, seeds->seeds);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, seeds->lists);
    glBindTextureUnit(4, seeds->stroke);
}

void seeds_free(struct gpu_seeds *seeds)
{
    glDeleteBuffers(1, &seeds->layers);
    glDeleteBuffers(1, &seeds->seeds);
    glDeleteBuffers(1, &seeds->lists);
    glDeleteTextures(1, &seeds->stroke);
    *seeds = (struct gpu_seeds){0};
}
