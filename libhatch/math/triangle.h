/* Distances of a point from segments and triangles. */
#ifndef HATCH_MATH_TRIANGLE_H
#define HATCH_MATH_TRIANGLE_H

/* Returns the squared distance of a point from a segment, whose ends may be equal.
 *   share  out: place of the nearest point, 0 at a .. 1 at b */
double hatch_segment_distance_squared(const double a[3], const double b[3], const double point[3], double *share);

/* Returns the squared distance of a point from a triangle, which may have no area.
 *   share  out: barycentric coordinates of the nearest point */
double hatch_triangle_distance_squared(const double a[3], const double b[3], const double c[3], const double point[3],
                                       double share[3]);

#endif
