/* Angles. */
#ifndef HATCH_MATH_ANGLE_H
#define HATCH_MATH_ANGLE_H

#define HATCH_RADIANS (3.14159265358979324 / 180) /* radians per degree */

#endif
