/* Cubics fitted to the fragments of strokes (Szécsi, Szirányi & Kacsó, "Tonal Art Maps with Image Space Strokes",
 * §2.2). A fragment is a pixel that a stroke covers; it has a place in the picture and a parameter t along the stroke.
 * The cubic is the least-squares solution of equation (1), but each fragment counts as much as it is covered, so that
 * the curve moves evenly when the stroke moves by parts of a pixel, and in Legendre polynomials of u, which runs from
 * -1 to 1 over the part of the stroke that is in sight, instead of powers of t: however short that part is, the system
 * stays well conditioned. Penalties on the polynomials of degrees 2 and 3 (iterated Tikhonov regularization) keep the
 * curve near a line where its fragments do not determine a cubic: few different parameters, a large gap, or a part that
 * is shorter than wide. Where they do, the penalties change nearly nothing. docs/notes/fit.md has the figures.
 * shaders/strokes/cubic.glsl of render-gl computes the same. */
#ifndef HATCH_FIT_CUBIC_H
#define HATCH_FIT_CUBIC_H

#include <stddef.h>
#include <stdint.h>

#define HATCH_CUBIC_TERMS 4u

/* The problem. With the weighted sum of squared distances of the fragments from the curve, each pass makes the sum of
 * the penalties least, each times the square of its factor's distance from that of the pass before; first from 0. The
 * penalty on degrees 2 and 3 is HATCH_CUBIC_PENALTY times the mean weight for a very short stroke. A stroke of
 * HATCH_CUBIC_SHORT_PX pixels has half of it, and longer ones have less, by the square of their length, which is that
 * of the line through the fragments. The penalty on degree 1 only keeps the solution finite where all fragments have
 * one parameter. */
#define HATCH_CUBIC_PASSES 4u
#define HATCH_CUBIC_PENALTY 2.0
#define HATCH_CUBIC_SHORT_PX 50.0
#define HATCH_CUBIC_LINE_PENALTY 1e-9

/* A pixel of a stroke. */
struct hatch_fragment {
    float t;      /* along the stroke, 0 .. 1 */
    float x, y;   /* middle of the pixel, in pixels: a whole number and a half, 0 .. 16384 */
    float weight; /* share of the pixel that the stroke covers, 0 .. 1 */
};

/* A curve over a range of t. Zeroed: no fragment. */
struct hatch_cubic {
    float t[2];                         /* least and greatest parameter of the fragments */
    float origin[2];                    /* least x and y of the fragments */
    float factor[2][HATCH_CUBIC_TERMS]; /* of Legendre polynomials 0 to 3 of u, for x and y from the origin */
    float weight;                       /* sum over the fragments: the area of the stroke, in pixels */
};

/* Fits a cubic. The result does not depend on the order of the fragments, to the last bit.
 *   fragments  count of them, 1 .. 2^20; finite */
void hatch_cubic_fit(const struct hatch_fragment *fragments, size_t count, struct hatch_cubic *cubic);

/* Returns u for a parameter t, or 0 if the curve is a point: -1 and 1 are the ends of the range, and others lie beyond
 * it. */
float hatch_cubic_u(const struct hatch_cubic *cubic, float t);

/* Computes the place of the curve at u, in pixels. Beyond -1 and 1 the curve goes on along its tangents. */
void hatch_cubic_at(const struct hatch_cubic *cubic, float u, float place[2]);

#endif
