/* Vectors of three doubles. Geometry that must work at any scale converts floats to doubles, computes in doubles, and
 * rounds to floats once at the end. */
#ifndef HATCH_MATH_VECTOR_H
#define HATCH_MATH_VECTOR_H

#include <math.h>

/* Converts floats to doubles. */
static inline void hatch_vec_of(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

/* Rounds doubles to floats. */
static inline void hatch_vec_round(const double from[3], float to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (float)from[i];
}

static inline void hatch_vec_copy(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

static inline void hatch_vec_sub(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

/* out = a + scale * b; out may be a or b */
static inline void hatch_vec_add_scaled(const double a[3], double scale, const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] + scale * b[i];
}

static inline double hatch_vec_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* out = a × b; out must be neither a nor b */
static inline void hatch_vec_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double hatch_vec_length(const double a[3])
{
    return sqrt(hatch_vec_dot(a, a));
}

static inline double hatch_vec_distance(const double a[3], const double b[3])
{
    double d[3];
    hatch_vec_sub(a, b, d);
    return hatch_vec_length(d);
}

/* Returns the angle between two vectors of any length, 0 .. pi in radians, precise for small angles, too. */
static inline double hatch_vec_angle(const double a[3], const double b[3])
{
    double turn[3];
    hatch_vec_cross(a, b, turn);
    return atan2(hatch_vec_length(turn), hatch_vec_dot(a, b));
}

/* Scales a to length 1; returns its former length. A zero vector stays unchanged. */
static inline double hatch_vec_normalize(double a[3])
{
    double length = hatch_vec_length(a);
    for (int i = 0; i < 3 && length > 0; i++)
        a[i] /= length;
    return length;
}

/* out = (b - a) × (c - a): a normal of the triangle, whose length is twice the triangle's area */
static inline void hatch_vec_triangle(const double a[3], const double b[3], const double c[3], double out[3])
{
    double ab[3], ac[3];
    hatch_vec_sub(b, a, ab);
    hatch_vec_sub(c, a, ac);
    hatch_vec_cross(ab, ac, out);
}

/* Computes a unit vector orthogonal to the unit vector `normal`: the axis along which normal has its smallest
 * component, projected onto the plane orthogonal to normal. */
static inline void hatch_vec_any_orthogonal(const double normal[3], double out[3])
{
    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(normal[i]) < fabs(normal[axis]))
            axis = i;
    for (int i = 0; i < 3; i++)
        out[i] = (i == axis ? 1.0 : 0.0) - normal[axis] * normal[i];
    hatch_vec_normalize(out);
}

#endif
