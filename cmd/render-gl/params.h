/* Parameters of the drawing that may change from frame to frame: by --animate, and by a hand in the window. They
 * have the names, the numbers and the ranges of their options. */
#ifndef RENDER_PARAMS_H
#define RENDER_PARAMS_H

#include "shared/cmd.h"
#include "render-gl/technique/technique.h"

#define PARAMS_MAX 24u
#define PARAM_NONE UINT32_MAX

struct job;

/* What it is of. */
enum param_use {
    PARAM_TONE,   /* of every picture */
    PARAM_CAMERA, /* the same; in a window the hand moves it */
    PARAM_LINES,
    PARAM_STROKES, /* of every technique that draws strokes */
    PARAM_SEEDS    /* of strokes at seeds, whose model is made anew */
};

struct param {
    const char *name; /* of its option */
    enum param_use use;
    bool scale;   /* changes by factors, else evenly */
    double step;  /* of a key: a factor or a difference */
    double unit;  /* one of the option's, as struct job counts */
    size_t at[2]; /* its numbers in struct job; the second is 0 where it has one */
};

extern const struct param params[];
uint32_t params_count(void);

/* The option of options_table that it belongs to. */
const struct cmd_option *params_option(uint32_t param);

/* A parameter on its way over all frames. */
struct param_change {
    uint32_t param;
    double from[2], to[2];
};

/* Reads PARAM=FROM..TO, takes FROM as the option's value and dies on wrong usage. lines: some are drawn;
 * changes: PARAMS_MAX. Returns how many there are. */
uint32_t params_read(const struct cmd_texts *texts, const struct technique *technique, bool lines,
                     struct param_change *changes);

/* Has it an effect on what a technique draws? */
bool params_are_used(uint32_t param, const struct technique *technique, bool lines);

/* Its numbers, in its option's unit. */
void params_get(const struct job *job, uint32_t param, double values[2]);

/* The same the other way; job_refresh then makes anew what hangs on it. */
void params_set(struct job *job, uint32_t param, const double values[2]);

/* Sets all that change to what they are at a share, 0 .. 1, of their way. */
void params_move(struct job *job, double share);

#endif
