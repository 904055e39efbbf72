/* Everything between the options and the drawing: the scene, the map, the context, the renderer. */
#ifndef RENDER_JOB_H
#define RENDER_JOB_H

#include "render-gl/context.h"
#include "render-gl/field.h"
#include "render-gl/load.h"
#include "render-gl/options.h"
#include "seed/layers.h"
#include "placement/style.h"

/* What a stroke looks like. */
struct job_stroke {
    struct hatch_image alpha, grain; /* grain: of no pixels where there is none */
    bool varied;
};

/* What the model of strokes at seeds is made from. */
struct stroke_source {
    struct hatch_seeds sets;
    struct hatch_style drawing;
    struct job_stroke stroke;         /* the drawing style's */
    struct hatch_layers layers;       /* those that differ; count 0: none */
    struct job_stroke *layer_strokes; /* of each of them that has its own */
    struct hatch_arena arenas[2];     /* the model lies in one; the next is made in the other */
    int arena;
};

struct job {
    struct cmd_args args;
    struct options options;
    struct hatch_scene scene;
    struct hatch_patch_mesh *patches; /* of each of its meshes */
    struct hatch_tam map;             /* no columns: the file held what fine says, or there was none */
    struct fine fine;
    struct stroke_source source;
    struct hatch_rptam rptam;           /* made when a technique first draws at seeds */
    bool strokes_changed, view_changed; /* job_refresh has something to do */
    uint32_t strokes_made;              /* how often the model was made anew */
    double strokes_ms;                  /* and how long that took */
    struct context context;
    struct gpu_scene gpu;
    struct renderer renderer;
    struct lines lines;
    struct field field;
    struct cmd_output **outputs;  /* one per frame, or one for a report; NULL with a window */
    struct hatch_pose_span span;  /* all frames */
    struct hatch_view fixed_view; /* used when hatch_view_is_fixed */
};

/* Reads the files. Dies with one line on what is wrong. */
void job_read(struct job *job);

/* Reads the seeds and the style of strokes, and makes the model. Dies with one line on what is wrong. */
void job_read_seeds(struct job *job);

/* Makes the model from what has been read, and as the options are now; the old one stays on failure. */
enum hatch_status job_make_strokes(struct job *job, struct hatch_err *err) HATCH_MUST_USE;

/* The darkest tone that is asked for, where the user says nothing: as dark as all layers of strokes. */
void job_set_darkest(struct job *job);

/* After parameters have changed: makes anew what hangs on them. */
enum hatch_status job_refresh(struct job *job, struct hatch_err *err) HATCH_MUST_USE;

/* Opens the context and uploads. The scene is posed at the first frame then. */
void job_prepare(struct job *job);

/* Finds the scene's feature lines, and draws them from now on. kinds: some of enum hatch_line_kind. */
enum hatch_status job_make_lines(struct job *job, uint32_t kinds, struct hatch_err *err) HATCH_MUST_USE;

/* Poses the scene for a frame and finds its view. */
void job_set_frame(struct job *job, uint32_t frame, struct hatch_view *view);

/* The view that the options ask for at the current pose, which is that of the animation's time_s. */
void job_view(struct job *job, double time_s, struct hatch_view *view);

/* A target for the picture, or for its tiles. */
void job_make_target(struct job *job, struct target *target);

/* Releases what OpenGL holds. */
void job_end(struct job *job);

/* The bytes of a picture: EXR where the path ends so, else PNG. */
void pictures_encode(const char *path, const struct hatch_image *image, struct hatch_arena *scratch,
                     struct hatch_buffer *file);

/* The ways to end: pictures into files, times and probes as text, a window. */
void pictures_write(struct job *job);
void timing_report(struct job *job);
void probe_report(struct job *job);
void window_run(struct job *job);

#endif
