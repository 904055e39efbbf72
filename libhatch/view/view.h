/* The camera of a picture, in the unit scene (scene/pose.h). */
#ifndef HATCH_VIEW_VIEW_H
#define HATCH_VIEW_VIEW_H

#include "math/pair.h"
#include "scene/pose.h"

#define HATCH_VIEW_NEAR 1e-4 /* default distance of the near plane; it is smaller if a face is nearer */

struct hatch_view {
    double eye[3];                   /* position, high part (math/pair.h) */
    double eye_low[3];               /* position, low part */
    double right[3], up[3], back[3]; /* orthonormal axes; the camera looks along -back */
    bool orthographic;
    double half_height;     /* half the picture's height: at distance 1 (perspective) or everywhere (orthographic) */
    double aspect;          /* width / height */
    double near, far;       /* distances of the clipping planes; far is used by orthographic and finite views */
    bool finite;            /* the far plane clips a perspective view, too */
    bool near_is_automatic; /* the near plane may be moved closer where a face is near */
    double pivot;           /* distance to the point that orbiting turns around, over 0 */
};

/* Kinds of views. */
enum hatch_view_kind {
    HATCH_VIEW_FIRST_CAMERA, /* the scene's first camera; HATCH_VIEW_FRAMED where it has none */
    HATCH_VIEW_CAMERA,       /* the scene's camera number `index` */
    HATCH_VIEW_FRAMED,       /* a view in which the whole scene fills the picture */
    HATCH_VIEW_EYE           /* from eye to target */
};

/* A view as a user chooses it. */
struct hatch_view_choice {
    enum hatch_view_kind kind;
    uint32_t index;                    /* CAMERA: number of the camera in the scene */
    double eye[3], target[3];          /* EYE: world coordinates */
    bool has_target;                   /* EYE: false: the target is the centre of the bounds */
    double azimuth_rad, elevation_rad; /* FRAMED: direction to the camera; azimuth from +z towards +x */
    double fov_rad;                    /* FRAMED and EYE: vertical field of view, over 0 .. π */
    bool turntable; /* FRAMED: the scene stays in the picture during a full turn about the vertical */
};

/* A rectangle of a picture, in pixels. */
struct hatch_tile {
    double x, y, width, height;     /* x, y: its lower left corner */
    double full_width, full_height; /* size of the whole picture */
};

/* Returns whether the view is independent of the pose; a view through one of the scene's cameras may not be. */
bool hatch_view_is_fixed(const struct hatch_view_choice *choice, const struct hatch_scene *scene);

/* The scene and picture that a view is made for. */
struct hatch_framing {
    const struct hatch_pose_span *span; /* FRAMED: the moments that the view shows */
    const struct hatch_bounds *bounds;  /* bounds that define the unit scene */
    double aspect;                      /* width / height of the picture */
};

/* Computes the view at a pose.
 *   pose  in, out: a framed view leaves it at the last moment of the span
 * HATCH_BAD_INPUT for a camera that the scene does not have, that no node carries or whose node has no size, and for an
 * eye at its target. */
enum hatch_status hatch_view_make(const struct hatch_view_choice *choice, struct hatch_pose *pose,
                                  const struct hatch_framing *framing, struct hatch_arena *scratch,
                                  struct hatch_view *view, struct hatch_err *err) HATCH_MUST_USE;

/* Converts one world coordinate to the unit scene, in double-double precision.
 *   axis  0 .. 2 */
struct hatch_pair hatch_view_to_unit(const struct hatch_bounds *bounds, int axis, double world);

/* Rotates the view about the vertical axis through the origin of the unit scene. */
void hatch_view_turn(struct hatch_view *view, double angle_rad);

/* Makes the near plane of a perspective view automatic, at a distance of at most HATCH_VIEW_NEAR. For views that
 * move. */
void hatch_view_set_near_automatic(struct hatch_view *view);

/* Sets the axes of an upright view.
 *   back  direction to the camera, of any length */
void hatch_view_set_back(struct hatch_view *view, const double back[3]);

/* Returns whether the far plane clips the view. */
bool hatch_view_ends(const struct hatch_view *view);

/* Returns what a finite perspective view subtracts from depth: depth plus shift is inversely proportional to the
 * distance, and 1 plus shift at the near plane. 0 for other views. */
double hatch_view_depth_shift(const struct hatch_view *view);

/* Computes the matrix from the unit scene to clip coordinates of a tile. Depth is reversed, which suits the precision
 * of floats: 1 at the near plane, and 0 at the far plane, or at infinity if the view does not end.
 *   clip_from_unit  out: column-major */
void hatch_view_matrix(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_unit[16]);

/* Computes the matrix from camera coordinates (right, up, back, relative to the eye) to clip coordinates of a tile.
 *   clip_from_camera  out: column-major */
void hatch_view_projection(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_camera[16]);

/* Returns the error that float positions in the unit scene cause in the picture, in pixels. For a perspective view it
 * is that at distance 1 from the eye, and inversely proportional to the distance; for an orthographic view it is the
 * same everywhere. */
double hatch_view_float_error(const struct hatch_view *view, const struct hatch_tile *tile);

/* Returns whether a point is between the near and the far plane, and inside the picture or at most 10 % of its half
 * width or half height outside. */
bool hatch_view_sees(const struct hatch_view *view, const double point[3]);

/* Returns how many pixels a length of 1 in the unit scene covers at a point. For points behind the camera it is
 * computed from their distance to the eye.
 *   height_px  of the picture */
double hatch_view_pixels_per_unit(const struct hatch_view *view, const double point[3], double height_px);

/* The surface in the middle of a picture. */
struct hatch_view_middle {
    double eye[3];   /* of the view in which it was found */
    double point[3]; /* on the surface */
    double distance; /* from the eye, over 0 */
};

/* Finds the face that is nearest on the view axis, up to the far plane; without one, the pivot is taken as the surface.
 *   pose    in, out: left at the moment
 *   moment  the only one of its span
 *   view    perspective or orthographic; not zoomed */
enum hatch_status hatch_view_find_middle(struct hatch_pose *pose, const struct hatch_pose_span *moment,
                                         const struct hatch_bounds *bounds, const struct hatch_view *view,
                                         struct hatch_arena *scratch, struct hatch_view_middle *middle,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Moves the eye along the view axis: in the view in which the middle was found, until it is closer to that by a factor;
 * in others by the same length, or, if their eye is nearer to the middle, until that distance is divided by the factor.
 * The views of a film that share a middle are therefore as steady as they were. The far plane stays in its place. For
 * an orthographic view, half the picture's height is divided by the factor instead.
 *   factor  over 0 */
void hatch_view_zoom(const struct hatch_view_middle *middle, double factor, struct hatch_view *view);

#endif
