/* The job of tamgen: its options and its results. */
#ifndef TAMGEN_JOB_H
#define TAMGEN_JOB_H

#include "shared/cmd.h"
#include "columns.h"
#include "placement/replay.h"

struct job {
    struct cmd_args args;
    struct hatch_style style;
    struct hatch_brush brush;
    uint32_t size_px, levels;
    uint32_t whole_size_px; /* size_px without --needs; 0: the same */
    uint32_t tones;         /* columns that are made */
    uint32_t every;         /* of the columns that are filled, each every-th one is made */
    float tolerance;        /* of --needs; else 0 */
    bool color, ids;
    const char *sheet_path, *strokes_path; /* NULL: not written */
    struct hatch_tam_sheet sheet;
    struct columns columns;
    struct hatch_stroke_list strokes;
};

struct outputs {
    struct cmd_output *map;
    struct cmd_output *strokes, *sheet; /* NULL: not written */
};

/* Opens all outputs, before the work begins. */
struct outputs open_outputs(const struct job *job);

/* Prepares job->columns, and job->sheet if it is written. job->color must be set. */
void begin_columns(struct job *job);

/* Encodes all outputs, then writes them. */
void write_outputs(struct job *job, const struct outputs *outputs);

/* Options of --replay. */
struct replay_job {
    const char *path;
    bool is_svg; /* true: an SVG drawing; false: a script */
    struct hatch_bytes file;
    double keep;       /* as in struct hatch_replay_options */
    bool fit;          /* likewise */
    const char *needs; /* path; NULL: all columns and levels are needed */
    bool all_levels;   /* with needs: levels are not left out */
};

/* Reads the strokes of a script or an SVG drawing into job->strokes and warns of parts that are not replayed. */
void read_drawing(struct job *job, const struct replay_job *replay);

/* Makes a map of job->strokes and passes its columns to job->columns; with needs, begins these. */
void replay_drawing(struct job *job, const struct replay_job *replay);

#endif
