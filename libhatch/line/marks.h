/* Direction marks: short lines along a direction field (_HATCH_DIR), spread evenly over the surfaces that have one. */
#ifndef HATCH_LINE_MARKS_H
#define HATCH_LINE_MARKS_H

#include "scene/unit_scene.h"
#include "view/view.h"

/* A position and a direction on a face, in barycentric coordinates, so that both move with the face. */
struct hatch_mark {
    uint32_t face;     /* of the item's surface */
    float share[3];    /* weights of the corners for the position; their sum is 1 */
    float velocity[3]; /* weights of the corners for the direction; their sum is 0 */
    float confidence;  /* 0 .. 1 */
};

/* A mark at the scene's pose, in the unit scene. */
struct hatch_mark_line {
    float middle[3], half[3]; /* half: vector from the middle to an end */
    float confidence;         /* 0 .. 1 */
};

struct hatch_marks {
    const struct hatch_unit_scene *scene;
    uint32_t count;
    struct hatch_mark *at;         /* sorted by item */
    uint32_t *item_end;            /* per item: one past its last mark */
    double half_length;            /* half the length of a mark, in the unit scene */
    double *positions;             /* scratch: the vertices of a surface */
    struct hatch_mark_line *lines; /* per mark: filled by hatch_marks_place */
};

/* Spreads marks over a posed scene. Their spacing is constant in the scene, and has a fixed size in pixels at the
 * middle of the unit scene.
 *   scene      kept by reference
 *   height_px  of the picture
 *   arena      for the marks
 * HATCH_BAD_INPUT if no mesh has directions. */
enum hatch_status hatch_marks_make(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                   double height_px, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_marks *marks, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the lines of all marks at the present pose of the scene. */
void hatch_marks_place(struct hatch_marks *marks);

#endif
