/* tamvol: makes a volume of a tonal art map, a texture whose third coordinate is tone. */
#include <stdio.h>

#include "shared/map.h"
#include "shared/needs/map.h"
#include "shared/texels.h"
#include "image/block_compress.h"
#include "tam/volume.h"
#include "tam/whole.h"

static int64_t tones = 64;
static int layout;
static bool tones_given, layout_given, compress, alpha;
static const char *needs_path;

static const char *const layouts[] = {"volume", "array", NULL};

static const struct cmd_option options[] = {
    {'t', "tones", CMD_INT, HATCH_VOLUME_TONES_MIN, HATCH_VOLUME_TONES_MAX, "N",
     "slices of the finest level, a power of two (default 64)", &tones, NULL, &tones_given},
    {'l', "layout", CMD_CHOICE, 0, 0, "LAYOUT", "volume (3D, default) or array (2D, all tones on all levels)", &layout,
     layouts, &layout_given},
    {'c', "compress", CMD_FLAG, 0, 0, NULL,
     "compress in blocks: an array (BC4 grey, BC1 colour), or a coloured volume (BC7)", &compress, NULL, NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "leave out tones and levels that views do not need (render-gl --needs)",
     &needs_path, NULL, NULL},
    {'a', "alpha", CMD_FLAG, 0, 0, NULL, "colour as RGBA8 instead of RGB8", &alpha, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"alpha", "!compress", "compressed blocks have no choice of it"},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "tamgen --tones 128 --set 'darkest 1' | tamvol -o ink.ktx2",
    "tamgen --tones 255 -o tam.exr && tamvol --compress tam.exr -o ink.ktx2",
    NULL,
};

static const struct cmd_program program = {
    .name = "tamvol",
    .operands = "[FILE]",
    .summary = "make a volume of a tonal art map: a 3D texture over u, v and tone",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .binary = true,
};

static void check_options(const struct cmd_args *args)
{
    if (tones & (tones - 1))
        cmd_usage("--tones %d: want a power of two", (int)tones);
    if (compress && cmd_is_exr_path(args->output))
        cmd_usage("--compress needs KTX2: EXR has no compressed blocks");
}

/* Returns the layout of the volume. Compression prefers an array: in OpenGL, BC1 and BC4, with half a byte per texel,
 * exist only for 2D textures, and BC7, which 3D textures can have, takes twice as much memory. */
static enum hatch_volume_layout choose_layout(const struct hatch_tam *tam)
{
    if (compress && !tam->color && layout_given && layout == HATCH_VOLUME_3D)
        cmd_usage("--compress: OpenGL has no compressed volumes of one channel: use --layout array");
    return compress && !layout_given ? HATCH_VOLUME_ARRAY : (enum hatch_volume_layout)layout;
}

static enum hatch_texels_code choose_blocks(const struct hatch_texels *texels)
{
    if (texels->depth)
        return HATCH_TEXELS_BC7;
    return texels->channels == 1 ? HATCH_TEXELS_BC4 : HATCH_TEXELS_BC1;
}

static void warn(const char *name, const struct hatch_tam *tam, const struct hatch_volume *volume,
                 const struct hatch_volume_figures *figures)
{
    uint32_t dense = hatch_volume_dense_levels(&volume->texels, volume->levels, (double)volume->top);
    if (volume->texels.depth && dense < volume->levels)
        cmd_warn(name,
                 "strokes of %u of %u levels are grey, because these have fewer than %u slices: "
                 "want --layout array, or more --tones",
                 volume->levels - dense, volume->levels, HATCH_VOLUME_SLICES_FEW);
    if (figures->blended)
        cmd_warn(name,
                 "%u of %u slices are blends of two columns, because the nearest column is up to %.4f away in tone: "
                 "%u %s too few for %d tones",
                 figures->blended, figures->slices, figures->distance, tam->tones,
                 cmd_plural(tam->tones, "column is", "columns are"), (int)tones);
    if (tam->ids)
        cmd_warn(name, "stroke ids are left out");
}

static void pack(struct cmd_args *args, struct hatch_texels *texels)
{
    struct hatch_err err;
    struct hatch_texels packed;
    struct hatch_block_figures figures;
    cmd_check(
        hatch_texels_compress(texels, choose_blocks(texels), cmd_pool(args), &args->keep, &packed, &figures, &err),
        NULL, &err);
    cmd_note("compression error: %.4f at most, %.4f root mean square", figures.error_max, figures.error_rms);
    *texels = packed;
}

static void encode(struct cmd_args *args, const struct hatch_tam *tam, const struct hatch_volume *volume,
                   struct hatch_buffer *file)
{
    char levels[16], darkest[32], top[32];
    snprintf(levels, sizeof levels, "%u", volume->levels);
    snprintf(darkest, sizeof darkest, "%.9g", (double)volume->darkest);
    snprintf(top, sizeof top, "%.9g", (double)volume->top);
    const char *seed = cmd_map_seed(tam);
    struct hatch_tam_whole_keys whole;
    const char *keys[17] = {HATCH_TAM_ATTR_LEVELS, levels, HATCH_VOLUME_KEY_DARKEST, darkest};
    uint32_t count = 4;
    if (volume->top < 1) {
        keys[count++] = HATCH_VOLUME_KEY_TOP;
        keys[count++] = top;
    }
    hatch_tam_whole_print(tam, &whole);
    for (uint32_t i = 0; whole.pairs[i]; i++)
        keys[count++] = whole.pairs[i];
    if (seed) {
        keys[count++] = HATCH_TAM_ATTR_SEED;
        keys[count++] = seed;
    }
    const struct cmd_texture texture = {&volume->texels, keys, NULL};
    cmd_encode_texture(args, &texture, args->output, file);
}

/* Leaves out what views do not need: columns and levels of the map, slices, and of texels the bits that blocks do not
 * have. An array is the layout of which this leaves most out: a volume has fewer slices on coarser levels, and needs as
 * many there. */
static void fit(struct cmd_args *args, struct hatch_tam *tam)
{
    struct hatch_needs needs;
    cmd_read_needs(args, needs_path, &needs);
    cmd_cut_map(&needs, tam);
    if (!layout_given)
        layout = HATCH_VOLUME_ARRAY;
    uint32_t levels = layout == HATCH_VOLUME_ARRAY ? 1 : tam->levels;
    uint32_t slices = tones_given ? (uint32_t)tones : hatch_needs_slices(&needs, levels, (uint32_t)tones);
    if (slices < tones)
        cmd_note("%u slices, not %d: strokes appear within %g tolerances", slices, (int)tones, HATCH_NEEDS_SLICE);
    tones = slices;
    compress = compress || (!layout_given && !alpha && !cmd_is_exr_path(args->output));
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    check_options(&args);
    const char *input = args.operand_count ? args.operands[0] : NULL, *name = cmd_input_name(input);
    struct cmd_output *output = cmd_open_output(args.output, "ktx2 exr", true);

    struct hatch_err err;
    struct hatch_tam tam;
    struct hatch_volume volume;
    struct hatch_volume_figures figures;
    cmd_read_map(&args, input, &tam);
    if (needs_path)
        fit(&args, &tam);
    struct hatch_volume_options how = {(uint32_t)tones, choose_layout(&tam), alpha};
    cmd_check(hatch_tam_check_nesting(&tam, cmd_pool(&args), &args.scratch, &err), name, &err);
    cmd_check(hatch_volume_make(&tam, &how, cmd_pool(&args), &args.keep, &volume, &figures, &err), name, &err);
    if (compress)
        pack(&args, &volume.texels);

    struct hatch_buffer file = {.arena = &args.keep};
    encode(&args, &tam, &volume, &file);
    cmd_note("%u slices in the drawn levels, at most %.4f from the tone of a column; %zu bytes", figures.slices,
             figures.distance, file.size);
    cmd_write(output, file.data, file.size);
    warn(name, &tam, &volume, &figures);
    return cmd_end(&args, HATCH_OK);
}
