/* Zooming to the face in the middle of a picture. */
#include "view/view.h"

#include "math/vector.h"

/* State of intersecting the view axis with faces. */
struct ray {
    const struct hatch_view *view;
    const struct hatch_bounds *bounds;
    double corners[3][3]; /* of a face, relative to the eye */
    int corner;           /* number of corners received, modulo 3 */
    double distance;      /* distance of the nearest face on the view axis */
};

/* Intersects the view axis with a face. The axis passes through the face if its triple products with all three sides
 * have the same sign. */
static void intersect_face(struct ray *ray)
{
    const double *back = ray->view->back;
    double side[3], volume = 0, depth = 0;
    for (int k = 0; k < 3; k++) {
        double normal[3];
        hatch_vec_cross(ray->corners[(k + 1) % 3], ray->corners[(k + 2) % 3], normal);
        side[k] = -hatch_vec_dot(back, normal);
        volume += side[k];
    }
    bool inside = (side[0] >= 0 && side[1] >= 0 && side[2] >= 0) || (side[0] <= 0 && side[1] <= 0 && side[2] <= 0);
    if (!inside || volume == 0)
        return;
    for (int k = 0; k < 3; k++)
        depth -= side[k] / volume * hatch_vec_dot(ray->corners[k], back);
    if (depth > 0 && (!hatch_view_ends(ray->view) || depth <= ray->view->far))
        ray->distance = fmin(ray->distance, depth);
}

static void take_corner(void *context, const double point[3])
{
    struct ray *ray = context;
    double *corner = ray->corners[ray->corner];
    hatch_bounds_to_unit(ray->bounds, point, corner);
    hatch_vec_sub(corner, ray->view->eye, corner);
    ray->corner = (ray->corner + 1) % 3;
    if (ray->corner == 0)
        intersect_face(ray);
}

enum hatch_status hatch_view_find_middle(struct hatch_pose *pose, const struct hatch_pose_span *moment,
                                         const struct hatch_bounds *bounds, const struct hatch_view *view,
                                         struct hatch_arena *scratch, struct hatch_view_middle *middle,
                                         struct hatch_err *err)
{
    struct ray ray = {.view = view, .bounds = bounds, .distance = INFINITY};
    HATCH_TRY(hatch_pose_each_corner(pose, moment, scratch, take_corner, &ray, err));
    *middle = (struct hatch_view_middle){.distance = isfinite(ray.distance) ? ray.distance : view->pivot};
    for (int k = 0; k < 3; k++) {
        middle->eye[k] = view->eye[k];
        middle->point[k] = view->eye[k] - middle->distance * view->back[k];
    }
    return HATCH_OK;
}

void hatch_view_zoom(const struct hatch_view_middle *middle, double factor, struct hatch_view *view)
{
    if (view->orthographic) { /* moving the eye would not enlarge anything */
        view->half_height /= factor;
        return;
    }
    double distance = middle->distance;
    if (hatch_vec_distance(view->eye, middle->eye) > 0) /* else it would be rounded */
        distance = fmin(distance, hatch_vec_distance(view->eye, middle->point));
    struct hatch_pair step = hatch_pair_sum(distance / factor, -distance);
    for (int k = 0; k < 3; k++) {
        struct hatch_pair eye = {view->eye[k], view->eye_low[k]};
        eye = hatch_pair_add(eye, hatch_pair_scale(step, view->back[k]));
        view->eye[k] = eye.high;
        view->eye_low[k] = eye.low;
    }
    view->pivot = distance > 0 ? distance / factor : view->pivot;
    hatch_view_set_near_automatic(view);
    view->far = fmax(view->far + step.high, 2 * view->near);
}
