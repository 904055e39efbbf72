/* Curvature in closed form. Each shape but the teapot is the zero set of a function F; the Hessian of F over the length
 * of its gradient, restricted to the tangent plane, is the shape operator, whose eigenvalues are the principal
 * curvatures (do Carmo, "Differential Geometry of Curves and Surfaces", §3). */
#include "math/vector.h"
#include "shapes/grid.h"

#define TUBE_CENTRE 1.0

/* Gradient and Hessian of F at a point. */
struct derivatives {
    double gradient[3], hessian[3][3];
};

/* Adds scale * a aᵀ to the Hessian. */
static void add_outer(struct derivatives *d, double scale, const double a[3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            d->hessian[i][k] += scale * a[i] * a[k];
}

/* F = Σ weight x² / 2 */
static void quadric(const double p[3], const double weight[3], struct derivatives *d)
{
    for (int k = 0; k < 3; k++) {
        d->gradient[k] = weight[k] * p[k];
        d->hessian[k][k] = weight[k];
    }
}

/* F = ρ + f(y), with ρ the distance from the y axis
 *   slope, bend  first and second derivative of f */
static void revolved(const double radial[3], double rho, double slope, double bend, struct derivatives *d)
{
    const double around[3] = {radial[2], 0, -radial[0]};
    hatch_vec_copy(radial, d->gradient);
    d->gradient[1] = slope;
    d->hessian[1][1] = bend;
    add_outer(d, 1 / rho, around);
}

/* F = Σ (x / axis)⁴ / 4 */
static void superquadric(const double p[3], struct derivatives *d)
{
    for (int k = 0; k < 3; k++) {
        double x = p[k] / hatch_superquadric_axes[k];
        d->gradient[k] = x * x * x / hatch_superquadric_axes[k];
        d->hessian[k][k] = 3 * x * x / (hatch_superquadric_axes[k] * hatch_superquadric_axes[k]);
    }
}

/* F = |p| - r(c), with c the cosine of the angle to the axis of the bump */
static void bump(const double p[3], struct derivatives *d)
{
    double length = hatch_vec_length(p), slope[2], unit[3], turn[3], c = hatch_vec_dot(p, hatch_bump_axis) / length;
    hatch_bump_radius(c, slope);
    for (int k = 0; k < 3; k++) {
        unit[k] = p[k] / length;
        turn[k] = (hatch_bump_axis[k] - c * unit[k]) / length; /* gradient of c */
        d->gradient[k] = unit[k] - slope[0] * turn[k];
    }
    double square = length * length;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            double same = i == k, both = hatch_bump_axis[i] * unit[k] + unit[i] * hatch_bump_axis[k];
            double second = (3 * c * unit[i] * unit[k] - both - c * same) / square; /* Hessian of c */
            d->hessian[i][k] = (same - unit[i] * unit[k]) / length - slope[1] * turn[i] * turn[k] - slope[0] * second;
        }
}

/* F = x sin(y / rise) + z cos(y / rise) */
static void helicoid(const double p[3], struct derivatives *d)
{
    double rate = 1 / HATCH_HELICOID_RISE, s = sin(rate * p[1]), c = cos(rate * p[1]);
    d->gradient[0] = s;
    d->gradient[1] = rate * (p[0] * c - p[2] * s);
    d->gradient[2] = c;
    d->hessian[0][1] = d->hessian[1][0] = rate * c;
    d->hessian[1][2] = d->hessian[2][1] = -rate * s;
    d->hessian[1][1] = -rate * rate * (p[0] * s + p[2] * c);
}

/* F = z - f(x, y) */
static void graph(const struct hatch_height *at, struct derivatives *d)
{
    d->gradient[0] = -at->zx;
    d->gradient[1] = -at->zy;
    d->gradient[2] = 1;
    d->hessian[0][0] = -at->zxx;
    d->hessian[0][1] = d->hessian[1][0] = -at->zxy;
    d->hessian[1][1] = -at->zyy;
}

/* F = (ρ - R)²/2 + y²/2 */
static void torus(const double p[3], const double radial[3], double rho, struct derivatives *d)
{
    const double around[3] = {radial[2], 0, -radial[0]}, up[3] = {0, 1, 0};
    double off = rho - TUBE_CENTRE;
    for (int k = 0; k < 3; k++)
        d->gradient[k] = off * radial[k];
    d->gradient[1] = p[1];
    add_outer(d, 1, radial);
    add_outer(d, off / rho, around);
    add_outer(d, 1, up);
}

static bool find_derivatives(enum hatch_shape shape, const double p[3], struct derivatives *d)
{
    static const double sphere[3] = {1, 1, 1}, cylinder[3] = {1, 0, 1};
    static const double ellipsoid[3] = {1, 1 / 0.49, 1 / 0.25};
    *d = (struct derivatives){.gradient = {0, 0, 0}};
    struct hatch_height height;
    double rho = sqrt(p[0] * p[0] + p[2] * p[2]);
    double radial[3] = {rho > 0 ? p[0] / rho : 0, 0, rho > 0 ? p[2] / rho : 0};
    switch (shape) {
    case HATCH_SHAPE_SPHERE:
        quadric(p, sphere, d);
        return true;
    case HATCH_SHAPE_CYLINDER:
        quadric(p, cylinder, d);
        return true;
    case HATCH_SHAPE_ELLIPSOID:
        quadric(p, ellipsoid, d);
        return true;
    case HATCH_SHAPE_CONE:
        revolved(radial, rho, 0.5, 0, d);
        return rho > 0;
    case HATCH_SHAPE_FRUSTUM:
        revolved(radial, rho, HATCH_FRUSTUM_SLOPE, 0, d);
        return true;
    case HATCH_SHAPE_CATENOID:
        revolved(radial, rho, -sinh(p[1] / HATCH_CATENOID_WAIST),
                 -cosh(p[1] / HATCH_CATENOID_WAIST) / HATCH_CATENOID_WAIST, d);
        return true;
    case HATCH_SHAPE_TORUS:
        torus(p, radial, rho, d);
        return rho > 0;
    case HATCH_SHAPE_PLANE:
        d->gradient[2] = 1;
        return true;
    case HATCH_SHAPE_SUPERQUADRIC:
        superquadric(p, d);
        return true;
    case HATCH_SHAPE_BUMP:
        bump(p, d);
        return true;
    case HATCH_SHAPE_HELICOID:
        helicoid(p, d);
        return true;
    default:
        if (!hatch_shape_height(shape, p[0], p[1], &height))
            return false;
        graph(&height, d);
        return true;
    }
}

/* aᵀ H b */
static double form(double hessian[3][3], const double a[3], const double b[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += a[i] * hatch_vec_dot(hessian[i], b);
    return sum;
}

bool hatch_shape_curvature(enum hatch_shape shape, const double position[3], double normal[3], double direction[3],
                           double curvature[2])
{
    struct derivatives d;
    double s[3], t[3];
    if (!find_derivatives(shape, position, &d))
        return false;
    hatch_vec_copy(d.gradient, normal);
    double length = hatch_vec_normalize(normal);
    hatch_vec_any_orthogonal(normal, s);
    hatch_vec_cross(normal, s, t);
    /* eigenvalues of the symmetric matrix (a b; b c) */
    double a = form(d.hessian, s, s) / length, b = form(d.hessian, s, t) / length;
    double c = form(d.hessian, t, t) / length;
    double middle = (a + c) / 2, spread = sqrt((a - c) * (a - c) / 4 + b * b);
    /* On a minimal surface both have the same absolute value: rounding errors must not choose. */
    double sign = middle < -1e-9 * spread ? -1 : 1;
    curvature[0] = middle + sign * spread;
    curvature[1] = middle - sign * spread;
    for (int k = 0; k < 3; k++)
        direction[k] = 0;
    if (!(spread > 1e-9 * (fabs(middle) + 1)))
        return false;
    /* The eigenvector of k1 is (a - k2) s + b t or b s + (c - k2) t: the longer one is accurate. */
    double along[2] = {a - curvature[1], b}, other[2] = {b, c - curvature[1]};
    bool first = fabs(along[0]) >= fabs(other[1]);
    for (int k = 0; k < 3; k++)
        direction[k] = (first ? along[0] : other[0]) * s[k] + (first ? along[1] : other[1]) * t[k];
    hatch_vec_normalize(direction);
    return true;
}
