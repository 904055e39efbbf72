/* Prepares paths for a pen: removes doubles, joins, simplifies, dashes, and orders them. Lengths are in the unit of the
 * paths. */
#ifndef HATCH_VECTOR_TIDY_H
#define HATCH_VECTOR_TIDY_H

#include "vector/paths.h"

/* Removes the parts of paths that run along a longer path of their layer at a distance of at most `reach`: where both
 * have nearly the same direction. Paths that end at another, or cross it, stay whole. Parts of one path are treated the
 * same way if they are at least eight times the reach apart along it: of a path that runs back along itself one side
 * remains; corners and small closed paths stay whole.
 *   drawn  paths of any layer that all others must not run along either, however short they are; NULL: none
 *   arena  for the paths that remain; not the scratch arena */
enum hatch_status hatch_vector_drop_doubles(const struct hatch_vector_paths *paths,
                                            const struct hatch_vector_paths *drawn, double reach,
                                            struct hatch_arena *arena, struct hatch_arena *scratch,
                                            struct hatch_vector_paths *single, struct hatch_err *err) HATCH_MUST_USE;

/* Joins paths of one layer whose ends are at most `reach` apart: the nearest and straightest pairs first. A joined path
 * has the smallest of the ids.
 *   arena  for the joined paths; not the scratch arena */
enum hatch_status hatch_vector_join(const struct hatch_vector_paths *paths, double reach, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_vector_paths *joined,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Removes paths that are shorter than `speck` and of which neither the first nor the last point is within `reach` of
 * another path.
 *   paths  in, out; afterwards the points of those that remain have gaps between them */
enum hatch_status hatch_vector_drop_specks(struct hatch_vector_paths *paths, double speck, double reach,
                                           struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Removes points that the paths need not pass to stay within a tolerance (Douglas & Peucker 1973). Ends of open paths
 * stay. Removes paths shorter than `shortest`.
 *   paths  in, out */
enum hatch_status hatch_vector_simplify(struct hatch_vector_paths *paths, double tolerance, double shortest,
                                        struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Cuts paths into dashes. A dash stands at both ends of an open path; gaps are stretched to fit. Dashes and gaps of
 * paths that are too short for that are shorter; an open path is one dash where they would be shorter than half. arena
 * for the dashes; not the scratch arena */
enum hatch_status hatch_vector_dash(const struct hatch_vector_paths *paths, double dash, double gap,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_vector_paths *dashes, struct hatch_err *err) HATCH_MUST_USE;

/* Order of paths: each time the path with the nearest end; or that, improved by reversing parts of it. */
enum hatch_vector_order { HATCH_VECTOR_NEAREST, HATCH_VECTOR_IMPROVED };

/* Orders paths, layer by layer, so that a pen that starts at 0, 0 is lifted over a short way. Paths may be reversed,
 * and closed ones may start at another point. The time is about proportional to the number of paths.
 *   paths  in, out */
enum hatch_status hatch_vector_sort(struct hatch_vector_paths *paths, enum hatch_vector_order order,
                                    struct hatch_arena *scratch, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the length of the paths, and the way of the lifted pen from each path to the next one, when one layer is
 * drawn after the other. */
void hatch_vector_ways(const struct hatch_vector_paths *paths, double *drawn, double *lifted);

#endif
