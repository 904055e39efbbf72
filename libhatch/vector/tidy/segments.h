/* Segments listed by cells, for finding those near another segment. Part of tidying paths. */
#ifndef HATCH_VECTOR_TIDY_SEGMENTS_H
#define HATCH_VECTOR_TIDY_SEGMENTS_H

#include "vector/cells.h"

struct hatch_segments {
    struct hatch_vector_cells cells;
    uint32_t *head;              /* per cell: its newest entry */
    struct hatch_buffer entries; /* lists of the cells */
    uint32_t entry_count;
    struct hatch_buffer looked; /* per segment: the last search that found it */
    uint32_t search;
};

/* A callback that receives the number of a segment. */
typedef enum hatch_status (*hatch_segments_visit)(void *context, uint32_t segment, struct hatch_err *err);

/* Makes cells for segments between the points of some paths.
 *   reach  distances of searches, over 0
 *   arena  for the lists, which grow in it */
enum hatch_status hatch_segments_make(const struct hatch_vector_paths *paths, double reach, struct hatch_arena *arena,
                                      struct hatch_segments *near, struct hatch_err *err) HATCH_MUST_USE;

/* Adds a segment.
 *   segment  its number, which the visits get; numbers should be small */
enum hatch_status hatch_segments_insert(struct hatch_segments *near, uint32_t segment, const double a[2],
                                        const double b[2], struct hatch_err *err) HATCH_MUST_USE;

/* Calls visit once for each segment that has a point within `reach` of the segment a b, and for some that are farther
 * away. */
enum hatch_status hatch_segments_find(struct hatch_segments *near, const double a[2], const double b[2], double reach,
                                      hatch_segments_visit visit, void *context, struct hatch_err *err) HATCH_MUST_USE;

#endif
