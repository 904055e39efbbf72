/* The command line: values of the options, and their conversion to the style of frames and the choice of a view. */
#ifndef RENDER_MODE_OPTIONS_H
#define RENDER_MODE_OPTIONS_H

#include "render-gl/technique/list.h"
#include "scene/row.h"
#include "vector/drawing.h"

#define OPTIONS_CHANGES_MAX 24u

/* The part of a picture that a parameter influences. */
enum param_subject {
    PARAM_STYLE,    /* shading, with any technique */
    PARAM_CAMERA,   /* the view, which the keys for parameters do not change */
    PARAM_LINES,    /* feature lines */
    PARAM_LOOK,     /* looks */
    PARAM_STROKES,  /* strokes, with any technique that has TECHNIQUE_STROKES */
    PARAM_TECHNIQUE /* one technique only, whose `changed` applies the value */
};

/* An option whose value may change from frame to frame. */
struct param {
    const struct cmd_option *option;
    enum param_subject subject;
    const struct technique *owner; /* the technique of PARAM_TECHNIQUE; else NULL */
    bool by_factor;                /* true: a step multiplies the value; false: it is added or subtracted */
    double step;                   /* factor or difference per key press; a difference is in the option's unit */
};

/* A parameter of --animate, which goes from `from` at the first frame to `to` at the last. */
struct option_change {
    struct param param;
    double from[2], to[2]; /* in the option's unit; the second entry is used only if the option is a pair */
};

/* Treatment of the hidden parts of lines in a drawing, in the order of the option's choices. */
enum option_hidden { OPTION_HIDDEN_REMOVE, OPTION_HIDDEN_DASH };

/* Order of the paths of a drawing, in the order of the option's choices. */
enum option_sort { OPTION_SORT_BEST, OPTION_SORT_NEAREST, OPTION_SORT_NONE };

struct options {
    const struct technique *technique; /* the choice of --technique or --show */
    const char *map_path;              /* --tam; NULL: none */
    const char *scene_path;            /* first operand; NULL: standard input */
    const char *shader_folder;         /* --shader-dir; NULL: the built-in shaders */
    const char *modulate_path;         /* --modulate; NULL: none */

    /* Values that --animate and the window's keys may change, in the options' units */
    double hatch_turn_deg, hatch_scale;
    double tone_range[2], tone_gamma;
    double light_deg[2];  /* azimuth, elevation */
    double shadow_edge;   /* --shadows: width of soft edges, in the scene's radii */
    double exposure;      /* 0: automatic; job_prepare replaces it by the factor found */
    double halo_px;       /* width of haloes; 0: none */
    double line_px;       /* width of feature lines */
    double from_deg[2];   /* azimuth, elevation */
    double fov_deg, zoom; /* zoom: over 0; 1: none */
    bool tone_range_given, light_given;

    struct frame_inks inks;
    float line_color[3]; /* linear light */
    double specular[2];  /* strength and exponent of highlights */
    double anisotropy, crease_deg;
    enum hatch_up up;
    double ground; /* half the side of the ground plane, in the scene's radii; 0: none */
    bool base_tone, pixel_light, shadows;
    bool textures;                 /* the materials' textures are seen, as tone or as colours */
    uint32_t line_kinds;           /* bits of enum hatch_line_kind */
    bool lines_given;              /* --lines was given; false: only techniques with TECHNIQUE_STROKES have lines */
    struct hatch_view_choice view; /* kind and camera; options_view adds from_deg and fov_deg */

    struct cmd_texts animate;                          /* the arguments of --animate */
    struct option_change changes[OPTIONS_CHANGES_MAX]; /* the same, parsed by params_read */
    uint32_t change_count;
    double repeat;          /* --uv-scale: tiles per unit of u and v; 0: automatic */
    uint32_t width, height; /* size of the picture in pixels */
    uint32_t side;          /* samples along a pixel's side, 1 .. 8 */
    uint32_t frames;
    bool turntable;
    double time_s;      /* time of the animation at the first frame */
    double rate;        /* frames per second */
    bool animated;      /* an animation moves the scene, if there is one; false: the rest pose is drawn */
    uint32_t animation; /* index of the animation */
    bool animation_given;
    uint32_t timed_frames;  /* --time; 0: not given */
    const char *times_path; /* --times; NULL: not given */
    uint32_t draws;         /* how often --times draws each picture again */
    bool probe, needs, window;
    double tolerance;       /* --tolerance: mean difference of tone that --needs allows */
    bool vectors;           /* the output is a drawing: an SVG file or a stroke script */
    bool script;            /* the output is a stroke script */
    struct hatch_page page; /* of the drawing; its size is 0 without --page */
    double pen_mm;          /* 0: as wide on the page as line_px in the picture */
    enum option_hidden hidden;
    enum option_sort sort;
};

/* Parses and checks the command line; prints help like cmd_begin. Exits with a message of two lines on wrong usage.
 * Returns the options, which are static. */
struct options *options_read(int argc, char **argv, struct cmd_args *args);

/* Chooses the view; called by params_read, which may give --from and --fov. */
void options_read_view(struct options *options);

/* Returns the row of an option in the command's table.
 *   name  without dashes; the option must exist */
const struct cmd_option *options_find(const char *name);

/* Returns whether an option has been given, on the command line or by params_set. */
bool options_is_given(const char *name);

/* Returns whether a look paints the pictures of techniques. */
bool options_paint(const struct options *options);

/* Returns whether feature lines are drawn over the pictures of a technique. */
bool options_draw_lines(const struct options *options, const struct technique *technique);

/* Convert the values to a frame's style, and to a choice of view. */
void options_style(const struct options *options, struct frame_style *style);
struct hatch_view_choice options_view(const struct options *options);

#endif
