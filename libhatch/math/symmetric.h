/* Eigenvectors of symmetric matrices. */
#ifndef HATCH_MATH_SYMMETRIC_H
#define HATCH_MATH_SYMMETRIC_H

#include <stddef.h>

/* Finds the eigenvalues and eigenvectors of a symmetric matrix by Jacobi's rotations (Golub & Van Loan, "Matrix
 * Computations", §8.5).
 *   n        rows, at least 1
 *   matrix   n * n entries, row by row; destroyed
 *   vectors  out: n rows of n entries, orthonormal: row i belongs to values[i]
 *   values   out: n eigenvalues, the largest first */
void hatch_symmetric_eigen(size_t n, double *matrix, double *vectors, double *values);

#endif
