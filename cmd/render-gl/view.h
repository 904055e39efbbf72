/* Where the picture is taken from, in the unit scene (render-gl/pose.h). */
#ifndef RENDER_VIEW_H
#define RENDER_VIEW_H

#include "math/pair.h"
#include "render-gl/pose.h"

#define VIEW_NEAR 1e-4 /* the near plane of views that have no wish, while nothing is nearer */

struct view {
    double eye[3];
    double eye_rest[3]; /* what doubles leave of the eye: both together are where it is */
    double right[3], up[3], back[3]; /* unit axes; the camera looks along -back */
    bool orthographic;
    double half_height; /* perspective: of the picture at distance 1; orthographic: in units */
    double aspect;      /* width over height */
    double near, far;   /* far counts for orthographic views alone */
    bool near_is_own;   /* near is nobody's wish: it may follow what there is to see */
    double pivot;       /* distance to what the camera looks at: what orbiting turns around */
};

/* Which view a command line asks for. */
enum view_kind {
    VIEW_FIRST_CAMERA, /* the scene's first camera, or framed where it has none */
    VIEW_CAMERA,       /* camera number index */
    VIEW_FRAMED,       /* the whole scene fills the picture */
    VIEW_EYE           /* from eye to target */
};

struct view_choice {
    enum view_kind kind;
    uint32_t index;
    double eye[3], target[3];            /* world coordinates */
    bool has_target;                     /* else the scene's middle */
    double azimuth_rad, elevation_rad;   /* FRAMED: direction to the camera, from +z towards +x */
    double fov_rad;                      /* FRAMED and EYE: over the picture's height */
    bool turns;                          /* FRAMED: leave room for a full turn about the vertical */
};

/* A part of a picture, in pixels from its lower left corner. */
struct tile {
    double x, y, width, height;
    double full_width, full_height;
};

/* Does the view stay the same when the scene moves? Views through the scene's cameras may not. */
bool view_is_fixed(const struct view_choice *choice, const struct hatch_scene *scene);

/* Finds the view at the pose. A framed view shows all of the span's moments, and the pose is at the
 * last of them then. HATCH_BAD_INPUT for a camera that the scene has not. */
enum hatch_status view_make(const struct view_choice *choice, struct pose *pose,
                            const struct pose_span *span, const struct bounds *bounds,
                            double aspect, struct hatch_arena *scratch, struct view *view,
                            struct hatch_err *err) HATCH_MUST_USE;

/* A coordinate of the world in the unit scene. */
struct hatch_pair view_unit(const struct bounds *bounds, int axis, double world);

/* The same view with the scene turned by angle_rad about the vertical through its middle. */
void view_turn(struct view *view, double angle_rad);

/* The near plane of a view that is moved from where it was made is nobody's wish any more. */
void view_free_near(struct view *view);

/* Puts the axes right for a direction to the camera; back need not be a unit vector. */
void view_set_back(struct view *view, const double back[3]);

/* Clip coordinates of a tile from the unit scene, column-major. Depth is 1 at the near plane and 0 far
 * away, which floats resolve evenly. */
void view_matrix(const struct view *view, const struct tile *tile, float clip_from_unit[16]);

/* The same from the camera's coordinates: right, up, back, from the eye. */
void view_lens(const struct view *view, const struct tile *tile, float clip_from_camera[16]);

/* How far off floats show places of the unit scene, in pixels: at distance 1, less farther away; for
 * orthographic views anywhere. */
double view_float_error(const struct view *view, const struct tile *tile);

/* Is a point inside the picture's frame, or a little beside it? */
bool view_sees(const struct view *view, const double point[3]);

/* How many pixels a unit of the unit scene is long at a point, for a picture height_px high; what lies
 * behind the camera goes by its distance. */
double view_pixels_per_unit(const struct view *view, const double point[3], double height_px);

#endif
