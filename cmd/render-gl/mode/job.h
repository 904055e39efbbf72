/* Everything between the options and the drawing: the scene, the asset, the GPU, the techniques in use. */
#ifndef RENDER_MODE_JOB_H
#define RENDER_MODE_JOB_H

#include "render-gl/gpu/context.h"
#include "render-gl/mode/params.h"
#include "render-gl/mode/picture.h"

struct job {
    struct cmd_args args;
    struct options *options;
    struct hatch_scene values;        /* the scene as read */
    struct hatch_patch_mesh *patches; /* of each of its meshes */
    struct asset asset;
    struct gpu_context gpu;
    enum hatch_status (*open_window)(struct gpu_context *context, uint32_t width, uint32_t height,
                                     struct hatch_err *err); /* NULL: there is none, and frames go to files */
    struct scene scene;
    struct assets assets;
    struct frame frame;
    struct technique_context context;
    struct technique_instance instances[TECHNIQUE_COUNT + 2]; /* those in use; those of --show and --probe, too */
    struct line_overlay lines;
    bool has_lines;               /* lines have been made */
    struct cmd_output **outputs;  /* one per frame, or one for a report; NULL with a window */
    struct hatch_pose_span span;  /* all frames */
    struct hatch_view fixed_view; /* used where the view does not follow the scene's pose */
    struct hatch_view first_view;
    uint32_t changes;  /* how often the technique's parameters were applied */
    double changes_ms; /* and how long that took */
};

/* Reads the files. Dies with one line on what is wrong with them. */
void job_read(struct job *job);

/* Opens the context and uploads. The scene is posed at the first frame then. */
void job_prepare(struct job *job);

/* The instance of a technique, which is opened and has read its files; NULL when memory does not suffice. Dies on what
 * is wrong with its files. */
struct technique_instance *job_open(struct job *job, const struct technique *technique, struct hatch_err *err);

/* What draws pictures with an instance that is prepared. */
struct picture job_picture(struct job *job, struct technique_instance *instance);

/* Finds the scene's feature lines. kinds: enum hatch_line_kind, joined. */
enum hatch_status job_make_lines(struct job *job, uint32_t kinds, struct hatch_err *err) HATCH_MUST_USE;

/* Fails with HATCH_BAD_INPUT where the scene lacks what a technique draws. */
enum hatch_status job_check(const struct job *job, const struct technique *technique,
                            struct hatch_err *err) HATCH_MUST_USE;

/* After parameters have changed: recomputes what depends on them.
 *   instance  that is drawn with
 *   subjects  of params_move */
enum hatch_status job_refresh(struct job *job, struct technique_instance *instance, uint32_t subjects,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Poses the scene for a frame and finds its view. */
void job_set_frame(struct job *job, uint32_t frame, struct hatch_view *view);

/* The view that the options ask for at the present pose, which is that of the animation's time_s. */
void job_view(struct job *job, double time_s, struct hatch_view *view);

/* A canvas for the picture, or for its tiles. Dies when the GPU has no memory for it. */
void job_make_canvas(struct job *job, struct canvas *canvas);

/* Releases what OpenGL holds. */
void job_end(struct job *job);

#endif
