/* A line in the picture under construction from short pieces, of which some are kept: it is cleaned up, and its kept or
 * its other parts become paths. */
#ifndef HATCH_VECTOR_RUNS_H
#define HATCH_VECTOR_RUNS_H

#include "vector/paths.h"

struct hatch_vector_runs {
    struct hatch_buffer pieces, runs; /* private */
    uint32_t piece_count, run_count;  /* private */
    bool apart;                       /* a part is missing before the next piece */
    bool whole;                       /* no part is missing */
};

/* Makes runs without pieces.
 *   arena  for the work */
struct hatch_vector_runs hatch_vector_runs_of(struct hatch_arena *arena);

/* Begins a new line: removes all pieces. */
void hatch_vector_runs_clear(struct hatch_vector_runs *runs);

/* Leaves out a part of the line. */
void hatch_vector_runs_skip(struct hatch_vector_runs *runs);

/* Appends a straight piece: the part begin .. end, in 0 .. 1, of the line from a to b. An empty part is ignored. */
enum hatch_status hatch_vector_runs_add(struct hatch_vector_runs *runs, const double a[2], const double b[2],
                                        double begin, double end, bool kept, struct hatch_err *err) HATCH_MUST_USE;

/* Appends a piece that is not kept, nor delivered with those that are not. */
enum hatch_status hatch_vector_runs_add_blank(struct hatch_vector_runs *runs, const double a[2], const double b[2],
                                              double begin, double end, struct hatch_err *err) HATCH_MUST_USE;

/* Joins successive pieces that are kept, or are not, into runs. */
enum hatch_status hatch_vector_runs_make(struct hatch_vector_runs *runs, struct hatch_err *err) HATCH_MUST_USE;

/* Keeps runs that are shorter than `gap` and lie between two that are kept. */
void hatch_vector_runs_fill(struct hatch_vector_runs *runs, double gap);

/* Drops kept runs that are shorter than `speck` and lie between two that are not kept, or between one and the end of
 * the line.
 *   closed  the line ends where it begins, and so has no ends */
void hatch_vector_runs_drop(struct hatch_vector_runs *runs, double speck, bool closed);

/* Appends the runs that are kept, or those that are not, as paths.
 *   like    layer and id of the paths
 *   closed  the line ends where it begins: its first and its last run are one path if they meet */
enum hatch_status hatch_vector_runs_deliver(const struct hatch_vector_runs *runs, const struct hatch_vector_path *like,
                                            bool closed, bool kept, struct hatch_vector_builder *builder,
                                            struct hatch_err *err) HATCH_MUST_USE;

#endif
