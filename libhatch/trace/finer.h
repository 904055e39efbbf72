/* Strokes that are finer than those that a mesh came with. They are traced where a view needs them, level after level,
 * each between the strokes of the levels before it, so that a view may come as near as it likes. A stroke depends only
 * on the mesh and its strokes, not on the views that have been looked at: it is traced with everything around it that
 * may matter, and is the same whenever a view comes back to it. What has been traced is kept within a bound. */
#ifndef HATCH_TRACE_FINER_H
#define HATCH_TRACE_FINER_H

#include "base/parallel.h"
#include "curve/curves.h"
#include "curve/width.h"

#define HATCH_FINER_LEVELS_MAX 24u /* more than the mesh came with */
#define HATCH_FINER_START 1.4      /* strokes wanted, times the densest: from here on, finer ones are traced */
#define HATCH_FINER_ALIKE 1.1      /* the same where all strokes are alike */
#define HATCH_FINER_SPARED 1.3 /* the same in pictures that lack at most HATCH_FINER_LACK of their ink without them */
#define HATCH_FINER_LACK 0.002

/* A mesh and its strokes, which must outlive the finer ones. */
struct hatch_finer_source {
    const struct hatch_mesh *mesh; /* with the direction field in _HATCH_DIR */
    const struct hatch_curves *curves;
    const float *thresholds; /* per point of the curves, in strokes per mesh unit: in place of those of the points */
    struct hatch_pool *pool; /* NULL: one thread; the result is the same for any number */
    size_t limit_bytes;      /* of memory for each family that is traced */
    size_t keep_bytes;       /* of traced strokes that are kept, beyond those of the last view */
};

/* How a picture shows a mesh. */
struct hatch_finer_view {
    double clip_from_mesh[16];  /* column-major; x / w and y / w are -1 .. 1 in the picture, z / w is greater for what
                                   is nearer */
    double width_px, height_px; /* of the picture */
    double margin_px;           /* around the picture, in which strokes are wanted, too */
    const float *ink;           /* 2 per vertex: the ink that is wanted, 0 .. 1, on the front and behind; NULL: 1 */
    float (*most)[HATCH_STROKE_TONES]; /* per family: strokes per pixel across them that are drawn at ink 0,
                                                1/32 .. 1, those that fade included */
    uint32_t levels;                   /* at most so many more than the mesh came with, 1 .. HATCH_FINER_LEVELS_MAX */
    double densest;                    /* greatest threshold of the mesh's strokes: up to HATCH_FINER_START times as
                                          many, wider strokes make the tone (curve/width.h), and nothing is traced */
    bool front, behind; /* which sides of faces are seen: where corners are counter-clockwise, and others */
    bool alike;         /* a pen draws all strokes as wide: they neither fade in nor get wider */
};

/* A curve that is part of a stroke. */
struct hatch_finer_part {
    float before, after; /* lengths of the stroke before and after it, in mesh units */
    float middle[3];     /* of the stroke, in mesh units */
};

/* The strokes in a view. */
struct hatch_finer_found {
    struct hatch_curves curves;     /* with thresholds like those of hatch_finer_source */
    struct hatch_finer_part *parts; /* per curve */
    uint32_t traced;                /* strokes that were traced for this view */
    double densest;                 /* for hatch_stroke_width_px: it grows with what is wanted, from that of the view
                                       until no stroke is wider, so that no view differs much from the one before;
                                       HUGE_VAL where all are alike */
    double raised;                  /* for the same: of the strokes that were traced, 1 or more */
    bool enough;                    /* there are as many strokes as are wanted, everywhere */
    bool finer;                     /* false: the mesh's own strokes are enough, and the other members are zero */
};

struct hatch_finer;

/* Prepares a mesh. It and its curves are kept by reference.
 *   finer  out: in memory of its own, for hatch_finer_free; NULL on failure
 * HATCH_BAD_INPUT where the mesh has no field. */
enum hatch_status hatch_finer_make(const struct hatch_finer_source *source, struct hatch_finer **finer,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Finds the strokes that a view shows, and traces those that are missing.
 *   found  out: in arena */
enum hatch_status hatch_finer_find(struct hatch_finer *finer, const struct hatch_finer_view *view,
                                   struct hatch_arena *arena, struct hatch_finer_found *found,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Releases everything. */
void hatch_finer_free(struct hatch_finer *finer);

#endif
