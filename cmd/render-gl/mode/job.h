/* One run of the command, once its options are read: the scene, the asset, the GL context and the techniques in use. */
#ifndef RENDER_MODE_JOB_H
#define RENDER_MODE_JOB_H

#include "render-gl/gpu/context.h"
#include "render-gl/mode/params.h"
#include "render-gl/mode/picture.h"

struct job {
    struct cmd_args args;
    struct options *options;
    struct hatch_scene values;        /* the scene as read from files, in memory */
    struct hatch_patch_mesh *patches; /* one per mesh of values */
    const char *name;                 /* name of the scene, for messages */
    struct hatch_bounds rest;         /* with --needs: of all faces in the files at rest, transparent ones, too */
    uint32_t *mesh_end;               /* per operand: number of meshes of its file and those before; NULL: one file */
    struct asset asset;               /* the file of --tam; zeroed: none */
    struct gpu_context gpu;
    enum hatch_status (*open_window)(struct gpu_context *context, uint32_t width, uint32_t height,
                                     struct hatch_err *err); /* window_open; NULL: no window, frames go to files */
    struct scene scene;                                      /* the scene on the GPU */
    struct assets assets;
    struct frame frame;
    struct look look; /* that paints pictures, if context.look is set */
    struct technique_context context;
    struct technique_instance instances[TECHNIQUE_COUNT + 3]; /* those opened; 3 more: --show, --probe, --needs */
    struct line_overlay lines;
    bool has_lines;                  /* `lines` has been made */
    struct cmd_output **outputs;     /* one per frame, or one for a report; NULL with a window */
    struct cmd_output *times_output; /* of --times; NULL: not given */
    struct hatch_pose_span span;     /* the animation, and moments that bound all frames */
    bool empty;                      /* the scene has nothing to show, of which a warning has told */
    struct hatch_view fixed_view;    /* the view of all frames, unless it follows the scene's pose */
    struct hatch_view_middle middle; /* of --zoom, found in the first view; its distance is 0 before that */
    struct hatch_view first_view;    /* the view of the first frame */
    uint32_t changes;                /* number of calls of the technique's `changed` */
    uint32_t foreseen;               /* number of frames that have been foreseen, from the first */
    double changes_ms;               /* total time of these calls */
};

/* Names the scene after its files, and reads these (mode/load.c). Exits with a message on failure.
 *   notes  in: zeroed; out: what is doubtful about the meshes */
void job_load(struct job *job, struct hatch_mesh_notes *notes);

/* Sets the time span of all frames. They share its bounds, framing, exposure and ground, so that the camera does not
 * move. Exits with a message if the animation does not exist. */
void job_set_span(struct job *job);

/* Exits with a message if no node of the scene has a face. */
void job_check_faces(const struct job *job, const struct hatch_mesh_notes *notes);

/* Reads the scene, the asset and the files of techniques, and checks them. Exits with a message on failure. */
void job_read(struct job *job);

/* Opens the context, uploads the scene and the asset, prepares the technique, and poses the scene for the first frame.
 * Exits with a message on failure. */
void job_prepare(struct job *job);

/* Measures and poses the scene without a context, for the modes that draw nothing with the GPU. Exits with a message on
 * failure. */
void job_prepare_without_gpu(struct job *job);

/* Returns the instance of a technique. On the first call, opens it and reads its files; exits with a message if they
 * are wrong. Returns NULL and sets err when memory does not suffice. */
struct technique_instance *job_open(struct job *job, const struct technique *technique, struct hatch_err *err);

/* Returns the instance of a technique, opened and prepared to draw. Exits with a message on failure. */
struct technique_instance *job_use(struct job *job, const struct technique *technique);

/* Returns a struct picture for picture_draw, which draws with a prepared instance. */
struct picture job_picture(struct job *job, struct technique_instance *instance);

/* Finds the scene's feature lines.
 *   kinds  bits of enum hatch_line_kind */
enum hatch_status job_make_lines(struct job *job, uint32_t kinds, struct hatch_err *err) HATCH_MUST_USE;

/* Opens a technique as job_open does; fails with HATCH_BAD_INPUT if the scene lacks something that it draws.
 *   file  out: on failure, the name of the file that lacks it */
enum hatch_status job_check(struct job *job, const struct technique *technique, const char **file,
                            struct hatch_err *err) HATCH_MUST_USE;

/* Sets the upper end of --tone-range, if it was not given, to the darkest tone of the asset or the technique. */
void job_set_darkest(struct job *job, const struct technique_instance *instance);

/* Recomputes everything that depends on changed parameters.
 *   instance  the instance that draws
 *   subjects  bits 1 << enum param_subject of the changed parameters */
enum hatch_status job_refresh(struct job *job, struct technique_instance *instance, uint32_t subjects,
                              struct hatch_err *err) HATCH_MUST_USE;

/* Sets the parameters of --animate and the pose for a frame, and computes its view.
 *   frame  index from 0
 *   view   out */
void job_set_frame(struct job *job, uint32_t frame, struct hatch_view *view);

/* Foresees a frame of a film, which is posed.
 *   film  its number, from 1
 *   data  of the caller */
typedef enum hatch_status job_foresee(void *data, uint32_t film, const struct hatch_view *view, struct hatch_err *err);

/* Poses the scene for a frame of a film, the one after that of the last call, or the first. If it depends on later
 * ones, these are posed and foreseen before. Exits with a message on failure. Returns the number of the frame from 1,
 * or 0 if it does not depend on others.
 *   view  out */
uint32_t job_set_film_frame(struct job *job, uint32_t frame, job_foresee *foresee, void *data, struct hatch_view *view);

/* Computes the view that the options describe, at the scene's current pose.
 *   time_s  time of the animation at that pose
 *   view    out */
void job_view(struct job *job, double time_s, struct hatch_view *view);

/* Makes a canvas for the picture or for its tiles. Exits with a message when the GPU has no memory for it.
 *   canvas  out: owned by the caller */
void job_make_canvas(struct job *job, struct canvas *canvas);

/* Releases all GL objects and the context. */
void job_end(struct job *job);

#endif
