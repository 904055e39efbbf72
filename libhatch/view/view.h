/* Where the picture is taken from, in the unit scene (scene/pose.h). */
#ifndef HATCH_VIEW_VIEW_H
#define HATCH_VIEW_VIEW_H

#include "math/pair.h"
#include "scene/pose.h"

#define HATCH_VIEW_NEAR 1e-4 /* the near plane of views that have no wish, while nothing is nearer */

struct hatch_view {
    double eye[3];
    double eye_rest[3];              /* what doubles leave of the eye: both together are where it is */
    double right[3], up[3], back[3]; /* unit axes; the camera looks along -back */
    bool orthographic;
    double half_height;     /* perspective: of the picture at distance 1; orthographic: in units */
    double aspect;          /* width over height */
    double near, far;       /* far counts for orthographic views alone */
    bool near_is_automatic; /* near is nobody's wish: it may follow what there is to see */
    double pivot;           /* distance to what the camera looks at: what orbiting turns around */
};

/* Which view a command line asks for. */
enum hatch_view_kind {
    HATCH_VIEW_FIRST_CAMERA, /* the scene's first camera, or framed where it has none */
    HATCH_VIEW_CAMERA,       /* camera number index */
    HATCH_VIEW_FRAMED,       /* the whole scene fills the picture */
    HATCH_VIEW_EYE           /* from eye to target */
};

struct hatch_view_choice {
    enum hatch_view_kind kind;
    uint32_t index;
    double eye[3], target[3];          /* world coordinates */
    bool has_target;                   /* else the scene's middle */
    double azimuth_rad, elevation_rad; /* FRAMED: direction to the camera, from +z towards +x */
    double fov_rad;                    /* FRAMED and EYE: over the picture's height */
    bool turns;                        /* FRAMED: leave room for a full turn about the vertical */
};

/* A part of a picture, in pixels from its lower left corner. */
struct hatch_tile {
    double x, y, width, height;
    double full_width, full_height;
};

/* Does the view stay the same when the scene moves? Views through the scene's cameras may not. */
bool hatch_view_is_fixed(const struct hatch_view_choice *choice, const struct hatch_scene *scene);

/* What a view is fitted to. */
struct hatch_framing {
    const struct hatch_pose_span *span; /* a framed view shows all of its moments */
    const struct hatch_bounds *bounds;
    double aspect; /* of the picture: width over height */
};

/* Finds the view at the pose; where it is a framed one, the pose is at the last moment of the span then.
 * HATCH_BAD_INPUT for a camera that the scene does not have. */
enum hatch_status hatch_view_make(const struct hatch_view_choice *choice, struct hatch_pose *pose,
                                  const struct hatch_framing *framing, struct hatch_arena *scratch,
                                  struct hatch_view *view, struct hatch_err *err) HATCH_MUST_USE;

/* A coordinate of the world in the unit scene. */
struct hatch_pair hatch_view_unit(const struct hatch_bounds *bounds, int axis, double world);

/* The same view with the scene turned by angle_rad about the vertical through its middle. */
void hatch_view_turn(struct hatch_view *view, double angle_rad);

/* The near plane of a view that is moved from where it was made is nobody's wish any more. */
void hatch_view_free_near(struct hatch_view *view);

/* Puts the axes right for a direction to the camera; back need not be a unit vector. */
void hatch_view_set_back(struct hatch_view *view, const double back[3]);

/* Clip coordinates of a tile from the unit scene, column-major. Depth is 1 at the near plane and 0 far
 * away, which floats resolve evenly. */
void hatch_view_matrix(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_unit[16]);

/* The same from the camera's coordinates: right, up, back, from the eye. */
void hatch_view_lens(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_camera[16]);

/* How far off floats show places of the unit scene, in pixels: at distance 1, less farther away; for
 * orthographic views anywhere. */
double hatch_view_float_error(const struct hatch_view *view, const struct hatch_tile *tile);

/* Is a point inside the picture's frame, or a little beside it? */
bool hatch_view_sees(const struct hatch_view *view, const double point[3]);

/* How many pixels a unit of the unit scene is long at a point, for a picture height_px high; what lies
 * behind the camera goes by its distance. */
double hatch_view_pixels_per_unit(const struct hatch_view *view, const double point[3], double height_px);

/* Moves the view's eye along its axis until it is `factor` times nearer, or with a factor under 1 further, to the
 * face that the picture's middle shows; where it shows none, to what the camera looks at. moment: begin_s of its
 * animation counts. An orthographic view stays where it is and shows less. */
enum hatch_status hatch_view_zoom(struct hatch_pose *pose, const struct hatch_pose_span *moment,
                                  const struct hatch_bounds *bounds, double factor, struct hatch_arena *scratch,
                                  struct hatch_view *view, struct hatch_err *err) HATCH_MUST_USE;

#endif
