/* Principal components: the directions in which vectors differ most. */
#ifndef HATCH_MATH_PCA_H
#define HATCH_MATH_PCA_H

#include <stdint.h>

/* Finds the directions of largest variance by orthogonal iteration. Only the four operations and square roots are used,
 * in a fixed order.
 *   covariance  [row * length + column], symmetric, no negative eigenvalue
 *   count       of directions, 1 .. length
 *   directions  out: [direction * length + i], orthonormal, by falling variance
 *   next        [count * length], overwritten */
void hatch_pca_directions(const double *covariance, uint32_t length, uint32_t count, double *directions, double *next);

#endif
