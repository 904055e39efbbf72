/* The teapot of Martin Newell (University of Utah, 1975) as published by Crow, "The Origins of the Teapot", IEEE CG&A
 * 7(1), 1987: 32 bicubic Bézier patches over 306 control points. The wall (rim, body and bottom) and the lid are
 * surfaces of revolution: four quarters share one profile. Handle and spout are mirrored: two halves share one set of
 * points. The tables hold each number once. */
#include "shapes/grid.h"

#include "math/vector.h"

/* A control point of a profile: radius, distance of the quarter circle's inner control points (0.56 of the radius
 * except on the knob), and height. Pieces share their end rows. */
struct profile_point {
    double radius, inner, height;
};

static const struct profile_point wall[] = {
    {1.4, .784, 2.4},  {1.3375, .749, 2.53125}, {1.4375, .805, 2.53125}, {1.5, .84, 2.4},   {1.75, .98, 1.875},
    {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9},        {2.0, 1.12, 0.45},       {1.5, .84, 0.225}, {1.5, .84, 0.15},
    {1.5, .84, 0.075}, {1.425, .798, 0.0},      {0.0, 0.0, 0.0},
};

static const struct profile_point lid[] = {
    {0.0, 0.0, 3.15},  {0.8, .45, 3.15},  {0.0, 0.0, 2.85}, {0.2, .112, 2.7},
    {0.4, .224, 2.55}, {1.3, .728, 2.55}, {1.3, .728, 2.4},
};

/* A ring of a tube: two points on the mirror plane, left and right of the tube's axis in its direction, and the
 * distance of the control points between them from that plane. */
struct ring {
    double x0, z0, x1, z1, outward;
};

static const struct ring handle[] = {
    {-1.6, 2.025, -1.5, 2.25, .3}, {-2.3, 2.025, -2.5, 2.25, .3}, {-2.7, 2.025, -3.0, 2.25, .3},
    {-2.7, 1.8, -3.0, 1.8, .3},    {-2.7, 1.575, -3.0, 1.35, .3}, {-2.5, 1.125, -2.65, .9375, .3},
    {-2.0, 0.9, -1.9, 0.6, .3},
};

static const struct ring spout[] = {
    {1.7, 1.425, 1.7, 0.6, .66}, {2.6, 1.425, 3.1, .825, .66},      {2.3, 2.1, 2.4, 2.025, .25},
    {2.7, 2.4, 3.3, 2.4, .25},   {2.8, 2.475, 3.525, 2.49375, .25}, {2.9, 2.475, 3.45, 2.5125, .15},
    {2.8, 2.4, 3.2, 2.4, .15},
};

/* Published: z up, 6.43 wide, standing on z = 0. Here: y up, 3 wide, centred. */
#define CENTRE_X 0.2142857142857143
#define CENTRE_Z 1.575
#define SCALE 0.4666666666666667

static void cubic_weights(double t, double weight[4], double slope[4])
{
    double s = 1 - t;
    weight[0] = s * s * s;
    weight[1] = 3 * s * s * t;
    weight[2] = 3 * s * t * t;
    weight[3] = t * t * t;
    slope[0] = -3 * s * s;
    slope[1] = 3 * s * (s - 2 * t);
    slope[2] = 3 * t * (2 * s - t);
    slope[3] = 3 * t * t;
}

/* Control point i of quarter 0..3 of a circle, in the order of rising u: from +x towards +y. */
static void quarter_point(const struct profile_point *row, int quarter, int i, double out[3])
{
    const double x[4] = {row->radius, row->radius, row->inner, 0.0};
    const double y[4] = {0.0, row->inner, row->radius, row->radius};
    static const double turn[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    double c = turn[quarter][0], s = turn[quarter][1];
    out[0] = c * x[i] - s * y[i];
    out[1] = s * x[i] + c * y[i];
    out[2] = row->height;
}

/* Control point i of half 0..1 of a tube's ring. */
static void ring_point(const struct ring *row, int half, int i, double out[3])
{
    bool first = (i < 2) == (half == 0);
    out[0] = first ? row->x0 : row->x1;
    out[1] = i == 0 || i == 3 ? 0.0 : half == 0 ? row->outward : -row->outward;
    out[2] = first ? row->z0 : row->z1;
}

typedef void (*control_point)(const void *rows, int row, int piece, int i, double out[3]);

static void wall_control(const void *rows, int row, int piece, int i, double out[3])
{
    quarter_point((const struct profile_point *)rows + row, piece, i, out);
}

static void tube_control(const void *rows, int row, int piece, int i, double out[3])
{
    ring_point((const struct ring *)rows + row, piece, i, out);
}

/* Position and the two partial derivatives, in the published frame. */
static void evaluate(const struct hatch_parametric *surface, control_point control, double u, double v, double p[3],
                     double du[3], double dv[3])
{
    int column = (int)u, row = (int)v;
    if (column >= (int)surface->u_pieces)
        column = (int)surface->u_pieces - 1;
    if (row >= (int)surface->v_pieces)
        row = (int)surface->v_pieces - 1;
    double bu[4], su[4], bv[4], sv[4];
    cubic_weights(u - column, bu, su);
    cubic_weights(v - row, bv, sv);
    for (int k = 0; k < 3; k++)
        p[k] = du[k] = dv[k] = 0;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            double c[3];
            control(surface->context, 3 * row + j, column, i, c);
            hatch_vec_add_scaled(p, bv[j] * bu[i], c, p);
            hatch_vec_add_scaled(du, bv[j] * su[i], c, du);
            hatch_vec_add_scaled(dv, sv[j] * bu[i], c, dv);
        }
}

static void to_y_up(double a[3])
{
    double y = a[1];
    a[1] = a[2];
    a[2] = -y;
}

static void patch_at(const struct hatch_parametric *surface, control_point control, double u, double v,
                     struct hatch_parametric_point *point)
{
    double *p = point->position, du[3], dv[3];
    evaluate(surface, control, u, v, p, du, dv);
    bool pole = (surface->pole_first && v <= 0) || (surface->pole_last && v >= surface->v_pieces);
    if (pole) {
        /* The profile is orthogonal to the axis here; the direction of rising u is taken from near the pole. */
        double away = surface->pole_first && v <= 0 ? 1e-3 : (double)surface->v_pieces - 1e-3;
        double q[3], qv[3];
        evaluate(surface, control, u, away, q, du, qv);
        point->normal[0] = point->normal[1] = 0;
        point->normal[2] = away < 1 ? 1 : -1;
    } else {
        hatch_vec_cross(dv, du, point->normal);
        hatch_vec_normalize(point->normal);
    }
    hatch_vec_add_scaled(du, -hatch_vec_dot(du, point->normal), point->normal, point->along_u);
    hatch_vec_normalize(point->along_u);
    p[0] -= CENTRE_X;
    p[2] -= CENTRE_Z;
    for (int k = 0; k < 3; k++)
        p[k] *= SCALE;
    to_y_up(p);
    to_y_up(point->normal);
    to_y_up(point->along_u);
}

static void turned_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    patch_at(surface, wall_control, u, v, point);
}

static void tube_at(const struct hatch_parametric *surface, double u, double v, struct hatch_parametric_point *point)
{
    patch_at(surface, tube_control, u, v, point);
}

uint32_t hatch_teapot_surfaces(struct hatch_parametric *surfaces)
{
    surfaces[0] = (struct hatch_parametric){
        .at = turned_at, .context = wall, .u_pieces = 4, .v_pieces = 4, .wraps_u = true, .pole_last = true};
    surfaces[1] = (struct hatch_parametric){
        .at = turned_at, .context = lid, .u_pieces = 4, .v_pieces = 2, .wraps_u = true, .pole_first = true};
    surfaces[2] =
        (struct hatch_parametric){.at = tube_at, .context = handle, .u_pieces = 2, .v_pieces = 2, .wraps_u = true};
    surfaces[3] =
        (struct hatch_parametric){.at = tube_at, .context = spout, .u_pieces = 2, .v_pieces = 2, .wraps_u = true};
    return 4;
}
