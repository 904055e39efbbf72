/* What the command line says. */
#ifndef RENDER_OPTIONS_H
#define RENDER_OPTIONS_H

#include "shared/cmd.h"
#include "render-gl/params.h"
#include "render-gl/renderer.h"

/* What strokes at seeds have in common. */
struct seed_style {
    double tile_px, length_px, width_px, ink; /* length_px, ink 0: the drawing style's; tile_px is chosen
                                                   unless it is given */
    enum hatch_fade_law law;
    bool fade_size;
    double overlap;
};

/* What draws at seeds. */
struct seed_choice {
    const char *path;        /* of the sets; NULL: made */
    const char *layers_path; /* of layers that differ; NULL: none */
    const char *drawing;     /* the style: brush, ink, directions, width and length where none is given */
    struct seed_style style;
    bool tile_given;
    double turn_rad;        /* between layers that have one direction */
    double stroke_turn_rad; /* of all */
    double layers;          /* so many are drawn, rounded */
    bool all;               /* look at every seed at every place */
};

struct options {
    int technique;          /* index into techniques; what --show shows is one */
    const char *map_path;   /* NULL: none */
    const char *scene_path; /* of the first; NULL: standard input */
    const char *shader_folder;
    const char *modulate_path; /* NULL: none */
    struct style style;
    struct seed_choice seeds;
    struct line_style lines;
    struct hatch_view_choice view;
    double ground; /* half a side of a plane below, in the scene's radii; 0: none */
    double zoom;   /* so many times nearer */
    struct param_change changes[PARAMS_MAX];
    uint32_t change_count;
    bool high_given; /* the darkest tone; else the map's darkest column */
    double repeat;   /* 0: chosen */
    uint32_t width, height;
    uint32_t side; /* samples along a pixel's side */
    uint32_t frames;
    bool turntable;
    double time_s, rate; /* of the first frame, frames a second */
    bool animated;       /* false: the rest pose */
    uint32_t animation;
    bool animation_given;
    uint32_t timed_frames; /* 0: draw a picture */
    bool probe, window;
};

/* Parses, checks and prints help as cmd_begin does; dies with two lines on what is wrong. */
void options_read(int argc, char **argv, struct cmd_args *args, struct options *options);

/* All options but those that every command has; the last has no name. */
const struct cmd_option *options_table(void);

#endif
