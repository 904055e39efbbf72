/* Private to the mesh readers: vertices from the corners of faces, in formats whose faces say more of a corner than its
 * position. */
#ifndef HATCH_IO_MESH_CORNERS_H
#define HATCH_IO_MESH_CORNERS_H

#include "base/bytes.h"

#define HATCH_CORNER_PARTS 3
#define HATCH_CORNER_ABSENT UINT32_MAX

/* A corner as a face gives it: indices of values, or values; HATCH_CORNER_ABSENT where there is none. */
struct hatch_corner {
    uint32_t part[HATCH_CORNER_PARTS];
};

/* A table of corners: each distinct one is a vertex, in order of first use. */
struct hatch_corners {
    uint32_t count;
    struct hatch_buffer list; /* array of struct hatch_corner */
    uint32_t slot_count;
    uint32_t *slots; /* hash table: vertex + 1, or 0 if free */
    struct hatch_arena *scratch;
};

struct hatch_corners hatch_corners_in(struct hatch_arena *scratch);

/* Adds a corner if it is new.
 *   vertex  out: its index in the list */
enum hatch_status hatch_corners_add(struct hatch_corners *corners, const struct hatch_corner *corner, uint32_t *vertex,
                                    struct hatch_err *err) HATCH_MUST_USE;

const struct hatch_corner *hatch_corners_list(const struct hatch_corners *corners);

/* Lists the values that one part of the corners refers to, by corner.
 *   values   width floats per index
 *   missing  stands for values that a corner does not have
 *   out      in scratch; NULL if no corner has any */
enum hatch_status hatch_corners_gather(const struct hatch_corners *corners, int part, const float *values,
                                       uint32_t width, float missing, const float **out,
                                       struct hatch_err *err) HATCH_MUST_USE;

/* Lists the numbers that part 0 refers to, by corner.
 *   numbers  out: in arena */
enum hatch_status hatch_corners_numbers(const struct hatch_corners *corners, struct hatch_arena *arena,
                                        const uint32_t **numbers, struct hatch_err *err) HATCH_MUST_USE;

/* Adds the number of indices below count that part 0 of no corner has. */
enum hatch_status hatch_corners_count_unused(const struct hatch_corners *corners, uint32_t count, uint32_t *unused,
                                             struct hatch_err *err) HATCH_MUST_USE;

#endif
