/* What tamgen was asked for, and what it has made of it. */
#ifndef HATCH_TAMGEN_JOB_H
#define HATCH_TAMGEN_JOB_H

#include "shared/cmd.h"
#include "columns.h"
#include "placement/replay.h"

struct job {
    struct cmd_args args;
    struct hatch_style style;
    struct hatch_brush brush;
    uint32_t size_px, tones, levels;
    bool color, ids;
    const char *sheet_path, *strokes_path;
    struct hatch_tam_sheet sheet;
    struct columns columns;
    struct hatch_stroke_list strokes;
};

/* Everything that tamgen writes; opened before the work, written after it. */
struct outputs {
    struct cmd_output *map, *strokes, *sheet;
};

struct outputs open_outputs(const struct job *job);

/* Makes columns ready to receive, and the sheet, if one is wanted. job->color is set. */
void begin_columns(struct job *job);

/* Encodes all, then writes all. */
void write_outputs(struct job *job, const struct outputs *outputs);

/* How a drawing is replayed. */
struct replay_job {
    const char *path;
    bool is_svg;
    struct hatch_bytes file;
    double keep;
    bool fit;
};

/* Reads the strokes of a script or an SVG drawing into job->strokes, and says what was passed over. */
void read_drawing(struct job *job, const struct replay_job *replay);

/* Makes the map of those strokes; columns receive it. */
void replay_drawing(struct job *job, const struct replay_job *replay);

#endif
