/* Parameters: options whose numbers may change from frame to frame, by --animate and by keys in the window. They have
 * the names, units and ranges of their options. */
#ifndef RENDER_MODE_PARAMS_H
#define RENDER_MODE_PARAMS_H

#include "render-gl/mode/options.h"

/* What depends on a parameter. */
enum param_subject {
    PARAM_STYLE,    /* every picture */
    PARAM_CAMERA,   /* the view; in a window the mouse moves it */
    PARAM_LINES,    /* feature lines */
    PARAM_STROKES,  /* every technique that draws strokes */
    PARAM_TECHNIQUE /* its technique: struct technique's changed applies it */
};

struct param {
    const struct cmd_option *option;
    enum param_subject subject;
    const struct technique *owner; /* TECHNIQUE; else NULL */
    bool by_factor;                /* it changes by factors; else by differences */
    double step;                   /* of a key: factor or difference, in the option's unit */
};

/* The parameter of a number, from 0; false beyond the last. */
bool params_at(uint32_t index, struct param *param);

/* How many numbers it has: 1 or 2. */
uint32_t params_count(const struct param *param);

/* Whether it has an effect on a picture. lines: feature lines are drawn. */
bool params_are_used(const struct param *param, const struct technique *technique, bool lines);

/* Its numbers, in the option's unit. values: 2 entries; params_set returns whether one of them is new. */
void params_get(const struct param *param, double values[2]);
bool params_set(const struct param *param, const double values[2]);

/* Reads the PARAM=FROM..TO texts of --animate into options->changes, and takes FROM as the option's value. Dies on
 * wrong usage. */
void params_read(struct options *options);

/* Sets all that change to their values at a share, 0 .. 1, of the way. Returns the subjects of those that are new, as
 * bits 1 << enum param_subject. */
uint32_t params_move(const struct options *options, double share);

#endif
