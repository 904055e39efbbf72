/* The technique traced: strokes that strokegen has traced on the meshes. Included by the technique's own files. */
#ifndef RENDER_TECHNIQUE_TRACED_H
#define RENDER_TECHNIQUE_TRACED_H

#include "curve/width.h"
#include "placement/style.h"
#include "render-gl/technique/technique.h"
#include "trace/finer.h"

/* std140 layout; the same as block Style of shaders/traced/style.glsl. */
struct traced_block {
    float pen[4];   /* width in pixels, thin (curve/width.h); samples along a pixel's side; tangent of turn_rad */
    float hand[4];  /* vary, pressure, wobble_px, taper_px (curve/width.h) */
    float ink[4];   /* darkness of a stroke, grain; HATCH_STROKE_GRAZING, or 0 for dots and pens; unused */
    float marks[4]; /* length and gap of marks in pixels, scatter; 1: they are dots */
    float tones[HATCH_CURVE_FAMILIES_MAX][HATCH_STROKE_TONES + 3]; /* per family: hatch_stroke_tones; 3 unused */
    float narrow[HATCH_CURVE_FAMILIES_MAX]
                [HATCH_STROKE_TONES + 3];     /* the same for narrow faces, in the order in which
                                                 families join there: first the one that crosses */
    float zigzag[4];                          /* amplitude and wave in pixels; waves along a whole stroke, 0: as many as
                                                 its length has; stretch (curve/stroke_look.h) */
    uint32_t look[4];                         /* numbers of values of both profiles; of colours; 1: they are mixed */
    float profiles[2][HATCH_PROFILE_MAX];     /* of width, with a mean of 1, and of pressure */
    float colors[HATCH_STROKE_COLORS_MAX][4]; /* of strokes, the fourth channel unused */
};

/* Fills in the part of a block that comes from the look of strokes.
 *   width_px  nominal width of strokes
 *   even      a pen draws all strokes alike: without profiles, and as wide with a zigzag as without */
void traced_set_look(const struct hatch_stroke_look *look, double width_px, bool even, struct traced_block *block);

/* A point of a stroke, as shaders/traced/points.comp reads it. */
struct traced_point {
    uint32_t corners[3], hash;
    float share[2], way[2];   /* of corners 1 and 2; their change per mesh unit along the stroke */
    float threshold, area;    /* strokes per mesh unit; doubled area of the face, in mesh units squared */
    float from_start, to_end; /* arc lengths, in mesh units */
    float family, ends;       /* ends: bits 1: first, 2: last of its stroke; 4, 8: its start, its end is not free */
    float turn;               /* of the stroke and its neighbours together, random, -1 .. 1 */
    float tip;                /* greatest length of its pointed ends, in mesh units */
    float across[2];          /* the way across a narrow face: change of share */
    float crossing;           /* 1 + the family that crosses it; 0: there is no narrow face here */
    float reached;            /* greatest density on its part of the mesh, as a share of that of the mesh */
};

/* Where a stroke comes from. */
struct traced_stroke {
    const struct hatch_curve *curve;
    uint32_t family;
};

/* The strokes of a mesh on the GPU, in the order of their least thresholds. Zeroed: none. */
struct traced_strokes {
    GLuint points, indices; /* indices of triangles: vertices 2 i and 2 i + 1 are the sides of point i */
    uint32_t count;         /* strokes */
    const float *least;     /* least threshold of each stroke */
    const struct traced_stroke *sources;
    const struct hatch_curve_point *curve_points; /* that the curves of the sources refer to */
    const float *thresholds;                      /* of these points, as they are drawn */
    const uint32_t *end;                          /* number of points up to the end of each stroke */
    float finest, coarsest;                       /* gaps of levels, in mesh units; coarsest: of level 0 */
    float densest;                                /* hatch_curves_densest of all */
    float fewest;                                 /* the same of the family that has least */
    float raised;                                 /* of hatch_stroke_width_px */
    uint32_t families;                            /* of the mesh */
    bool narrow;                                  /* whether some lie on narrow faces */
};

/* The points of an item's strokes in a picture: TRACED_RIBBON_FLOATS for each. */
struct traced_ribbon {
    GLuint buffer, view; /* view: the texture through which they are read */
};

/* The buffers of an item. */
struct traced_item {
    GLuint placed; /* per vertex: 8 floats */
    struct traced_ribbon ribbon;
    /* Near views, which need finer strokes than the file has: */
    bool seen; /* the other members are those of a view */
    struct hatch_finer_view view;
    struct hatch_finer_found found; /* in arena */
    struct hatch_arena arena;
    struct traced_strokes strokes; /* count 0: those of the file suffice */
    struct traced_ribbon near;
};

/* Strokes to upload. */
struct traced_source {
    const struct hatch_mesh *mesh;
    const struct hatch_curves *curves;
    const struct hatch_finer_part *parts; /* per curve; their points' thresholds are those that are drawn. NULL: curves
                                             are whole strokes, whose thresholds are made even */
    struct hatch_pool *pool;              /* NULL: one thread */
};

/* Uploads strokes.
 *   arena  holds the arrays */
enum hatch_status traced_upload(const struct traced_source *source, struct hatch_arena *arena,
                                struct hatch_arena *scratch, struct traced_strokes *strokes,
                                struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status traced_make_ribbon(const struct traced_strokes *strokes, struct traced_ribbon *ribbon,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Release what is on the GPU. */
void traced_free_strokes(const struct traced_strokes *strokes);
void traced_free_ribbon(const struct traced_ribbon *ribbon);

struct traced_state {
    struct shaded_state shaded;     /* first: shaded_prepare finds it there */
    struct traced_strokes *strokes; /* per mesh; NULL: not uploaded */
    struct hatch_finer **finer;     /* per mesh; NULL: no view has needed them */
    struct traced_item *items;      /* per item */
    struct hatch_style style;
    struct hatch_stroke_pen pen; /* of the frame: its lengths are those of the pen in use */
    bool alike;                  /* a pen draws all strokes of the frame as wide, and no dots */
    uint32_t mesh_count, item_count;
    uint32_t families;     /* whose tones the block has; 0: none */
    uint32_t finer_levels; /* at most so many more than the file has; 0: none */
    struct traced_block block;
    float most[HATCH_CURVE_FAMILIES_MAX][HATCH_STROKE_TONES]; /* as in struct hatch_finer_view */
    GLuint array, block_buffer;
    const struct gpu_program *vertices, *points[2], *ribbons[2]; /* points: [1] with BASE_TONE; ribbons: [1] curves */
};

/* Per point of a ribbon: x, y, depth, half width in pixels; ink, number, arc length from the start and to the end, in
 * gaps of level 0; scale, level, share and scatter of struct hatch_mark_point, where strokes that are no dots have the
 * length of their pointed ends, as a share of taper_px, in place of the share. Below 0, the half width says that the
 * point is not in sight. The number is 16 times the stroke's hash, of 20 bits, plus `ends` of struct traced_point. */
#define TRACED_RIBBON_FLOATS 12u
#define TRACED_HASH_BITS HATCH_STROKE_NUMBER_BITS

/* Returns the length in the unit scene of a length of 1 in the units of an item's mesh, in the direction in which it is
 * greatest: exactly where the item's scales are along its axes, else a little more. Of a deformed item, whose scales
 * differ from place to place, the mean by which the matrices of its node or of its first joint scale. */
double traced_scale(const struct scene *scene, const struct hatch_item *item);

/* Computes the points of an item's ribbons. Returns the number of strokes that have some.
 *   ink     0: of the dark ink; 1: of the light one
 *   depths  texture with the depths of the surfaces, which hide strokes on backs of thin walls; 0: nothing hides them
 */
uint32_t traced_place(const struct frame *frame, struct traced_state *state, uint32_t item, int ink, GLuint depths);

/* Places and lights the vertices of an item. */
void traced_place_vertices(const struct frame *frame, const struct traced_state *state, uint32_t item);

/* Fills in the block of the style, but for the tones.
 *   pen_px  width of a pen that draws all strokes alike; 0: strokes as the options say */
void traced_set_style(const struct frame *frame, double pen_px, struct traced_state *state);

/* Fills in the tones of a mesh with so many families, and writes the block, unless it is that already. */
void traced_set_families(uint32_t families, struct traced_state *state);

/* Finds the strokes of a frame as curves: the function `curves` of the technique. */
enum hatch_status traced_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                struct hatch_arena *arena, struct technique_curves *curves,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Traces the finer strokes that the frame needs, for all items. The style must be set. */
enum hatch_status traced_refine(struct technique_context *context, struct traced_state *state,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Releases the finer strokes of an item's last view. */
void traced_forget(struct traced_item *item);

/* Returns the strokes and the ribbon that are drawn on an item. */
const struct traced_strokes *traced_strokes_of(const struct frame *frame, const struct traced_state *state,
                                               uint32_t item);
const struct traced_ribbon *traced_ribbon_of(const struct traced_state *state, uint32_t item);

/* Returns the number of strokes whose least threshold is under a limit. */
uint32_t traced_count_under(const struct traced_strokes *strokes, double threshold);

#endif
