/* Views for tests that draw. */
#ifndef HATCH_TEST_VIEWS_H
#define HATCH_TEST_VIEWS_H

#include "view/view.h"

/* An orthographic view in which the square from -1 to 1 in x and y fills a square picture. */
static const struct hatch_view view_facing = {.eye = {0, 0, 2},
                                              .right = {1, 0, 0},
                                              .up = {0, 1, 0},
                                              .back = {0, 0, 1},
                                              .orthographic = true,
                                              .half_height = 1,
                                              .aspect = 1,
                                              .near = 0.1,
                                              .far = 10,
                                              .pivot = 2};

#endif
