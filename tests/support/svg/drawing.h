/* Drawings in SVG for test programs: texts that are read, and checks of the strokes in them. The fixture is that of
 * arenas.h. */
#ifndef HATCH_TEST_SVG_DRAWING_H
#define HATCH_TEST_SVG_DRAWING_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arenas.h"
#include "io/svg/svg.h"
#include "stroke/path.h"

#define DRAWING_PX 200u

static struct hatch_stroke_list list;
static struct hatch_svg_notes notes;

static inline enum hatch_status read_text(const char *text)
{
    struct hatch_bytes bytes = {(const uint8_t *)text, strlen(text)};
    return hatch_svg_read(bytes, DRAWING_PX, &keep, &scratch, &list, &notes, &err);
}

/* A drawing on a page of 100 x 100. */
static inline const char *page(const char *content)
{
    static char text[20000];
    snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>%s</svg>", content);
    return text;
}

static inline void read_page(const char *content)
{
    HATCH_TEST_OK(read_text(page(content)), &err);
}

/* Point i of a stroke, user units; i -1: the last one. */
static inline void point(uint32_t stroke, int i, double *xy)
{
    const struct hatch_stroke *s = &list.items[stroke];
    uint32_t at = i < 0 ? s->path->count - 1 : (uint32_t)i;
    xy[0] = 100 * ((double)s->x + (double)s->path->xy[2 * at]);
    xy[1] = 100 * ((double)s->y + (double)s->path->xy[2 * at + 1]);
}

static inline void check_point(uint32_t stroke, int i, double x, double y)
{
    double xy[2];
    ck_assert_uint_lt(stroke, list.count);
    point(stroke, i, xy);
    /* modulo the tile, which wraps */
    ck_assert_double_eq_tol(remainder(xy[0] - x, 100), 0, 1e-3);
    ck_assert_double_eq_tol(remainder(xy[1] - y, 100), 0, 1e-3);
}

static inline void check_dot(uint32_t stroke, double x, double y)
{
    ck_assert_ptr_null(list.items[stroke].path);
    ck_assert_double_eq_tol(100 * (double)list.items[stroke].x, x, 1e-3);
    ck_assert_double_eq_tol(100 * (double)list.items[stroke].y, y, 1e-3);
}

static inline void check_ends(uint32_t stroke, double x0, double y0, double x1, double y1)
{
    check_point(stroke, 0, x0, y0);
    check_point(stroke, -1, x1, y1);
}

/* Checks that a red drawing without fills has one stroke, from (10, 20) to (50, 60). */
static inline void check_stroke(const char *content)
{
    char text[500];
    snprintf(text, sizeof text, "<g stroke='red' fill='none'>%s</g>", content);
    read_page(text);
    ck_assert_uint_eq(list.count, 1);
    check_ends(0, 10, 20, 50, 60);
}

#endif
