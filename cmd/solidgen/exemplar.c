#include "exemplar.h"

#include "filter/pyramid.h"
#include "shared/picture.h"

const char *const solidgen_methods[] = {"kopf", "pyramid", NULL};
const char *const solidgen_axes[] = {"xyz", "xy", "xz", "yz", NULL};

static const uint32_t axis_bits[] = {7, 3, 5, 6};

static void halve(struct cmd_args *args, struct hatch_image *image)
{
    struct hatch_err err;
    struct hatch_image half;
    uint32_t width = hatch_mip_size(image->width, 1), height = hatch_mip_size(image->height, 1);
    cmd_check(hatch_image_make(&args->keep, width, height, image->channel_count == 1 ? "Y" : "RGB", &half, &err), NULL,
              &err);
    hatch_image_halve(image, &half);
    *image = half;
}

void solidgen_read_exemplar(struct cmd_args *args, const struct solidgen_exemplar *options, uint32_t size,
                            uint32_t made, struct hatch_image *exemplar)
{
    struct hatch_err err;
    struct hatch_image picture;
    struct hatch_synthesis_figures used;
    struct hatch_arena arena;
    const char *name = cmd_input_name(options->path);
    hatch_arena_init(&arena, args->max_memory);
    cmd_read_picture(args, options->path, 0, &arena, &picture);
    cmd_check(hatch_synthesis_exemplar(&picture, size, &args->keep, &args->scratch, exemplar, &used, &err), name, &err);
    if (used.halvings || used.cropped)
        cmd_warn(name, "%ux%u pixels are too many for --size %u: %s%s%ux%u are used", picture.width, picture.height,
                 size, used.halvings ? "the resolution is halved, " : "", used.cropped ? "the middle " : "", used.width,
                 used.height);
    hatch_arena_free(&arena);
    for (; made < size; made *= 2)
        halve(args, exemplar);
}

void solidgen_synthesize(struct cmd_args *args, const struct solidgen_exemplar *options, uint32_t size,
                         const struct hatch_image *exemplar, struct hatch_solid *solid)
{
    struct hatch_err err;
    struct hatch_synthesis_figures figures;
    const struct hatch_synthesis_options how = {.size = size,
                                                .method = (enum hatch_synthesis_method)options->method,
                                                .seed = args->seed,
                                                .side = (uint32_t)options->neighborhood,
                                                .levels = (uint32_t)options->levels,
                                                .iterations = (uint32_t)options->iterations,
                                                .axes = axis_bits[options->axes],
                                                .exhaustive = options->exhaustive};
    const struct hatch_progress progress = cmd_progress_of("iterations");
    cmd_check(hatch_synthesis_make(exemplar, &how, cmd_pool(args), &progress, &args->keep, &args->scratch, solid,
                                   &figures, &err),
              cmd_input_name(options->path), &err);
    cmd_note("%u %s, %u %s", figures.levels, cmd_plural(figures.levels, "level", "levels"), figures.iterations,
             cmd_plural(figures.iterations, "iteration", "iterations"));
    if (how.method == HATCH_SYNTHESIS_KOPF)
        cmd_note("neighbourhoods of %ux%u pixels, mean difference to those of the picture %.4f", figures.side,
                 figures.side, figures.energy);
}
