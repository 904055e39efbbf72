/* Parametric surfaces of all shapes but the teapot, and measurements of any parametric surface. */
#include "shapes/grid.h"

#include "math/vector.h"

#define PI 3.14159265358979323846
#define BUMP_HEIGHT 0.25
#define BUMP_REACH 0.5 /* 1 - cosine of the angle from its axis at which the bump ends */

static const double semi_axes[3] = {1.0, 0.7, 0.5};

/* Computes a point of a surface of revolution around y from the profile's radius, height and normal. */
static void revolve(double u, double radius, double height, double normal_radial, double normal_height,
                    struct hatch_parametric_point *point)
{
    double c = cos(2 * PI * u), s = sin(2 * PI * u);
    /* 0 is added to, or subtracted from, so that a pole has no -0. */
    *point = (struct hatch_parametric_point){
        .position = {radius * c + 0.0, height, 0.0 - radius * s},
        .normal = {normal_radial * c + 0.0, normal_height, 0.0 - normal_radial * s},
        .along_u = {-s, 0, -c},
    };
}

static void sphere_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    bool pole = v <= 0 || v >= 1; /* sin(π) is not exactly 0 */
    double radius = pole ? 0.0 : sin(PI * v);
    revolve(u, radius, cos(PI * v), radius, cos(PI * v), point);
}

static void ellipsoid_at(const struct hatch_parametric *surface, double u, double v,
                         struct hatch_parametric_point *point)
{
    sphere_at(surface, u, v, point);
    for (int k = 0; k < 3; k++) {
        point->position[k] *= semi_axes[k];
        point->normal[k] /= semi_axes[k];
        point->along_u[k] *= semi_axes[k];
    }
    hatch_vec_normalize(point->normal);
    hatch_vec_normalize(point->along_u);
}

static void cylinder_at(const struct hatch_parametric *surface, double u, double v,
                        struct hatch_parametric_point *point)
{
    (void)surface;
    revolve(u, 1, 1 - 2 * v, 1, 0, point);
}

static void cone_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    revolve(u, v, 1 - 2 * v, 2 / sqrt(5.0), 1 / sqrt(5.0), point);
}

static void torus_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    double c = cos(2 * PI * v), s = -sin(2 * PI * v);
    revolve(u, 1 + HATCH_TUBE_RADIUS * c, HATCH_TUBE_RADIUS * s, c, s, point);
}

static void plane_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    *point = (struct hatch_parametric_point){
        .position = {2 * u - 1, 1 - 2 * v, 0}, .normal = {0, 0, 1}, .along_u = {1, 0, 0}};
}

bool hatch_shape_height(enum hatch_shape shape, double x, double y, struct hatch_height *height)
{
    switch (shape) {
    case HATCH_SHAPE_SADDLE:
        *height = (struct hatch_height){.z = (x * x - y * y) / 2, .zx = x, .zy = -y, .zxx = 1, .zyy = -1};
        return true;
    case HATCH_SHAPE_WAVE:
        *height = (struct hatch_height){.z = sin(4 * x) / 8, .zx = cos(4 * x) / 2, .zxx = -2 * sin(4 * x)};
        return true;
    case HATCH_SHAPE_MONGE: {
        double sx = sin(2 * x), cx = cos(2 * x), sy = sin(1.5 * y), cy = cos(1.5 * y);
        *height = (struct hatch_height){.z = 0.25 * sx * cy + 0.1 * x * x,
                                        .zx = 0.5 * cx * cy + 0.2 * x,
                                        .zy = -0.375 * sx * sy,
                                        .zxx = -sx * cy + 0.2,
                                        .zxy = -0.75 * cx * sy,
                                        .zyy = -0.5625 * sx * cy};
        return true;
    }
    case HATCH_SHAPE_EGGBOX: {
        double sx = sin(3 * x), cx = cos(3 * x), sy = sin(3 * y), cy = cos(3 * y);
        *height = (struct hatch_height){.z = 0.15 * sx * sy,
                                        .zx = 0.45 * cx * sy,
                                        .zy = 0.45 * sx * cy,
                                        .zxx = -1.35 * sx * sy,
                                        .zxy = 1.35 * cx * cy,
                                        .zyy = -1.35 * sx * sy};
        return true;
    }
    default:
        return false;
    }
}

static void graph_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    double x = 2 * u - 1, y = 1 - 2 * v;
    struct hatch_height at;
    hatch_shape_height(surface->shape, x, y, &at);
    *point = (struct hatch_parametric_point){
        .position = {x, y, at.z}, .normal = {-at.zx, 0 - at.zy, 1}, .along_u = {1, 0, at.zx}};
    hatch_vec_normalize(point->normal);
    hatch_vec_normalize(point->along_u);
}

static void frustum_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    double y = 1 - 2 * v, across = 1 / sqrt(1 + HATCH_FRUSTUM_SLOPE * HATCH_FRUSTUM_SLOPE);
    (void)surface;
    revolve(u, 0.75 - HATCH_FRUSTUM_SLOPE * y, y, across, HATCH_FRUSTUM_SLOPE * across, point);
}

static void catenoid_at(const struct hatch_parametric *surface, double u, double v,
                        struct hatch_parametric_point *point)
{
    double y = 0.75 - 1.5 * v, c = cosh(y / HATCH_CATENOID_WAIST);
    (void)surface;
    revolve(u, HATCH_CATENOID_WAIST * c, y, 1 / c, -tanh(y / HATCH_CATENOID_WAIST), point);
}

static void helicoid_at(const struct hatch_parametric *surface, double u, double v,
                        struct hatch_parametric_point *point)
{
    double s = 2 * u - 1, t = PI - 2 * PI * v, c = cos(t);
    (void)surface;
    *point = (struct hatch_parametric_point){
        .position = {s * c, HATCH_HELICOID_RISE * t, -s * sin(t)},
        .normal = {sin(t), s / HATCH_HELICOID_RISE, c},
        .along_u = {c, 0, -sin(t)},
    };
    hatch_vec_normalize(point->normal);
}

double hatch_bump_radius(double cosine, double slope[2])
{
    double height = 1 - (1 - cosine) / BUMP_REACH;
    if (!(height > 0))
        height = 0;
    double square = height * height;
    slope[0] = 4 * BUMP_HEIGHT / BUMP_REACH * square * height;
    slope[1] = 12 * BUMP_HEIGHT / (BUMP_REACH * BUMP_REACH) * square;
    return 1 + BUMP_HEIGHT * square * square;
}

/* Moves a point of the unit sphere to a distance of radius from the centre.
 *   gradient  of the radius by the direction */
static void move_radially(double radius, const double gradient[3], struct hatch_parametric_point *point)
{
    double direction[3], inwards = hatch_vec_dot(gradient, point->position);
    double along = hatch_vec_dot(gradient, point->along_u);
    hatch_vec_copy(point->position, direction);
    for (int k = 0; k < 3; k++) {
        point->position[k] = radius * direction[k];
        point->normal[k] = radius * direction[k] - (gradient[k] - inwards * direction[k]);
        point->along_u[k] = radius * point->along_u[k] + along * direction[k];
    }
    hatch_vec_normalize(point->normal);
    hatch_vec_normalize(point->along_u);
}

static void superquadric_at(const struct hatch_parametric *surface, double u, double v,
                            struct hatch_parametric_point *point)
{
    double gradient[3], sum = 0;
    sphere_at(surface, u, v, point);
    for (int k = 0; k < 3; k++) {
        double x = point->position[k], axis = hatch_superquadric_axes[k];
        gradient[k] = x * x * x / (axis * axis * axis * axis);
        sum += x * gradient[k];
    }
    for (int k = 0; k < 3; k++)
        gradient[k] *= -1 / (sum * sqrt(sqrt(sum)));
    move_radially(1 / sqrt(sqrt(sum)), gradient, point);
}

static void bump_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    double gradient[3], slope[2];
    sphere_at(surface, u, v, point);
    double radius = hatch_bump_radius(hatch_vec_dot(point->position, hatch_bump_axis), slope);
    for (int k = 0; k < 3; k++)
        gradient[k] = slope[0] * hatch_bump_axis[k];
    move_radially(radius, gradient, point);
}

uint32_t hatch_shape_surfaces(enum hatch_shape shape, struct hatch_parametric *surfaces)
{
    static const struct hatch_parametric parametrics[HATCH_SHAPE_COUNT] = {
        [HATCH_SHAPE_SPHERE] = {.at = sphere_at, .wraps_u = true, .pole_first = true, .pole_last = true},
        [HATCH_SHAPE_CYLINDER] = {.at = cylinder_at, .wraps_u = true},
        [HATCH_SHAPE_CONE] = {.at = cone_at, .wraps_u = true, .pole_first = true},
        [HATCH_SHAPE_TORUS] = {.at = torus_at, .wraps_u = true, .wraps_v = true},
        [HATCH_SHAPE_PLANE] = {.at = plane_at},
        [HATCH_SHAPE_ELLIPSOID] = {.at = ellipsoid_at, .wraps_u = true, .pole_first = true, .pole_last = true},
        [HATCH_SHAPE_SADDLE] = {.at = graph_at},
        [HATCH_SHAPE_WAVE] = {.at = graph_at},
        [HATCH_SHAPE_FRUSTUM] = {.at = frustum_at, .wraps_u = true},
        [HATCH_SHAPE_MONGE] = {.at = graph_at},
        [HATCH_SHAPE_EGGBOX] = {.at = graph_at},
        [HATCH_SHAPE_SUPERQUADRIC] = {.at = superquadric_at, .wraps_u = true, .pole_first = true, .pole_last = true},
        [HATCH_SHAPE_BUMP] = {.at = bump_at, .wraps_u = true, .pole_first = true, .pole_last = true},
        [HATCH_SHAPE_HELICOID] = {.at = helicoid_at},
        [HATCH_SHAPE_CATENOID] = {.at = catenoid_at, .wraps_u = true},
    };
    if (shape == HATCH_SHAPE_TEAPOT)
        return hatch_teapot_surfaces(surfaces);
    surfaces[0] = parametrics[shape];
    surfaces[0].shape = shape;
    surfaces[0].u_pieces = surfaces[0].v_pieces = 1;
    return 1;
}

static void position_at(const struct hatch_parametric *surface, double u, double v, double out[3])
{
    struct hatch_parametric_point point;
    surface->at(surface, u, v, &point);
    hatch_vec_copy(point.position, out);
}

/* Measures the strip between two lines of constant v: its length along u, mean width along v, and area. */
static void measure_strip(const struct hatch_parametric *surface, double v, double v_next, double *length_u,
                          double *length_v, double *area)
{
    const uint32_t n = HATCH_GRID_SAMPLES;
    double step = (double)surface->u_pieces / n, a[3], b[3], c[3];
    *length_u = *length_v = *area = 0;
    for (uint32_t i = 0; i < n; i++) {
        position_at(surface, i * step, v, a);
        position_at(surface, (i + 1) * step, v, b);
        position_at(surface, i * step, v_next, c);
        double du = hatch_vec_distance(a, b), dv = hatch_vec_distance(a, c), normal[3];
        hatch_vec_triangle(a, b, c, normal);
        *length_u += du;
        *length_v += dv / n;
        *area += hatch_vec_length(normal);
    }
}

void hatch_parametric_measure(const struct hatch_parametric *surface, struct hatch_parametric_size *size)
{
    const uint32_t n = HATCH_GRID_SAMPLES;
    double area_sum = 0, u_sum = 0;
    for (uint32_t piece = 0; piece < surface->v_pieces; piece++) {
        size->v[piece] = 0;
        for (uint32_t j = 0; j < n; j++) {
            double length_u, length_v, area;
            double v = piece + (double)j / n;
            measure_strip(surface, v, piece + (double)(j + 1) / n, &length_u, &length_v, &area);
            u_sum += length_u * area;
            area_sum += area;
            size->v[piece] += length_v;
        }
    }
    size->u = u_sum / area_sum;
}

void hatch_parametric_even(const struct hatch_parametric *surface, double *share)
{
    const uint32_t n = HATCH_GRID_SAMPLES;
    for (uint32_t piece = 0; piece < surface->v_pieces; piece++) {
        double *row = &share[piece * (n + 1)];
        row[0] = 0;
        for (uint32_t j = 0; j < n; j++) {
            double length_u, length_v, area;
            double v = piece + (double)j / n;
            measure_strip(surface, v, piece + (double)(j + 1) / n, &length_u, &length_v, &area);
            row[j + 1] = row[j] + length_v;
        }
        for (uint32_t j = 1; j <= n; j++)
            row[j] = j == n ? 1.0 : row[j] / row[n];
    }
}
