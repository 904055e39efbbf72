/* hatchstat tones FILE: measures errors of tone of a volume, a threshold texture, exact runs or a map with few
 * columns. */
#include "shared/map.h"
#include "image/block_compress.h"
#include "io/exr/exr.h"
#include "io/texture/container.h"
#include "measure/tone_figures.h"
#include "subject.h"
#include "tam/exact.h"
#include "tam/thresholds.h"
#include "tam/volume.h"

static const char *const columns[] = {"lod",       "bytes", "tone_error", "tone_worst", "error",
                                      "error_max", "grey",  "grey_all",   NULL};

struct subject {
    size_t bytes; /* size of all texels */
    hatch_tone_sample sample;
    const void *sampled; /* first argument of sample: one of the members below */
    struct hatch_tam map;
    struct hatch_volume volume;
    struct hatch_thresholds thresholds;
    struct hatch_exact exact;
};

static float sample_volume(const void *subject, float u, float v, float tone, float lod)
{
    const struct hatch_volume *volume = subject;
    float value[4];
    hatch_volume_sample(volume, u, v, tone, lod, true, value);
    return volume->texels.channels < 3 ? value[0] : (value[0] + value[1] + value[2]) / 3;
}

static float sample_thresholds(const void *subject, float u, float v, float tone, float lod)
{
    return hatch_thresholds_sample(subject, u, v, tone, lod);
}

static float sample_exact(const void *subject, float u, float v, float tone, float lod)
{
    return hatch_exact_sample(subject, u, v, tone, lod);
}

static size_t texel_bytes(const struct hatch_texels *texels)
{
    size_t bytes = 0;
    for (uint32_t level = 0; level < texels->level_count; level++)
        bytes += hatch_texels_level_size(texels, level);
    return bytes;
}

/* Opens a KTX2 file as exact runs, as a threshold texture or as a volume, according to its format and keys. */
static void open_texture(struct cmd_args *args, const char *name, struct hatch_bytes file, struct subject *subject)
{
    struct hatch_err err;
    struct hatch_texels texels, plain;
    const char *const *keys;
    cmd_check(hatch_ktx2_read(file, &args->keep, &texels, &err), name, &err);
    cmd_check(hatch_ktx2_read_keys(file, &args->keep, &keys, &err), name, &err);
    subject->bytes = texel_bytes(&texels);
    if (texels.code == HATCH_TEXELS_R32UI) {
        cmd_check(hatch_exact_from_texels(&texels, &subject->exact, &err), name, &err);
        subject->sample = sample_exact;
        subject->sampled = &subject->exact;
    } else if (hatch_texels_value(keys, HATCH_THRESHOLD_KEY_BORDERS)) {
        cmd_check(hatch_thresholds_decompress(&texels, &args->keep, &texels, &err), name, &err);
        cmd_check(hatch_thresholds_from_texels(&texels, keys, &subject->thresholds, &err), name, &err);
        subject->sample = sample_thresholds;
        subject->sampled = &subject->thresholds;
    } else {
        cmd_check(hatch_texels_decompress(&texels, &args->keep, &plain, &err), name, &err);
        cmd_check(hatch_volume_from_texels(&plain, keys, &subject->volume, &err), name, &err);
        subject->sample = sample_volume;
        subject->sampled = &subject->volume;
    }
}

static void open_subject(struct cmd_args *args, const char *path, struct subject *subject)
{
    struct hatch_bytes file = cmd_read(args, path);
    if (!hatch_exr_is(file)) {
        open_texture(args, cmd_input_name(path), file, subject);
        return;
    }
    cmd_parse_map(args, cmd_input_name(path), file, &subject->map);
    const struct hatch_tam *map = &subject->map;
    for (uint32_t level = 0; level < map->columns[0].level_count; level++) {
        size_t size = hatch_mip_size(map->size_px, level);
        subject->bytes += size * size * map->tones * (map->color ? 3 : 1);
    }
    subject->sample = hatch_tone_sample_map;
    subject->sampled = map;
}

enum hatch_status stat_tones(struct cmd_args *args, const struct stat_options *options, struct cmd_output *output)
{
    struct hatch_err err;
    struct subject subject = {0};
    struct hatch_tam map;
    const char *path = args->operand_count > 1 ? args->operands[1] : NULL;
    if (!options->reference)
        cmd_usage("tones: --reference is missing: the map that the file was made from");
    cmd_read_map(args, options->reference, &map);
    open_subject(args, path, &subject);
    struct cmd_report report;
    cmd_report_begin(&report, args, columns);
    for (uint32_t half = 0; half < 2 * map.levels - 1; half++) {
        struct hatch_tone_figures f;
        float lod = 0.5f * (float)half;
        const struct hatch_tone_test test = {&map, subject.sample, subject.sampled, lod, (uint64_t)options->samples};
        cmd_check(hatch_measure_tones(&test, cmd_pool(args), &args->scratch, &f, &err), cmd_input_name(path), &err);
        cmd_report_number(&report, (double)lod);
        cmd_report_integer(&report, subject.bytes);
        const double numbers[] = {f.tone_error, f.tone_worst, f.error, f.error_max, f.grey, f.grey_all};
        for (uint32_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
            cmd_report_number(&report, numbers[i]);
    }
    cmd_report_write(&report, output);
    return HATCH_OK;
}
