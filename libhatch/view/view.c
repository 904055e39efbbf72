#include "view/view.h"

#include <string.h>

#include "math/vector.h"

#define TURNS 24            /* number of angles at which a full turn is sampled for framing */
#define FLOAT_ERROR 0x1p-22 /* error of positions in the unit scene after transformation in floats */
#define FILL 0.92           /* share of the picture's sides that a framed scene fills */

static bool make_unit(double v[3])
{
    double length = hatch_vec_normalize(v);
    return length > 0 && isfinite(length);
}

void hatch_view_set_back(struct hatch_view *view, const double back[3])
{
    static const double vertical[3] = {0, 1, 0}, depth[3] = {0, 0, 1};
    memcpy(view->back, back, sizeof view->back);
    if (!make_unit(view->back))
        memcpy(view->back, depth, sizeof depth);
    hatch_vec_cross(vertical, view->back, view->right);
    if (hatch_vec_dot(view->right, view->right) < 1e-12)
        hatch_vec_cross(view->back[1] > 0 ? (const double[3]){0, 0, -1} : depth, view->back, view->right);
    make_unit(view->right);
    hatch_vec_cross(view->back, view->right, view->up);
}

/* Extents of the scene, for framing it. */
struct fit {
    const struct hatch_view *view;
    const struct hatch_bounds *bounds;
    int turns;
    double cosines[TURNS], sines[TURNS]; /* of the angles of the turns */
    double left, right, down, up; /* per side of the frustum: largest ±x + z·tan of any corner; see frame_scene */
    double nearest;               /* largest z: that of the corner nearest to the camera */
    bool any;
};

static void fit_point(void *context, const double point[3])
{
    struct fit *fit = context;
    const struct hatch_view *view = fit->view;
    double tan_y = FILL * view->half_height, tan_x = tan_y * view->aspect;
    double p[3];
    hatch_bounds_to_unit(fit->bounds, point, p);
    for (int turn = 0; turn < fit->turns; turn++) {
        double c = fit->cosines[turn], s = fit->sines[turn];
        double q[3] = {c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]};
        double x = hatch_vec_dot(q, view->right), y = hatch_vec_dot(q, view->up), z = hatch_vec_dot(q, view->back);
        fit->right = fit->any ? fmax(fit->right, x + z * tan_x) : x + z * tan_x;
        fit->left = fit->any ? fmax(fit->left, z * tan_x - x) : z * tan_x - x;
        fit->up = fit->any ? fmax(fit->up, y + z * tan_y) : y + z * tan_y;
        fit->down = fit->any ? fmax(fit->down, z * tan_y - y) : z * tan_y - y;
        fit->nearest = fit->any ? fmax(fit->nearest, z) : z;
        fit->any = true;
    }
}

/* Computes the nearest eye from which all corners of all faces are inside the picture. Opposite sides of the frustum
 * should pass through the corners that are furthest out, which determines the sideways shift and a distance; the larger
 * of the distances for width and height is taken. */
static enum hatch_status frame_scene(const struct hatch_view_choice *choice, struct hatch_pose *pose,
                                     const struct hatch_framing *framing, struct hatch_arena *scratch,
                                     struct hatch_view *view, struct hatch_err *err)
{
    double level = cos(choice->elevation_rad);
    hatch_view_set_back(view, (const double[3]){level * sin(choice->azimuth_rad), sin(choice->elevation_rad),
                                                level * cos(choice->azimuth_rad)});
    view->half_height = tan(0.5 * choice->fov_rad);
    struct fit fit = {.view = view, .bounds = framing->bounds, .turns = choice->turntable ? TURNS : 1};
    for (int turn = 0; turn < fit.turns; turn++) {
        double angle = 2.0 * 3.14159265358979324 * turn / fit.turns;
        fit.cosines[turn] = cos(angle);
        fit.sines[turn] = sin(angle);
    }
    HATCH_TRY(hatch_pose_each_corner(pose, framing->span, scratch, fit_point, &fit, err));
    double tan_y = FILL * view->half_height, tan_x = tan_y * view->aspect;
    double x = 0.5 * (fit.right - fit.left), y = 0.5 * (fit.up - fit.down);
    double distance = fmax(0.5 * (fit.right + fit.left) / tan_x, 0.5 * (fit.up + fit.down) / tan_y);
    if (!fit.any)
        distance = 1.0 / tan_y;
    distance = fmax(distance, fit.nearest + 0.02);
    for (int k = 0; k < 3; k++)
        view->eye[k] = distance * view->back[k] + x * view->right[k] + y * view->up[k];
    view->near = HATCH_VIEW_NEAR;
    view->near_is_automatic = true;
    view->pivot = distance;
    return HATCH_OK;
}

struct hatch_pair hatch_view_to_unit(const struct hatch_bounds *bounds, int axis, double world)
{
    return hatch_pair_div(hatch_pair_sum(world, -bounds->center[axis]), hatch_pair_of(bounds->radius));
}

/* Sets the projection. If the picture is narrower than the camera's aspect, it shows more above and below, so that it
 * still contains all that the camera sees. */
static void set_lens(const struct hatch_camera *camera, double radius, double aspect, struct hatch_view *view)
{
    double half = camera->orthographic ? (double)camera->ymag / radius : tan(0.5 * (double)camera->yfov_rad);
    double camera_aspect = camera->aspect > 0 ? (double)camera->aspect : aspect;
    view->orthographic = camera->orthographic;
    view->half_height = camera_aspect > aspect ? half * camera_aspect / aspect : half;
    view->near = (double)camera->znear / radius;
    view->far = camera->zfar > camera->znear ? (double)camera->zfar / radius : view->near + 1e4;
    if (!camera->orthographic)
        view->near = fmax(view->near, 1e-7);
    view->finite = !camera->orthographic && camera->zfar > camera->znear && view->far > view->near;
}

static enum hatch_status look_through(uint32_t index, const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                                      double aspect, struct hatch_view *view, struct hatch_err *err)
{
    const struct hatch_scene *scene = pose->scene;
    uint32_t node = 0;
    while (node < scene->node_count && scene->nodes[node].camera != index)
        node++;
    if (index >= scene->camera_count || node == scene->node_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "camera %u is not in the scene; its files define %u, numbered from 0",
                          index, scene->camera_count);
    double world[16];
    hatch_pose_matrix(pose, node, world);
    double back[3] = {world[8], world[9], world[10]}, up[3] = {world[4], world[5], world[6]};
    if (!make_unit(back) || !make_unit(up))
        return hatch_fail(err, HATCH_BAD_INPUT, "camera %u: its node is scaled to zero", index);
    memcpy(view->back, back, sizeof back);
    hatch_vec_cross(up, back, view->right);
    make_unit(view->right);
    hatch_vec_cross(back, view->right, view->up);
    for (int k = 0; k < 3; k++) {
        struct hatch_pair eye = hatch_view_to_unit(bounds, k, world[12 + k]);
        view->eye[k] = eye.high;
        view->eye_low[k] = eye.low;
    }
    view->pivot = fmax(hatch_vec_dot(view->eye, view->back), 0.05);
    set_lens(&scene->cameras[index], bounds->radius, aspect, view);
    return HATCH_OK;
}

static enum hatch_status look_from(const struct hatch_view_choice *choice, const struct hatch_bounds *bounds,
                                   struct hatch_view *view, struct hatch_err *err)
{
    double back[3];
    for (int k = 0; k < 3; k++) {
        struct hatch_pair eye = hatch_view_to_unit(bounds, k, choice->eye[k]);
        back[k] = (choice->eye[k] - (choice->has_target ? choice->target[k] : bounds->center[k])) / bounds->radius;
        view->eye[k] = eye.high;
        view->eye_low[k] = eye.low;
    }
    if (!(hatch_vec_dot(back, back) > 0))
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "the camera stands on its target: "
                          "--camera X,Y,Z:X,Y,Z names two different points");
    view->half_height = tan(0.5 * choice->fov_rad);
    view->near = HATCH_VIEW_NEAR;
    view->near_is_automatic = true;
    view->pivot = sqrt(hatch_vec_dot(back, back));
    hatch_view_set_back(view, back);
    return HATCH_OK;
}

/* Returns the index of the camera of the first node that has one, or HATCH_NONE. */
static uint32_t first_camera(const struct hatch_scene *scene)
{
    for (uint32_t node = 0; node < scene->node_count; node++)
        if (scene->nodes[node].camera != HATCH_NONE)
            return scene->nodes[node].camera;
    return HATCH_NONE;
}

bool hatch_view_is_fixed(const struct hatch_view_choice *choice, const struct hatch_scene *scene)
{
    bool through_camera = choice->kind == HATCH_VIEW_CAMERA ||
                          (choice->kind == HATCH_VIEW_FIRST_CAMERA && first_camera(scene) != HATCH_NONE);
    return !through_camera;
}

enum hatch_status hatch_view_make(const struct hatch_view_choice *choice, struct hatch_pose *pose,
                                  const struct hatch_framing *framing, struct hatch_arena *scratch,
                                  struct hatch_view *view, struct hatch_err *err)
{
    struct hatch_view made = {.aspect = framing->aspect};
    uint32_t camera = choice->kind == HATCH_VIEW_FIRST_CAMERA ? first_camera(pose->scene) : choice->index;
    if (!hatch_view_is_fixed(choice, pose->scene))
        HATCH_TRY(look_through(camera, pose, framing->bounds, framing->aspect, &made, err));
    else if (choice->kind == HATCH_VIEW_EYE)
        HATCH_TRY(look_from(choice, framing->bounds, &made, err));
    else
        HATCH_TRY(frame_scene(choice, pose, framing, scratch, &made, err));
    *view = made;
    return HATCH_OK;
}

void hatch_view_set_near_automatic(struct hatch_view *view)
{
    if (view->orthographic)
        return;
    view->near = fmin(view->near, HATCH_VIEW_NEAR);
    view->near_is_automatic = true;
}

static void turn(double v[3], double c, double s)
{
    double x = c * v[0] + s * v[2];
    v[2] = c * v[2] - s * v[0];
    v[0] = x;
}

void hatch_view_turn(struct hatch_view *view, double angle_rad)
{
    double c = cos(angle_rad), s = sin(angle_rad);
    turn(view->eye, c, s);
    turn(view->eye_low, c, s);
    turn(view->right, c, s);
    turn(view->up, c, s);
    turn(view->back, c, s);
}

bool hatch_view_ends(const struct hatch_view *view)
{
    return view->orthographic || view->finite;
}

double hatch_view_depth_shift(const struct hatch_view *view)
{
    return view->finite ? view->near / (view->far - view->near) : 0;
}

/* Converts a point or a direction from camera coordinates to clip coordinates of a tile: a column of a matrix.
 *   column  [3]: 1 for a point, 0 for a direction */
static void through_lens(const struct hatch_view *view, const struct hatch_tile *tile, const double column[4],
                         float clip[4])
{
    double scale[2] = {tile->full_width / tile->width, tile->full_height / tile->height};
    double shift[2] = {(tile->full_width - 2 * tile->x) / tile->width - 1,
                       (tile->full_height - 2 * tile->y) / tile->height - 1};
    double lens[2] = {1 / (view->half_height * view->aspect), 1 / view->half_height};
    double w = view->orthographic ? column[3] : -column[2];
    for (int row = 0; row < 2; row++)
        clip[row] = (float)(scale[row] * lens[row] * column[row] + shift[row] * w);
    double depth = hatch_view_ends(view) ? (column[2] + view->far * column[3]) / (view->far - view->near) : column[3];
    clip[2] = (float)(view->orthographic ? depth : view->near * depth);
    clip[3] = (float)w;
}

void hatch_view_matrix(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_unit[16])
{
    const double *axes[3] = {view->right, view->up, view->back};
    for (int column = 0; column < 4; column++) {
        double camera[4] = {0, 0, 0, column == 3 ? 1.0 : 0.0};
        for (int row = 0; row < 3; row++)
            camera[row] = column < 3 ? axes[row][column] : -hatch_vec_dot(axes[row], view->eye);
        through_lens(view, tile, camera, clip_from_unit + 4 * column);
    }
}

void hatch_view_projection(const struct hatch_view *view, const struct hatch_tile *tile, float clip_from_camera[16])
{
    for (int column = 0; column < 4; column++) {
        double camera[4] = {0, 0, 0, 0};
        camera[column] = 1;
        through_lens(view, tile, camera, clip_from_camera + 4 * column);
    }
}

double hatch_view_float_error(const struct hatch_view *view, const struct hatch_tile *tile)
{
    return FLOAT_ERROR * 0.5 * tile->full_height / view->half_height;
}

bool hatch_view_sees(const struct hatch_view *view, const double point[3])
{
    double to[3] = {point[0] - view->eye[0], point[1] - view->eye[1], point[2] - view->eye[2]};
    double depth = -hatch_vec_dot(to, view->back);
    double high = 1.1 * view->half_height * (view->orthographic ? 1.0 : depth);
    bool ahead = depth > view->near && (!hatch_view_ends(view) || depth < view->far);
    return ahead && fabs(hatch_vec_dot(to, view->up)) < high &&
           fabs(hatch_vec_dot(to, view->right)) < high * view->aspect;
}

double hatch_view_pixels_per_unit(const struct hatch_view *view, const double point[3], double height_px)
{
    double from[3] = {view->eye[0] - point[0], view->eye[1] - point[1], view->eye[2] - point[2]};
    double depth = hatch_vec_dot(from, view->back);
    double distance = depth > view->near ? depth : fmax(sqrt(hatch_vec_dot(from, from)), view->near);
    return height_px / (2 * view->half_height * (view->orthographic ? 1.0 : distance));
}
