/* tamthresh: makes threshold textures of a tonal art map, which hold the tones at which each texel darkens. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shared/map.h"
#include "shared/needs/map.h"
#include "shared/picture.h"
#include "shared/texels.h"
#include "tam/exact.h"
#include "tam/thresholds.h"
#include "tam/whole.h"

#define ERROR_WARNED 0.02

static const char *bins = "7", *modulation_path, *mask_path, *needs_path;
static bool exact, bins_given;
static double tolerance; /* of the needs */

static const struct cmd_option options[] = {
    {'b', "bins", CMD_TEXT, 0, 0, "BINS",
     "number of ranges of tone, 1 to 7, or the borders between them: .4,.7,.9 (default 7)", &bins, NULL, &bins_given},
    {'x', "exact", CMD_FLAG, 0, 0, NULL, "write all changes of every texel, run-length encoded, instead of thresholds",
     &exact, NULL, NULL},
    {'N', "needs", CMD_TEXT, 0, 0, "FILE", "leave out tones and levels that views do not need (render-gl --needs)",
     &needs_path, NULL, NULL},
    {'m', "modulate", CMD_TEXT, 0, 0, "IMAGE", "store an image that multiplies the light (modulation)",
     &modulation_path, NULL, NULL},
    {'k', "mask", CMD_TEXT, 0, 0, "IMAGE", "store an image as the mask, the opacity of a lapped patch", &mask_path,
     NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"bins modulate mask seed", "!exact", NULL},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "tamgen --tones 255 | tamthresh -o ink.ktx2",
    "tamgen --tones 255 -o tam.exr && tamthresh --exact tam.exr -o ink.ktx2",
    NULL,
};

static const struct cmd_program program = {
    .name = "tamthresh",
    .operands = "[FILE]",
    .summary = "make threshold textures of a tonal art map: the tones at which each texel darkens",
    .examples = examples,
    .options = options,
    .rules = rules,
    .operands_min = 0,
    .operands_max = 1,
    .seeded = true,
    .binary = true,
};

/* Parses --bins and returns the number of bins.
 *   border  out: if tones are listed, bins + 1 tones from 0 to 1; else undefined
 *   listed  out: whether tones are listed */
static uint32_t parse_bins(float *border, bool *listed)
{
    char *end;
    const char *at = bins;
    uint32_t count = 0;
    *listed = strpbrk(bins, ".,") != NULL;
    if (!*listed) {
        long number = strtol(bins, &end, 10);
        if (*end || end == bins || number < 1 || number > (long)HATCH_THRESHOLD_BINS)
            cmd_usage("--bins '%s': want 1 to %u, or tones as in .4,.7,.9", bins, HATCH_THRESHOLD_BINS);
        return (uint32_t)number;
    }
    for (border[0] = 0;; at = end + 1) {
        float tone = strtof(at, &end);
        if (end == at || !(tone > border[count] && tone < 1) || (*end && *end != ','))
            cmd_usage("--bins '%s': want tones that rise between 0 and 1, as in .4,.7,.9", bins);
        border[++count] = tone;
        if (count == HATCH_THRESHOLD_BINS)
            cmd_usage("--bins '%s': want %u tones at most", bins, HATCH_THRESHOLD_BINS - 1);
        if (!*end)
            break;
    }
    border[++count] = 1;
    return count;
}

static void check_options(const struct cmd_args *args)
{
    if (exact && cmd_is_exr_path(args->output))
        cmd_usage("--exact needs KTX2: its numbers do not fit the pixels of EXR");
}

static void encode(struct cmd_args *args, const struct hatch_tam *tam, const struct hatch_texels *texels,
                   const char *borders, struct hatch_buffer *file)
{
    static const char *const layer_names[] = {"x.0", "x.1", "dy.0", "dy.1"}, *const few_names[] = {"x.0", "dy.0"};
    char levels[16];
    snprintf(levels, sizeof levels, "%u", tam->levels);
    const char *keys[15] = {HATCH_TAM_ATTR_LEVELS, levels}, *seed = cmd_map_seed(tam);
    struct hatch_tam_whole_keys whole;
    uint32_t count = 2;
    hatch_tam_whole_print(tam, &whole);
    for (uint32_t i = 0; whole.pairs[i]; i++)
        keys[count++] = whole.pairs[i];
    if (borders) {
        keys[count++] = HATCH_THRESHOLD_KEY_BORDERS;
        keys[count++] = borders;
    }
    if (seed) {
        keys[count++] = HATCH_TAM_ATTR_SEED;
        keys[count++] = seed;
    }
    const struct cmd_texture texture = {texels, keys,
                                        texels->layers == HATCH_THRESHOLD_LAYERS_FEW ? few_names : layer_names};
    cmd_encode_texture(args, &texture, args->output, file);
}

static void make_exact(struct cmd_args *args, const char *name, const struct hatch_tam *tam, struct hatch_buffer *file)
{
    struct hatch_err err;
    struct hatch_exact made;
    cmd_check(hatch_exact_make(tam, cmd_pool(args), &args->keep, &args->scratch, &made, &err), name, &err);
    encode(args, tam, &made.texels, NULL, file);
    cmd_note("%u runs; %zu bytes", made.run_count, file->size);
}

static void read_picture(struct cmd_args *args, const char *path, struct hatch_image *image,
                         const struct hatch_image **shown)
{
    if (!path)
        return;
    cmd_read_picture(args, path, 1, &args->keep, image);
    *shown = image;
}

static void compress(struct cmd_args *args, const char *name, struct hatch_thresholds *made)
{
    struct hatch_err err;
    struct hatch_block_figures figures;
    cmd_check(hatch_thresholds_compress(made, cmd_pool(args), &args->keep, &made->texels, &figures, &err), name, &err);
    cmd_note("compression error: %.4f at most, %.4f root mean square", figures.error_max, figures.error_rms);
}

/* Makes thresholds; with needs, of few bins in half of the layers if their mean error is within the tolerance, and
 * compressed in a KTX2 file. More bins that are asked for stay.
 *   how  in, out: its number of bins */
static void make(struct cmd_args *args, const char *name, const struct hatch_tam *tam,
                 struct hatch_threshold_options *how, struct hatch_thresholds *made)
{
    struct hatch_err err;
    const uint32_t bins_wanted = how->bins;
    bool may_pack = needs_path && !how->border && !how->modulation && !how->mask &&
                    !(bins_given && how->bins > HATCH_THRESHOLD_BINS_FEW);
    if (may_pack && how->bins > HATCH_THRESHOLD_BINS_FEW)
        how->bins = HATCH_THRESHOLD_BINS_FEW;
    cmd_check(hatch_thresholds_make(tam, how, cmd_pool(args), &args->keep, &args->scratch, made, &err), name, &err);
    if (may_pack && made->figures.error <= tolerance) {
        cmd_note("%u %s of %u, in %u layers: their mean error is within the tolerance", how->bins,
                 cmd_plural(how->bins, "bin", "bins"), bins_wanted, HATCH_THRESHOLD_LAYERS_FEW);
        hatch_thresholds_pack(made);
        if (!cmd_is_exr_path(args->output))
            compress(args, name, made);
    } else if (how->bins < bins_wanted) {
        how->bins = bins_wanted;
        cmd_check(hatch_thresholds_make(tam, how, cmd_pool(args), &args->keep, &args->scratch, made, &err), name, &err);
    }
}

static void make_thresholds(struct cmd_args *args, const char *name, const struct hatch_tam *tam,
                            struct hatch_buffer *file)
{
    struct hatch_thresholds made;
    struct hatch_image pictures[2];
    float border[HATCH_THRESHOLD_BINS + 1];
    char borders[(HATCH_THRESHOLD_BINS + 1) * 16] = "";
    bool listed;
    struct hatch_threshold_options how = {.bins = parse_bins(border, &listed), .seed = args->seed};
    how.border = listed ? border : NULL;
    read_picture(args, modulation_path, &pictures[0], &how.modulation);
    read_picture(args, mask_path, &pictures[1], &how.mask);
    make(args, name, tam, &how, &made);
    const struct hatch_threshold_figures *figures = &made.figures;
    for (uint32_t b = 0, at = 0; b <= made.bins; b++)
        at += (uint32_t)snprintf(borders + at, sizeof borders - at, "%s%.6g", b ? " " : "", (double)made.border[b]);
    if (figures->error > ERROR_WARNED)
        cmd_warn(name, "%u %s too few for %.1f changes per texel: mean error %.4f, largest %.4f", made.bins,
                 cmd_plural(made.bins, "bin is", "bins are"), figures->steps, figures->error, figures->error_max);
    if (tam->ids)
        cmd_warn(name, "stroke ids are left out");
    encode(args, tam, &made.texels, borders, file);
    cmd_note("bins %s; %.2f changes per texel, %.4f of them merged: mean error %.5f, largest %.4f; %zu bytes", borders,
             figures->steps, figures->merged, figures->error, figures->error_max, file->size);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    float border[HATCH_THRESHOLD_BINS + 1];
    bool listed;
    cmd_begin(&program, argc, argv, &args);
    check_options(&args);
    parse_bins(border, &listed);
    const char *input = args.operand_count ? args.operands[0] : NULL, *name = cmd_input_name(input);
    struct cmd_output *output = cmd_open_output(args.output, "ktx2 exr", true);

    struct hatch_tam tam;
    struct hatch_needs needs;
    struct hatch_buffer file = {.arena = &args.keep};
    cmd_read_map(&args, input, &tam);
    if (needs_path) {
        cmd_read_needs(&args, needs_path, &needs);
        tolerance = needs.tolerance;
        cmd_cut_map(&needs, &tam);
    }
    if (exact)
        make_exact(&args, name, &tam, &file);
    else
        make_thresholds(&args, name, &tam, &file);
    cmd_write(output, file.data, file.size);
    return cmd_end(&args, HATCH_OK);
}
