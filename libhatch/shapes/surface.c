/* Parametric surfaces of all shapes but the teapot, and measurements of any parametric surface. */
#include "shapes/grid.h"

#include "math/vector.h"

#define PI 3.14159265358979323846
#define TUBE 0.4

static const double semi_axes[3] = {1.0, 0.7, 0.5};

/* Computes a point of a surface of revolution around y from the profile's radius, height and normal. */
static void revolve(double u, double radius, double height, double normal_radial, double normal_height,
                    struct hatch_parametric_point *point)
{
    double c = cos(2 * PI * u), s = sin(2 * PI * u);
    *point = (struct hatch_parametric_point){
        .position = {radius * c, height, -radius * s},
        .normal = {normal_radial * c, normal_height, -normal_radial * s},
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
    revolve(u, 1 + TUBE * c, TUBE * s, c, s, point);
}

static void plane_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    *point = (struct hatch_parametric_point){
        .position = {2 * u - 1, 1 - 2 * v, 0}, .normal = {0, 0, 1}, .along_u = {1, 0, 0}};
}

static void saddle_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    double x = 2 * u - 1, y = 1 - 2 * v;
    *point = (struct hatch_parametric_point){
        .position = {x, y, (x * x - y * y) / 2}, .normal = {-x, y, 1}, .along_u = {1, 0, x}};
    hatch_vec_normalize(point->normal);
    hatch_vec_normalize(point->along_u);
}

static void wave_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    (void)surface;
    double x = 2 * u - 1, y = 1 - 2 * v, slope = cos(4 * x) / 2;
    *point = (struct hatch_parametric_point){
        .position = {x, y, sin(4 * x) / 8}, .normal = {-slope, 0, 1}, .along_u = {1, 0, slope}};
    hatch_vec_normalize(point->normal);
    hatch_vec_normalize(point->along_u);
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
        [HATCH_SHAPE_SADDLE] = {.at = saddle_at},
        [HATCH_SHAPE_WAVE] = {.at = wave_at},
    };
    if (shape == HATCH_SHAPE_TEAPOT)
        return hatch_teapot_surfaces(surfaces);
    surfaces[0] = parametrics[shape];
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
