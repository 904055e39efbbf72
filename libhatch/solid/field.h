/* Private: how the kinds of solid textures compute their values. */
#ifndef HATCH_SOLID_FIELD_H
#define HATCH_SOLID_FIELD_H

#include "base/parallel.h"
#include "base/progress.h"
#include "solid/noise.h"
#include "solid/style.h"

/* Settings that a field is made from. */
struct solid_job {
    const struct hatch_solid_style *style;
    uint32_t size; /* texels along a side */
    uint64_t seed;
    struct hatch_pool *pool;
    const struct hatch_progress *progress; /* may be NULL */
    struct hatch_arena *arena;             /* holds what a field needs */
    struct hatch_arena *scratch;           /* rewound */
};

/* The values of a kind: about 0 for ink to 1 for paper. */
struct solid_field {
    /* Returns the value at a place, 0 .. 1 along each axis. Called on several threads at once. */
    float (*value)(const void *state, const float at[3]);
    const void *state;
    double prepared; /* share of the work that was reported while the field was prepared */
};

/* Each prepares the field of some kinds.
 *   field  out: its state is in job->arena */
enum hatch_status solid_noise_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err);
enum hatch_status solid_wood_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err);
enum hatch_status solid_points_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err);
enum hatch_status solid_strokes_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err);
enum hatch_status solid_canvas_field(const struct solid_job *job, struct solid_field *field, struct hatch_err *err);

/* Returns how many bytes the field of strokes needs, about. */
uint64_t solid_strokes_bytes(const struct hatch_solid_style *style);

#endif
