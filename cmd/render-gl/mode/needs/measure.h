/* Measures what views of a scene need: tones, the scale of surfaces in the picture, items and faces. Each view is drawn
 * once with one sample per pixel, whatever technique draws its pictures. */
#ifndef RENDER_MODE_NEEDS_MEASURE_H
#define RENDER_MODE_NEEDS_MEASURE_H

#include "needs/needs.h"
#include "needs/tones.h"
#include "render-gl/mode/job.h"
#include "render-gl/mode/needs/growth.h"
#include "render-gl/mode/needs/strokes.h"
#include "render-gl/mode/needs/technique.h"

/* Share of the tolerance by which the range of tones may be narrowed; the rest is for levels, slices, meshes and
 * strokes. */
#define NEEDS_TONES_SHARE 0.5

struct needs_item {
    uint64_t pixels;                /* that show it, in all views */
    uint32_t faces;                 /* of its surface */
    double extent_px;               /* largest diagonal of the box around its pixels in a view */
    uint32_t low_px[2], high_px[2]; /* that box in the last view, from the corner at the bottom left */
    float *unit_px; /* per face: most pixels that a unit of the scene's lengths at rest covers on it; 0: no pixel shows
                       it */
    float *growth;  /* per face: how much longer it is in the pose of the last view than at rest (growth.h) */
};

/* Needs of the views so far. */
struct needs_measure {
    double tolerance;
    uint32_t views, inks;           /* inks: 1 or 2 */
    uint64_t pixels, drawn;         /* of all views; those that show the scene */
    double darkest[2], lightest[2]; /* per ink: range of tones that a view needs; lightest over darkest: none does */
    uint64_t tones[2][HATCH_NEEDS_TONES]; /* per ink and part of the scale: pixels */
    uint64_t texels[HATCH_NEEDS_OCTAVES]; /* pixels of items that have texture coordinates */
    double map_px;                        /* side of the finest level of the map in use; 0: none */
    uint64_t finer;                       /* of the last view: pixels that need a level finer by more than 0.5 */
    uint32_t levels, dense_levels;        /* of the asset (assets/asset.h) */
    uint64_t sparse;                      /* of the last view: pixels of levels that hold strokes and have few slices */
    double unseen_tolerance;           /* smallest of the scene's meshes (struct hatch_scene_mesh); 1: none has one */
    uint64_t unseen;                   /* of the last view: pixels of such meshes */
    uint64_t few;                      /* of the last view: pixels that need more strokes than there are or can be */
    double unit_px[HATCH_NEEDS_TONES]; /* per part of the scale, of either ink: as in struct hatch_needs */
    struct needs_growth growth;
    struct needs_strokes *strokes; /* per item of the scene; zeroed */
    double unit_w_px;              /* of the view that is measured: pixels that a unit of length covers where w is 1 */
    struct needs_item *items;      /* per item of the scene */
    struct canvas canvas;          /* and the state of measuring */
    float *texels_read[2];
    struct hatch_needs_tones *view_tones; /* per ink: of the view that is measured */
};

/* Begins without views. Exits with a message when memory does not suffice. */
void needs_begin(struct job *job, double tolerance, struct needs_measure *measure);

/* Adds a view of the posed scene.
 * The tones of the view stay in measure->view_tones; returns the number of its pixels that show the scene. */
uint64_t needs_add(struct job *job, const struct hatch_view *view, struct needs_measure *measure);

/* Releases what the GPU holds. */
void needs_end(struct needs_measure *measure);

#endif
