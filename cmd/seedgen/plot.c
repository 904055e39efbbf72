#include "plot.h"

#include <math.h>

#define SIDE 400.0 /* of a panel, pixels */
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

struct hatch_bytes plot_seeds(struct cmd_args *args, const struct hatch_seeds *seeds)
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
