/* The command line: its options' values, and what they mean for frames and views. */
#ifndef RENDER_MODE_OPTIONS_H
#define RENDER_MODE_OPTIONS_H

#include "line/mesh.h"
#include "render-gl/technique/list.h"

#define OPTIONS_CHANGES_MAX 24u

/* A parameter of --animate on its way over all frames. */
struct option_change {
    const struct cmd_option *option;
    bool by_factor;
    double from[2], to[2]; /* in the option's unit */
};

/* A technique that --show draws with, instead of one of the list. */
struct options_shown {
    const char *name;
    const struct technique *technique;
};

struct options {
    const struct technique *technique;
    const char *map_path;      /* NULL: none */
    const char *scene_path;    /* of the first; NULL: standard input */
    const char *shader_folder; /* NULL: the built-in shaders */
    const char *modulate_path; /* NULL: none */

    /* Values that --animate and the window's keys may change, in the options' units */
    double hatch_turn_deg, hatch_scale;
    double tone_range[2], tone_gamma;
    double light_deg[2]; /* azimuth, elevation */
    double shadow_edge;  /* in the scene's radius */
    double exposure;     /* 0: chosen, and then set */
    double halo_px;      /* 0: none */
    double line_px;
    double from_deg[2], fov_deg, zoom;
    bool tone_range_given, light_given;

    struct frame_inks inks;
    float line_color[3]; /* linear light */
    double specular[2];  /* strength, exponent */
    double anisotropy, crease_deg;
    double ground; /* half the side of a plane below, in the scene's radii; 0: none */
    bool base_tone, pixel_light, shadows;
    uint32_t line_kinds;           /* enum hatch_line_kind, joined */
    bool lines_given;              /* else only techniques of strokes have lines */
    struct hatch_view_choice view; /* kind, and what a camera was named by */

    struct cmd_texts animate; /* of --animate; params_read makes these of them: */
    struct option_change changes[OPTIONS_CHANGES_MAX];
    uint32_t change_count;
    double repeat; /* of the pattern; 0: chosen */
    uint32_t width, height;
    uint32_t side; /* samples along a pixel's side */
    uint32_t frames;
    bool turntable;
    double time_s, rate; /* of the first frame; frames a second */
    bool animated;       /* false: the rest pose */
    uint32_t animation;
    bool animation_given;
    uint32_t timed_frames; /* 0: draw a picture */
    bool probe, window;
};

/* Parses, checks and prints help as cmd_begin does; dies with two lines on wrong usage.
 *   shown  the choices of --show; the last has no name
 * Returns the options, which last as long as the command. */
struct options *options_read(int argc, char **argv, const struct options_shown *shown, struct cmd_args *args);

/* The row of an option by its name, without dashes; it must exist. */
const struct cmd_option *options_find(const char *name);

/* Whether an option is on the command line. */
bool options_is_given(const char *name);

/* Whether feature lines are drawn over a technique. */
bool options_draw_lines(const struct options *options, const struct technique *technique);

/* The values as a frame's style, and as a choice of view. */
void options_style(const struct options *options, struct frame_style *style);
struct hatch_view_choice options_view(const struct options *options);

#endif
