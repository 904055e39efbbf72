#include "render-gl/assets/solid.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "image/color.h"
#include "render-gl/gpu/bindings.h"
#include "render-gl/gpu/buffer.h"
#include "render-gl/gpu/texture.h"
#include "shared/picture.h"
#include "shared/solid/solid.h"
#include "shared/style.h"
#include "solid/make.h"

#define STYLE_SIZE 64 /* texels along a side of the texture of a style */

static void read_picture(struct cmd_args *args, const char *path, struct hatch_bytes file, struct hatch_solid *solid)
{
    struct hatch_image image;
    struct hatch_err err;
    cmd_parse_picture(args, path, file, 1, &args->keep, &image); /* numbers that are not finite become paper */
    cmd_check(hatch_solid_of_image(&image, &args->keep, solid, &err), cmd_input_name(path), &err);
}

static void read_one(struct cmd_args *args, const char *path, struct hatch_solid *solid)
{
    struct hatch_bytes file = cmd_read(args, path);
    if (!cmd_parse_solid(args, cmd_input_name(path), file, solid))
        read_picture(args, path, file, solid);
}

/* Makes the texture of an installed style. */
static void make_style(struct cmd_args *args, const char *name, struct hatch_solid *solid)
{
    struct hatch_solid_style style = {.kind = HATCH_SOLID_NO_KIND};
    struct hatch_err err;
    const char *path = cmd_find_style(args, name, "solid");
    cmd_check(hatch_solid_style_parse(cmd_read(args, path), &style, &err), path, &err);
    const struct hatch_solid_options how = {.style = &style, .size = STYLE_SIZE, .seed = 1, .pool = cmd_pool(args)};
    cmd_check(hatch_solid_from_style(&how, &args->keep, &args->scratch, solid, &err), name, &err);
}

void solid_files_read(struct cmd_args *args, const char *paths, struct solid_files *files)
{
    struct hatch_err err;
    *files = (struct solid_files){.count = 0};
    for (const char *at = paths; at;) {
        const char *comma = strchr(at, ',');
        size_t length = comma ? (size_t)(comma - at) : strlen(at);
        if (files->count == SOLIDS_MAX)
            cmd_usage("--solid: more than %u files", SOLIDS_MAX);
        if (length == 0)
            cmd_usage("--solid %s: an empty name", paths);
        const char *path = hatch_arena_text(&args->keep, at, length, &err);
        cmd_check(path ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        struct hatch_solid *solid = &files->solids[files->count++];
        if (strpbrk(path, "/.") || strcmp(path, "-") == 0 || access(path, F_OK) == 0)
            read_one(args, path, solid);
        else
            make_style(args, path, solid);
        if (files->count > 1 && files->flat != (solid->depth == 1))
            cmd_usage("--solid: %s is %s, the others are not", path, solid->depth == 1 ? "flat" : "a solid texture");
        files->flat = solid->depth == 1;
        files->isotropic = (files->isotropic || files->count == 1) && solid->isotropic;
        at = comma ? comma + 1 : NULL;
    }
}

/* Computes the standard deviation and the mean of a texture's first value. */
static void set_deviation(const struct hatch_solid *solid, float *deviation, float *mean)
{
    size_t count = hatch_solid_count(solid);
    uint64_t sum = 0, squares = 0;
    for (size_t i = 0; i < count; i++) {
        uint64_t texel = solid->texels[i * solid->channels];
        sum += texel;
        squares += texel * texel;
    }
    double middle = (double)sum / (double)count;
    *mean = (float)(middle / 255);
    *deviation = (float)(sqrt(fmax((double)squares / (double)count - middle * middle, 1)) / 255);
}

static void set_colors(const struct hatch_zoom *zoom, struct solids *solids, uint32_t index)
{
    size_t count = hatch_solid_count(&zoom->base);
    float mean[3];
    for (size_t k = 0; k < 3; k++)
        mean[k] = solids->colors[index].offset[k] = zoom->offset[k];
    for (size_t c = 0; c < zoom->base.channels; c++) {
        uint64_t sum = 0;
        for (size_t i = 0; i < count; i++)
            sum += zoom->base.texels[i * zoom->base.channels + c];
        for (size_t k = 0; k < 3; k++) {
            float axis = zoom->base.channels == 1 ? 1.0f : zoom->axes[c][k]; /* grey has one axis, to white */
            solids->colors[index].axes[c][k] = axis;
            mean[k] += axis * (float)((double)sum / (255.0 * (double)count));
        }
    }
    solids->colors[index].offset[3] = zoom->base.channels == 1 ? mean[0] : hatch_color_luminance(mean);
    solids->colors[index].axes[0][3] = (float)log2(zoom->octaves.size);
    set_deviation(&zoom->octaves, &solids->colors[index].axes[1][3], &solids->colors[index].axes[2][3]);
}

/* Uploads the slices of each level in pairs: layer i of level l holds slices i and i + 1 of that level, of which the
 * first follows the last. Coarser levels leave layers unused. */
static enum hatch_status upload_pairs(const struct hatch_texels *mips, struct hatch_arena *scratch, GLuint *texture,
                                      struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    uint8_t *pairs = HATCH_NEW_UNSET(scratch, uint8_t, 2 * (size_t)mips->width * mips->width * mips->depth, err);
    if (!pairs)
        return HATCH_LIMIT;
    *texture = gpu_texture_make(GL_TEXTURE_2D_ARRAY, (GLsizei)mips->level_count, GL_RG8, mips->width, mips->height,
                                mips->depth);
    for (uint32_t level = 0; level < mips->level_count; level++) {
        uint32_t side = hatch_mip_size(mips->width, level), depth = hatch_mip_size(mips->depth, level);
        size_t slice = (size_t)side * side, count = slice * depth;
        for (size_t i = 0; i < count; i++) {
            pairs[2 * i] = mips->texels[level][i];
            pairs[2 * i + 1] = mips->texels[level][(i + slice) % count];
        }
        glTextureSubImage3D(*texture, (GLint)level, 0, 0, 0, (GLsizei)side, (GLsizei)side, (GLsizei)depth, GL_RG,
                            GL_UNSIGNED_BYTE, pairs);
    }
    glTextureParameteri(*texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}

static void upload_octaves(const struct hatch_texels *mips, GLuint *texture)
{
    GLenum layout = mips->channels == 1 ? GL_RED : GL_RGB;
    *texture = gpu_texture_make(GL_TEXTURE_3D, (GLsizei)mips->level_count, mips->channels == 1 ? GL_R8 : GL_RGBA8,
                                mips->width, mips->height, mips->depth);
    for (uint32_t level = 0; level < mips->level_count; level++) {
        GLsizei side = (GLsizei)hatch_mip_size(mips->width, level);
        glTextureSubImage3D(*texture, (GLint)level, 0, 0, 0, side, side, (GLsizei)hatch_mip_size(mips->depth, level),
                            layout, GL_UNSIGNED_BYTE, mips->texels[level]);
    }
    glTextureParameteri(*texture, GL_TEXTURE_WRAP_R, GL_REPEAT);
    glTextureParameteri(*texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

/* Makes the texture A of a solid texture and its table, and uploads them.
 *   arena, scratch  two arenas */
static enum hatch_status upload_one(const struct solid_files *files, uint32_t index, const struct solids_form *form,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct solids *solids, struct hatch_err *err)
{
    const struct hatch_solid *solid = &files->solids[index];
    struct hatch_zoom zoom;
    struct hatch_zoom_table table;
    struct hatch_texels mips;
    uint32_t size =
        HATCH_SOLID_SIZE_MIN; /* until its texels are no larger than pixels, or those of the finest octave */
    while (size < 0.75 * form->period_px && size < 4 * solid->size && size < HATCH_SOLID_SIZE_MAX)
        size *= 2;
    HATCH_TRY(hatch_zoom_make(solid, size, form->grey, form->blend, pool, arena, scratch, &zoom, err));
    HATCH_TRY(hatch_zoom_mips(&zoom, form->blend, arena, &mips, err));
    HATCH_TRY(hatch_zoom_table_make(&zoom, &mips, form->blend, log2(size / (form->period_px * form->samples)), arena,
                                    scratch, &table, err));
    set_colors(&zoom, solids, index);
    solids->size = size > solids->size ? size : solids->size;
    if (form->pairs && solids->channels == 1)
        HATCH_TRY(upload_pairs(&mips, scratch, &solids->octaves[index], err));
    else
        upload_octaves(&mips, &solids->octaves[index]);
    for (uint32_t c = 0; c < solids->channels; c++) {
        uint32_t from = c < zoom.octaves.channels ? c : 0;
        glTextureSubImage3D(solids->tables, 0, 0, 0, (GLint)(index * solids->channels + c), HATCH_ZOOM_VALUES,
                            HATCH_ZOOM_STEPS, 1, GL_RED, GL_UNSIGNED_SHORT, table.entries[from]);
    }
    return gpu_check_memory(err, "a solid texture of %u texels along a side", size);
}

static enum hatch_status upload_all(const struct solid_files *files, const struct solids_form *form,
                                    struct hatch_pool *pool, struct hatch_arena *scratch, struct solids *solids,
                                    struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    solids->tables = gpu_texture_make(GL_TEXTURE_2D_ARRAY, 1, GL_R16, HATCH_ZOOM_VALUES, HATCH_ZOOM_STEPS,
                                      files->count * solids->channels);
    glTextureParameteri(solids->tables, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(solids->tables, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(solids->tables, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for (uint32_t i = 0; status == HATCH_OK && i < files->count; i++) {
        struct hatch_arena arena;
        hatch_arena_init(&arena, scratch->limit_bytes);
        status = upload_one(files, i, form, pool, &arena, scratch, solids, err);
        hatch_arena_free(&arena);
    }
    return status;
}

enum hatch_status solids_upload(const struct solid_files *files, const struct solids_form *form,
                                struct hatch_pool *pool, struct hatch_arena *scratch, struct solids *solids,
                                struct hatch_err *err)
{
    struct solids made = {.count = files->count, .channels = 1};
    for (uint32_t i = 0; i < files->count && !form->grey; i++)
        made.channels = files->solids[i].channels == 3 ? 3 : made.channels;
    enum hatch_status status = upload_all(files, form, pool, scratch, &made, err);
    if (status == HATCH_OK)
        *solids = made;
    else
        solids_free(&made);
    return status;
}

void solids_use(const struct solids *solids)
{
    gpu_texture_bind(UNIT_TECHNIQUE, solids->tables, 0);
    for (GLuint i = 0; i < solids->count; i++)
        gpu_texture_bind(UNIT_SOLIDS + i, solids->octaves[i], 0);
}

void solids_free(struct solids *solids)
{
    glDeleteTextures(SOLIDS_MAX, solids->octaves);
    glDeleteTextures(1, &solids->tables);
    *solids = (struct solids){.count = 0};
}
