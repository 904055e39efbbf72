/* seedgen: makes seed sets for recursive procedural tonal art maps. */
#include <stdio.h>
#include <math.h>

#include "seed/seeds_make.h"
#include "seed/spread.h"
#include "shared/cmd.h"

static int64_t count = 64, layers = 1, candidates = 0, nodes_max = 200000000;
static int method = HATCH_CYCLE_ANY;
static const char *plot_path;

static const char *const methods[] = {"any", "euler", "backtrack", NULL};

static const struct cmd_option options[] = {
    {'n', "count", CMD_INT, HATCH_CYCLE_MIN, HATCH_CYCLE_MAX, "N", "seed points in a set (default 64)", &count, NULL,
     NULL},
    {'l', "layers", CMD_INT, 1, HATCH_SEED_LAYERS_MAX, "N", "sets to make, one per layer (default 1)", &layers, NULL,
     NULL},
    {'c', "candidates", CMD_INT, 0, 1000000, "N",
     "random sets per layer, the best of which is kept (default 0: chosen by --count)", &candidates, NULL, NULL},
    {'m', "method", CMD_CHOICE, 0, 0, "METHOD",
     "any (default; any --count), euler or backtrack (--count a power of four)", &method, methods, NULL},
    {0, "max-nodes", CMD_INT, 1, 1e15, "N", "backtrack: search steps before giving up (default 200000000)", &nodes_max,
     NULL, NULL},
    {'p', "plot", CMD_TEXT, 0, 0, "FILE", "also draw the sets as SVG", &plot_path, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"max-nodes", "method=backtrack", NULL},
    {NULL, NULL, NULL},
};

static const char *const examples[] = {
    "seedgen -n 64 --layers 4 --candidates 1000 -o four.seeds",
    "seedgen -n 16 --plot sixteen.svg | hatchstat seeds",
    NULL,
};

static const struct cmd_program program = {
    .name = "seedgen",
    .operands = "",
    .summary = "make seed sets: self-similar sets of points at which strokes are drawn at every scale",
    .examples = examples,
    .options = options,
    .rules = rules,
    .seeded = true,
};

#define SIDE 400.0 /* side of a panel, pixels */
#define GAP 40.0
#define ACROSS 4u

static void begin(struct hatch_buffer *svg, uint32_t panels)
{
    double columns = fmin(panels, ACROSS), rows = ceil((double)panels / ACROSS);
    double width = GAP + columns * (SIDE + GAP), height = GAP + rows * (SIDE + GAP);
    struct hatch_err err;
    cmd_check(hatch_buffer_print(svg, &err,
                                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" "
                                 "height=\"%g\" viewBox=\"0 0 %g %g\">\n"
                                 "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
                                 width, height, width, height),
              NULL, &err);
}

static void circle(struct hatch_buffer *svg, double u, double v, double radius, const char *class)
{
    struct hatch_err err;
    cmd_check(hatch_buffer_print(svg, &err, "<circle class=\"%s\" cx=\"%.4f\" cy=\"%.4f\" r=\"%.3f\"/>\n", class,
                                 u * SIDE, v * SIDE, radius),
              NULL, &err);
}

static void panel(struct hatch_buffer *svg, const struct hatch_seed_set *set, uint32_t number,
                  const struct hatch_seed_point *places)
{
    double radius = fmax(0.2, 0.12 * SIDE / sqrt(set->count));
    struct hatch_err err;
    cmd_check(hatch_buffer_print(svg, &err,
                                 "<g transform=\"translate(%g %g)\" fill=\"none\" stroke=\"black\">\n"
                                 "<title>layer %u: %u seeds</title>\n"
                                 "<path stroke=\"#bbb\" d=\"M0 0H%gV%gH0ZM%g 0V%gM0 %gH%g\"/>\n",
                                 GAP + number % ACROSS * (SIDE + GAP), GAP + number / ACROSS * (SIDE + GAP), number + 1,
                                 set->count, SIDE, SIDE, SIDE / 2, SIDE, SIDE / 2, SIDE),
              NULL, &err);
    for (uint32_t i = 0; i < set->count; i++) {
        double u = (double)places[i].u * 0x1p-64, v = (double)places[i].v * 0x1p-64;
        circle(svg, u, v, radius, "seed");
        for (int tile = 0; tile < 4; tile++)
            circle(svg, (u + tile % 2) / 2, (v + tile / 2) / 2, radius / 2, "nested");
    }
    cmd_check(hatch_buffer_add(svg, "</g>\n", 5, &err), NULL, &err);
}

/* Returns an SVG, in args->keep, with one panel per layer. Large circles are the layer's seed points; small circles are
 * the same pattern at half its size, repeated 2 by 2. Each large circle has the centre of a small one. */
static struct hatch_bytes plot_seeds(struct cmd_args *args, const struct hatch_seeds *seeds)
{
    struct hatch_buffer svg = {.arena = &args->keep};
    struct hatch_err err;
    begin(&svg, seeds->layer_count);
    for (uint32_t i = 0; i < seeds->layer_count; i++) {
        const struct hatch_seed_set *set = &seeds->layers[i];
        struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
        struct hatch_seed_point *places = HATCH_NEW(&args->scratch, struct hatch_seed_point, set->count, &err);
        cmd_check(places ? HATCH_OK : HATCH_LIMIT, NULL, &err);
        hatch_seed_points(set, places);
        panel(&svg, set, i, places);
        hatch_arena_rewind(&args->scratch, mark);
    }
    cmd_check(hatch_buffer_add(&svg, "</svg>\n", 7, &err), NULL, &err);
    return (struct hatch_bytes){svg.data, svg.size};
}

static void make(struct cmd_args *args, struct hatch_seeds *seeds)
{
    const struct hatch_progress progress = cmd_progress_of("layers");
    const struct hatch_seeds_options how = {
        .cycle = {.method = (enum hatch_cycle_method)method,
                  .count = (uint32_t)count,
                  .seed = args->seed,
                  .steps_max = (uint64_t)nodes_max},
        .layers = (uint32_t)layers,
        .candidates = (uint32_t)candidates,
        .progress = &progress,
    };
    uint64_t steps;
    double within, together;
    struct hatch_err err;
    cmd_check(hatch_seeds_make(&how, &args->keep, &args->scratch, seeds, &steps, &err), NULL, &err);
    if (!args->verbose)
        return;
    cmd_check(hatch_seeds_spread(seeds, &args->scratch, &within, &together, &err), NULL, &err);
    cmd_note("smallest distances, relative to the largest possible: %.3f within a set, %.3f among all sets", within,
             together);
    if (method == HATCH_CYCLE_BACKTRACK)
        cmd_note("%llu search steps", (unsigned long long)steps);
}

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    struct cmd_output *output = cmd_open_output(args.output, "seeds txt", false);
    struct cmd_output *plot = plot_path ? cmd_open_output(plot_path, "svg", false) : NULL;

    struct hatch_seeds seeds;
    make(&args, &seeds);
    char comment[160];
    struct hatch_buffer file = {.arena = &args.keep};
    struct hatch_err err;
    snprintf(comment, sizeof comment, "seedgen --count %lld --layers %lld --candidates %lld --method %s --seed %llu",
             (long long)count, (long long)layers, (long long)candidates, methods[method],
             (unsigned long long)args.seed);
    cmd_check(hatch_seeds_write(&seeds, comment, &file, &err), NULL, &err);
    struct cmd_file files[2] = {{.output = output, .data = file.data, .size = file.size}};
    if (plot) {
        struct hatch_bytes drawing = plot_seeds(&args, &seeds);
        files[1] = (struct cmd_file){.output = plot, .data = drawing.data, .size = drawing.size};
    }
    cmd_write_all(files, plot ? 2 : 1);
    return cmd_end(&args, HATCH_OK);
}
