/* The technique strokes: the strokes of a texture are found in the picture, fitted with curves and drawn anew (Szécsi,
 * Szirányi & Kacsó, "Tonal Art Maps with Image Space Strokes"). Included by the technique's own files. */
#ifndef RENDER_TECHNIQUE_STROKES_H
#define RENDER_TECHNIQUE_STROKES_H

#include "fit/lasting.h"
#include "render-gl/technique/rptam.h"
#include "render-gl/technique/technique.h"

/* A buffer that grows. Zeroed: none. */
struct strokes_buffer {
    GLuint name;
    size_t size_bytes;
};

/* A stroke and the range of its fragments, as shaders/strokes/route.comp has it. In the table of strokes, an id of 0
 * marks a free slot. */
struct strokes_slot {
    uint32_t id[2]; /* of [0], bit 0 is the index of the ink, and the six bits above are the layer */
    uint32_t count, first;
    uint32_t joined; /* bits STROKES_JOINED_..., of parts of a divided stroke */
};
#define STROKES_ID_HASH_SHIFT 7 /* of id[0]: above these bits is a hash that all parts of a divided stroke have */
#define STROKES_JOINED_START 4u /* it goes on before its start, after its end */
#define STROKES_JOINED_END 8u

/* Tables of strokes with the sums over their fragments, which blending computes. Zeroed: none. */
struct strokes_blend {
    const struct gpu_program *points, *waiting;
    struct gpu_target tables[2]; /* of this frame and of the frame before */
    int last;                    /* index of the table that was drawn last */
    uint32_t slots;              /* of a table, a power of two; 0: there are no tables */
    struct hatch_tile tile;      /* of the frame before; zeroed: there is none */
    GLuint array;                /* the fragments as points */
};

/* std430: the head of the buffer of fragments, which are 4 words each. */
struct strokes_fragments_head {
    uint32_t count, unused[3];
};

/* The strokes of a frame, ordered by strokes_compare. */
struct strokes_list {
    struct strokes_slot *strokes; /* in the scratch arena */
    uint32_t count;
    uint32_t fragments;     /* of all strokes together */
    const uint64_t *wholes; /* ids of the strokes of which these are parts; NULL: none was divided */
    const bool *lasts;      /* those that last, which are drawn; NULL: all are */
};

/* Strokes of a tile of a film's frame, found before it is drawn. */
struct strokes_tile {
    struct strokes_tile *next; /* of the same frame */
    struct hatch_tile tile;
    struct strokes_list list;
    struct strokes_buffer points;
    GLuint points_view;
    struct technique_counts counts;
};

/* Strokes of a film's frame. Zeroed: none. */
struct strokes_moment {
    uint32_t film; /* number of the frame, from 1; 0: none */
    uint32_t tile_count;
    struct strokes_tile *tiles; /* the first tile_count are those of the frame */
    struct hatch_arena arena;   /* lists of the tiles */
    struct hatch_buffer ids;    /* uint64_t: of all tiles */
};

struct strokes_state {
    struct rptam_state seeds;   /* first: functions of the technique rptam find it there */
    struct frame_shader paper;  /* programs that draw bare paper */
    struct frame_shader map;    /* programs that gather the strokes of a map */
    struct frame_shader owners; /* programs that draw which patch lies on top */
    const struct gpu_program *route, *sort, *fit, *extrude, *ribbon, *over;
    struct strokes_buffer fragments, table, sorted, found, missed, order, divided, drawn, points, indices;
    uint32_t found_count; /* strokes of the last frame, in the buffer `found` */
    uint32_t waited;      /* strokes that shared a slot with others when the frame's fragments were first routed */
    bool blends;          /* sums over fragments are computed by blending; else fragments are sorted by stroke */
    struct strokes_blend blend;
    struct technique_counts counts; /* since they were last told */
    size_t capacity;                /* fragments that the buffer holds */
    uint32_t slot_count;            /* of the table, a power of two */
    uint32_t most;                  /* strokes that are drawn */
    double width_px;                /* nominal width of the frame's strokes */
    double margin_px;               /* around the frame's tile, in which fragments are gathered, too */
    bool warned;                    /* that there are more */
    float zigzag[4];                /* of struct traced_block */
    GLuint points_view;             /* texture through which the points are read */
    GLuint array, block_buffer;
    struct strokes_moment moments[HATCH_LASTING_SPAN];
    bool has_brush;  /* the ribbons have the image of a brush */
    GLuint brush[2]; /* textures: its alpha, its grain */
};

/* Sizes of a fragment, as shaders/strokes/fragments.glsl has it, and in the buffer `sorted`, where it has no id. */
#define STROKES_FRAGMENT_BYTES (4 * sizeof(uint32_t))
#define STROKES_SORTED_BYTES (2 * sizeof(uint32_t))

/* Returns the id as one word. */
static inline uint64_t strokes_id(const struct strokes_slot *stroke)
{
    return (uint64_t)stroke->id[0] << 32 | stroke->id[1];
}

/* Orders strokes by ink, layer and id. */
int strokes_compare(const void *a, const void *b);

/* Draws the surfaces as bare paper. */
extern const struct frame_shading strokes_paper;

/* Nominal size in pixels and darkness of a stroke, of which widths are multiples. */
struct strokes_look {
    float width_px, ink;
    float length_px; /* 0: lengths vary */
};

/* Compiles what gathers strokes, and uploads what they come from: the asset if there is one, or else seed points. */
enum hatch_status strokes_prepare_source(struct technique_context *context, struct technique_instance *instance,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Gathers the fragments of the items that a target's depth lets through. */
enum hatch_status strokes_draw_source(struct technique_context *context, struct technique_instance *instance,
                                      const struct gpu_target *target, struct hatch_err *err) HATCH_MUST_USE;

struct strokes_look strokes_look(const struct technique_instance *instance);

/* Finds the fragments of the frame and the strokes that they belong to, and puts the fragments of each side by side in
 * the buffer `sorted`. */
enum hatch_status strokes_gather(struct technique_context *context, struct technique_instance *instance,
                                 struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

/* Does the same by blending, from `count` fragments: the sums of each stroke are in the slot `first` of the last table.
 * In the first frame of a tile no stroke is left out; in later ones those that share a slot. */
enum hatch_status strokes_blend(const struct frame *frame, struct strokes_state *state, uint32_t count,
                                struct strokes_list *list, struct hatch_arena *scratch,
                                struct hatch_err *err) HATCH_MUST_USE;

/* Binds the sums of the last table to five texture units. */
void strokes_blend_bind(const struct strokes_state *state);

void strokes_blend_free(struct strokes_blend *blend);

/* Runs a compute pass over `count` fragments or strokes, whose results are in storage buffers. */
void strokes_dispatch(const struct frame *frame, const struct gpu_program *program, const char *name, uint32_t count);

/* Fits the strokes and computes the points of their ribbons. Strokes that no cubic follows are divided.
 *   list  in, out: with the parts of divided strokes
 *   pool  may be NULL */
enum hatch_status strokes_fit(const struct frame *frame, struct strokes_state *state, struct strokes_list *list,
                              struct hatch_pool *pool, struct hatch_arena *scratch,
                              struct hatch_err *err) HATCH_MUST_USE;

/* A pen draws a stroke where it is this wide, in its mean widths. */
#define STROKES_THIN 0.3

/* Finds the strokes of the frame and computes their ribbons.
 *   pen_px  width of a pen that draws all strokes alike; 0: strokes as the options say
 *   list    out: in the scratch arena */
enum hatch_status strokes_find(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the strokes of a frame to come: the function `foresee` of the technique. */
enum hatch_status strokes_foresee(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Recalls the foreseen strokes of the frame and their ribbons, and finds out which of them last. */
enum hatch_status strokes_recall(const struct technique_context *context, struct technique_instance *instance,
                                 struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

/* Finds the strokes of the frame, or recalls them if they have been foreseen.
 *   pen_px, list  as for strokes_find */
enum hatch_status strokes_take(struct technique_context *context, struct technique_instance *instance, double pen_px,
                               struct strokes_list *list, struct hatch_err *err) HATCH_MUST_USE;

void strokes_film_free(struct strokes_state *state);

/* Finds the strokes of a frame as paths: the function `curves` of the technique. */
enum hatch_status strokes_curves(struct technique_context *context, struct technique_instance *instance, double pen_px,
                                 struct hatch_arena *arena, struct technique_curves *curves,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Uploads the brush of the drawing style if it has an image. Repeated calls do nothing. */
void strokes_take_brush(struct strokes_state *state);

/* Sets the uniforms of the brush, and returns its mean ink.
 *   even  all strokes are alike, as a pen draws them */
double strokes_use_brush(const struct strokes_state *state, bool even);

/* Binds the textures of the brush. */
void strokes_bind_brush(const struct strokes_state *state);

/* Makes a buffer at least as large as wanted; its content is lost if it grows. */
void strokes_reserve(struct strokes_buffer *buffer, size_t size_bytes);

#endif
