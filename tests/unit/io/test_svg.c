#define _XOPEN_SOURCE 700 /* M_PI */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "svg/drawing.h"
#include "fail_alloc.h"
#include "image/image.h"

/* Each is one stroke from (10, 20) to (50, 60). */
static const char *const same_ends[] = {
    "<path stroke='black' d='M10 20L50 60'/>",
    "<path stroke='black' d='m10,20,40,40'/>",
    "<path stroke='black' d='m 1e1 20l+40 4.e1'/>",
    "<path stroke='black' d='M10 20H50V60'/>",
    "<path stroke='black' d='m10 20h40v40'/>",
    "<path stroke='black' d='M10,20C10,30,40,60,50,60'/>",
    "<path stroke='black' d='m10 20c0 10 30 40 40 40'/>",
    "<path stroke='black' d='m10 20s30 40 40 40'/>",
    "<path stroke='black' d='m10 20q0 40 40 40'/>",
    "<path stroke='black' d='M10-20m0 40t40 40'/>",
    "<path stroke='black' d='m10 20a40 40 0 0150 60'/>",
    "<path stroke='black' d='M10 20A40 40 0 00 50 60'/>",
    "<path stroke='black' d='M10 20A1 1 30 1 1 50 60'/>",
    "<path stroke='black' d='M10 20A0 5 30 1 1 50 60'/>",
    "<line stroke='black' x1='10' y1='20' x2='50' y2='60'/>",
    "<polyline stroke='black' points='10,20 33 7,50,60'/>",
    "<g transform='translate(10 20)'><path stroke='black' d='M0 0 40 40'/></g>",
    "<g transform='translate(10) translate(0,20)'><path stroke='black' d='M0 0 40 40'/></g>",
    "<path transform='scale(10)' stroke='black' stroke-width='.1' d='M1 2 5 6'/>",
    "<path transform='matrix(2 0 0 2 0 10)' stroke='black' d='M5 5 25 25'/>",
    "<path transform='rotate(90)' stroke='black' d='M20-10 60-50'/>",
    "<path transform='rotate(90,30,40)' stroke='black' d='M10 60 50 20'/>",
    "<path transform='skewX(45) translate(-20,0)' stroke='black' d='M10 20 10 60'/>",
    "<path transform='skewY(45) translate(0,-10)' stroke='black' d='M10 20 50 20'/>",
};

START_TEST(equivalent_paths_have_the_same_ends)
{
    read_page(same_ends[_i]);
    ck_assert_uint_eq(list.count, 1);
    if (_i == 10) { /* the relative arc ends 50, 60 from its start */
        check_point(0, -1, 60, 80);
        return;
    }
    check_point(0, 0, 10, 20);
    check_point(0, -1, 50, 60);
}
END_TEST

/* Two Bezier curves, the second of which begins with the mirrored control point. Their x is linear in the parameter. */
static const struct {
    const char *path, *turned; /* turned: x and y are exchanged */
    int degree;
    double x[3], y[2][4]; /* x of the ends; y of the control points */
} curves[] = {
    {"M10 20Q30 60 50 40T90 30", "M20 10Q60 30 40 50T30 90", 2, {10, 50, 90}, {{20, 60, 40}, {40, 20, 30}}},
    {"m10 20q20 40 40 20t40-10", "m20 10q40 20 20 40t-10 40", 2, {10, 50, 90}, {{20, 60, 40}, {40, 20, 30}}},
    {"M10 20C20 60 30 50 40 30S60 50 70 60",
     "M20 10C60 20 50 30 30 40S50 60 60 70",
     3,
     {10, 40, 70},
     {{20, 60, 50, 30}, {30, 10, 50, 60}}},
};

START_TEST(points_of_curves_lie_on_them)
{
    for (int turned = 0; turned < 2; turned++) {
        char text[200];
        snprintf(text, sizeof text, "<path stroke='black' d='%s'/>", turned ? curves[_i].turned : curves[_i].path);
        read_page(text);
        ck_assert_uint_gt(list.items[0].path->count, 10);
        for (int i = 0; i < (int)list.items[0].path->count; i++) {
            double xy[2], y[4];
            point(0, i, xy);
            double along = xy[turned], across = xy[!turned];
            int part = along > curves[_i].x[1];
            double t = (along - curves[_i].x[part]) / (curves[_i].x[part + 1] - curves[_i].x[part]);
            memcpy(y, curves[_i].y[part], sizeof y);
            for (int k = curves[_i].degree; k > 0; k--) /* de Casteljau */
                for (int j = 0; j < k; j++)
                    y[j] += t * (y[j + 1] - y[j]);
            ck_assert_double_eq_tol(across, y[0], 1e-3);
        }
    }
}
END_TEST

START_TEST(a_path_may_be_none)
{
    read_page("<path stroke='black' d='none'/><path stroke='black' d=' none '/><path stroke='black' d=''/><path "
              "stroke='black' d='M1 2 3 4'/>");
    ck_assert_uint_eq(list.count, 1);
}
END_TEST

START_TEST(shapes_have_the_right_lengths)
{
    read_page("<g stroke='black'><circle cx='50' cy='50' r='20'/><rect x='1' y='2' width='30' height='20'/>"
              "<rect width='30' height='20' rx='5'/><polygon points='0 0 30 0 30 40'/>"
              "<ellipse cx='50' cy='50' rx='30' ry='10'/><path d='M50 20A30 30 0 0 1 80 50z'/></g>");
    static const double want[] = {2 * M_PI * 20, 100, 100 - 40 + 2 * M_PI * 5, 120, 133.6489, M_PI * 15 + 42.42641};
    ck_assert_uint_eq(list.count, 6);
    for (uint32_t i = 0; i < 6; i++)
        ck_assert_double_eq_tol((double)list.items[i].length * 100, want[i], 0.05);
}
END_TEST

/* A radius that is 0 makes corners square, and an ellipse vanish; one that is absent or negative is that of the other
 * axis (SVG 2, sections 7.4 and 10.4). */
START_TEST(radii_may_be_absent)
{
    static const char *const rounded[] = {
        "rx='5'", "ry='5'", "rx='5' ry='auto'", "rx='-1' ry='5'", "rx='5' ry='5.0px'", "rx='auto' ry='5'"};
    static const char *const square[] = {"rx='0' ry='10'", "rx='10' ry='0'", "rx='0'", "", "rx='auto' ry='auto'"};
    char text[200];
    for (size_t i = 0; i < sizeof rounded / sizeof *rounded; i++) {
        snprintf(text, sizeof text, "<rect stroke='red' width='30' height='20' %s/><ellipse stroke='red' %s/>",
                 rounded[i], rounded[i]);
        read_page(text);
        ck_assert_uint_eq(list.count, 2);
        ck_assert_double_eq_tol((double)list.items[0].length * 100, 100 - 40 + 2 * M_PI * 5, 0.05);
        ck_assert_double_eq_tol((double)list.items[1].length * 100, 2 * M_PI * 5, 0.05);
    }
    for (size_t i = 0; i < sizeof square / sizeof *square; i++) {
        snprintf(text, sizeof text, "<rect stroke='red' width='30' height='20' %s/><ellipse stroke='red' %s/>",
                 square[i], square[i]);
        read_page(text);
        ck_assert_uint_eq(list.count, 1);
        ck_assert_double_eq_tol((double)list.items[0].length * 100, 100, 1e-3);
    }
}
END_TEST

/* Every point of an arc lies on its ellipse. */
START_TEST(arcs_lie_on_their_ellipse)
{
    for (int flags = 0; flags < 4; flags++) {
        char text[200];
        snprintf(text, sizeof text, "<path stroke='black' d='M60 40A30 15 30 %d %d 40 60'/>", flags / 2, flags % 2);
        read_page(text);
        double first[2], length = (double)list.items[0].length * 100;
        ck_assert(flags / 2 ? length > 80 : length < 80);
        /* In the ellipse's frame, scaled by its radii, all points have distance 1 from the centre, of which
         * there are two candidates, symmetric about the chord. */
        double best = INFINITY;
        for (int side = -1; side <= 1; side += 2) {
            double c = cos(M_PI / 6), s = sin(M_PI / 6), worst = 0;
            double ax = (c * 60 + s * 40) / 30, ay = (c * 40 - s * 60) / 15;
            double bx = (c * 40 + s * 60) / 30, by = (c * 60 - s * 40) / 15;
            double dx = bx - ax, dy = by - ay, half = (dx * dx + dy * dy) / 4;
            double distance = side * sqrt((1 - half) / (4 * half));
            double mx = (ax + bx) / 2 - dy * distance, my = (ay + by) / 2 + dx * distance;
            for (uint32_t i = 0; i < list.items[0].path->count; i++) {
                point(0, (int)i, first);
                double x = (c * first[0] + s * first[1]) / 30 - mx, y = (c * first[1] - s * first[0]) / 15 - my;
                worst = fmax(worst, fabs(hypot(x, y) - 1));
            }
            best = fmin(best, worst);
        }
        ck_assert_double_le(best, 1e-3);
    }
}
END_TEST

static const struct {
    const char *content;
    float rgb[3]; /* sRGB */
    float width, tone;
} styled[] = {
    {"<path d='M0 0 9 9' stroke='#ff8000'/>", {1, 128 / 255.0f, 0}, 1, 1},
    {"<path d='M0 0 9 9' stroke='#f80' stroke-width='3'/>", {1, 136 / 255.0f, 0}, 3, 1},
    {"<path d='M0 0 9 9' stroke='rgb(51, 102,255)'/>", {0.2f, 0.4f, 1}, 1, 1},
    {"<path d='M0 0 9 9' stroke='rgb(20%,40%,100%)'/>", {0.2f, 0.4f, 1}, 1, 1},
    {"<path d='M0 0 9 9' stroke='Tomato'/>", {1, 99 / 255.0f, 71 / 255.0f}, 1, 1},
    {"<path d='M0 0 9 9' style='stroke:navy;stroke-width:2px'/>", {0, 0, 128 / 255.0f}, 2, 1},
    {"<path d='M0 0 9 9' stroke='red' style='stroke : navy ; ;stroke-opacity:.25'/>", {0, 0, 128 / 255.0f}, 1, .25f},
    {"<g style='stroke:lime'><g opacity='.5'><path d='M0 0 9 9' stroke-width='1mm' opacity='50%'/></g></g>",
     {0, 1, 0},
     96 / 25.4f,
     .25f},
    {"<g color='blue' stroke='currentColor'><path d='M0 0 9 9' stroke-width='3pt'/></g>", {0, 0, 1}, 4, 1},
    {"<g stroke='#000' stroke-width='2' transform='scale(3 .75)'><path d='M0 0 9 9'/></g>", {0, 0, 0}, 3, 1},
    {"<path d='M0 0 9 9' stroke='black' stroke-width='5%'/>", {0, 0, 0}, 5, 1},
    {"<path d='M0 0 9 9' stroke='black' stroke-width='.25em'/>", {0, 0, 0}, 4, 1},
    {"<path d='M0 0 9 9' stroke='black' stroke-width='.25ex'/>", {0, 0, 0}, 2, 1},
    /* style sheets precede the style attribute and follow other attributes; order by specificity, then place */
    {"<defs><style>.cls-1{fill:none;stroke:lime;stroke-width:3px;}</style></defs><path class='cls-1' d='M0 0 9 9'/>",
     {0, 1, 0},
     3,
     1},
    {"<path class='a b' stroke='red' d='M0 0 9 9'/><style type='text/css'>"
     "<![CDATA[\n.a, .c { stroke : lime }\n]]></style>",
     {0, 1, 0},
     1,
     1},
    {"<style>#p{stroke:blue} .a{stroke:red} path{stroke:lime;stroke-width:2}</style>"
     "<path id='p' class='a' d='M0 0 9 9'/>",
     {0, 0, 1},
     2,
     1},
    {"<style>.a{stroke:red}.a{stroke:lime}</style><path class='a' d='M0 0 9 9'/>", {0, 1, 0}, 1, 1},
    {"<style>path.a{stroke:lime}.a{stroke:red}path.b{stroke:blue}</style>"
     "<path class='a' d='M0 0 9 9'/>",
     {0, 1, 0},
     1,
     1},
    {"<style>.a{stroke:red}</style><path class='a' style='stroke:lime' d='M0 0 9 9'/>", {0, 1, 0}, 1, 1},
    {"<style>/* .a{stroke:red} */ .a{/**/stroke:lime;/*;*/stroke-width/*x*/:4}</style><path class='a' d='M0 0 9 9'/>",
     {0, 1, 0},
     4,
     1},
    {"<style>.a/*/*/{stroke:lime}</style><path class='a' d='M0 0 9 9'/>", {0, 1, 0}, 1, 1},
    {"<style>*{stroke-width:3}.a{stroke:lime;opacity:.5}</style><g class='a' opacity='.1'><path d='M0 0 9 9'/></g>",
     {0, 1, 0},
     3,
     .5f},
    {"<style>@import url(http://example.org/a.css);@media print{.a{stroke:red}}.b .a{stroke:red}.a{stroke:lime}</style>"
     "<path class='a' d='M0 0 9 9'/>",
     {0, 1, 0},
     1,
     1},
    {"<style>.a{stroke:lime</style><path class='a' d='M0 0 9 9'/>", {0, 1, 0}, 1, 1},
    /* clones inherit the style of <use> */
    {"<defs><path id='p' d='M0 0 9 9'/></defs><use href='#p' stroke='lime' stroke-width='2'/>", {0, 1, 0}, 2, 1},
    {"<use xlink:href='#p' xmlns:xlink='x' stroke='red'/><defs><g id='p' stroke='lime'><path d='M0 0 9 9'/></g></defs>",
     {0, 1, 0},
     1,
     1},
    {"<defs><path id='p' d='M0 0 9 9'/></defs><use href='#p' stroke='lime' transform='scale(2)'/>", {0, 1, 0}, 2, 1},
};

START_TEST(a_stroke_has_its_computed_style)
{
    read_page(styled[_i].content);
    ck_assert_uint_eq(list.count, 1);
    const struct hatch_stroke *stroke = &list.items[0];
    for (int c = 0; c < 3; c++)
        ck_assert_float_eq_tol(hatch_linear_to_srgb(stroke->rgb[c]), styled[_i].rgb[c], 1e-4f);
    ck_assert_float_eq_tol(stroke->width_px, styled[_i].width * 2, 1e-3f);
    ck_assert_float_eq_tol(stroke->tone, styled[_i].tone, 1e-6f);
    ck_assert_uint_eq(stroke->id, 1);
}
END_TEST

START_TEST(ignored_elements_are_counted)
{
    read_page("<defs><path d='M0 0 9 9' stroke='red'/></defs><rect width='9' height='9'/>"
              "<path fill='none' stroke='none' d='M0 0 9 9'/><text>a<tspan>b</tspan></text>"
              "<image href='http://example.org/a.png'/><path stroke='url(#g)' fill='none' d='M0 0 9 9'/>"
              "<use href='#a'/><g display='none'><path stroke='red' d='M0 0 9 9'/></g>"
              "<path stroke='red' fill='none' d='M200 0 290 9'/><path stroke='red' fill='none' d='M1 1'/>"
              "<path stroke='red' fill='none' stroke-linecap='round' d='M1 1z'/>"
              "<path stroke='red' fill='none' d='M1 1z'/><path mask='url(#m)' fill='none' stroke='red' d='M2 2z'/>"
              "<x:thing xmlns:x='y'><path stroke='red' d='M0 0 9 9'/></x:thing>");
    ck_assert_uint_eq(list.count, 1);
    ck_assert_ptr_null(list.items[0].path);
    ck_assert_uint_eq(notes.strokes, 1);
    ck_assert_uint_eq(notes.fills, 1);
    ck_assert_uint_eq(notes.texts, 1);
    ck_assert_uint_eq(notes.images, 1);
    ck_assert_uint_eq(notes.gradients, 1);
    ck_assert_uint_eq(notes.others, 2);
    ck_assert_uint_eq(notes.outside, 1);
    read_page("<style>@import 'a.css';@media print{.a{stroke:red}}.b .a,g>g,.a{fill:none}</style>");
    ck_assert_uint_eq(notes.others, 4);
}
END_TEST

START_TEST(clones_are_drawn_at_their_position)
{
    read_page("<g id='g' stroke='red'><path id='p' d='M10 20 14 20'/></g><use href='#g' x='5' y='6'/>"
              "<use href='#p' x='5' transform='scale(2)' stroke='red'/>"
              "<symbol id='s' viewBox='0 0 10 20'><path stroke='red' d='M0 0 10 20'/></symbol>"
              "<use href='#s' x='30' y='40' width='20' height='20'/><symbol id='t'><path stroke='red' d='M1 1 2 2'/>"
              "</symbol><use href='#t'/><use href='#missing'/><use/>");
    ck_assert_uint_eq(list.count, 5);
    check_ends(0, 10, 20, 14, 20);
    check_ends(1, 15, 26, 19, 26);
    check_ends(2, 30, 40, 38, 40);
    check_ends(3, 35, 40, 45, 60);
    check_ends(4, 1, 1, 2, 2);
    ck_assert_uint_eq(notes.others, 2);
}
END_TEST

START_TEST(dashes_become_strokes)
{
    read_page("<path stroke='red' stroke-dasharray='4,2' d='M10 10H17V13'/>");
    ck_assert_uint_eq(list.count, 2);
    check_ends(0, 10, 10, 14, 10);
    check_ends(1, 16, 10, 17, 13); /* around the corner */
    read_page("<path stroke='red' stroke-dasharray='3' stroke-dashoffset='4' d='M10 10H20'/>");
    ck_assert_uint_eq(list.count, 2);
    check_ends(0, 12, 10, 15, 10);
    check_ends(1, 18, 10, 20, 10);
    read_page("<path stroke='red' style='stroke-dasharray:1 1 2; stroke-dashoffset:-1' "
              "transform='scale(2)' d='M5 5H10'/>");
    ck_assert_uint_eq(list.count, 2); /* dash 1, gap 1, dash 2, gap 1, dash 1, gap 2, begun one unit before its end */
    check_ends(0, 12, 10, 14, 10);
    check_ends(1, 16, 10, 20, 10);
    read_page("<g stroke-dasharray='0 5'><path stroke='red' d='M0 10H10'/>"
              "<path stroke='red' stroke-linecap='round' d='M0 10H14'/></g>");
    ck_assert_uint_eq(list.count, 3); /* dots, visible only with caps */
    for (uint32_t i = 0; i < 3; i++)
        check_dot(i, 5 * i, 10);
    read_page("<g stroke-dasharray='2'><path stroke='red' stroke-dasharray='none' d='M0 10H10'/>"
              "<path stroke='red' stroke-dasharray='0 0' d='M0 10H10'/></g>");
    ck_assert_uint_eq(list.count, 2);
}
END_TEST

static const struct {
    const char *text, *message;
} bad[] = {
    {"", "line 1: not valid XML: no element found"},
    {"<svg viewBox='0 0 1 1'>", "line 1: not valid XML: no element found"},
    {"<svg viewBox='0 0 1 1'>\n</g>", "line 2: not valid XML: mismatched tag"},
    {"<html/>", "line 1: the root element is <html>, want <svg>"},
    {"<svg viewBox='0 0 1'/>", "line 1: viewBox: want four numbers"},
    {"<svg viewBox='0 0 210 297'/>", "line 1: the page is 210 x 297, want a square"},
    {"<svg viewBox='0 0 0 0'/>", "line 1: the page is 0 x 0, want a positive size"},
    {"<svg viewBox='0 0 0 9'/>", "line 1: the page is 0 x 9, want a positive size"},
    {"<svg viewBox='0 0 9 0'/>", "line 1: the page is 9 x 0, want a positive size"},
    {"<svg viewBox='0 0 9 9'><symbol id='s' viewBox='0 0 0 1'/><use href='#s'/></svg>",
     "line 1: viewBox: want four numbers and a positive size"},
    {"<svg viewBox='0 0 9 9'><symbol id='s' viewBox='0 0 1 0'/><use href='#s'/></svg>",
     "line 1: viewBox: want four numbers and a positive size"},
    {"<svg width='1e999' height='1'/>", "line 1: width: '1e999' is not a length"},
    {"<svg viewBox='0 0 9 9'>\n<path stroke='red' d='L1 1'/></svg>",
     "line 2: path data: unexpected 'L' at character 1"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' d='M1 1C1 1'/></svg>",
     "line 1: path data: a number is missing or malformed at character 9"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' d='M1 1 1e400 1'/></svg>",
     "line 1: path data: a number is missing or malformed at character 6"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' d='M1 1A5 5 0 2 1 3 3'/></svg>",
     "line 1: path data: a number is missing or malformed at character 12"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' d='M1 1zz5'/></svg>",
     "line 1: path data: unexpected '5' at character 7"},
    {"<svg viewBox='0 0 9 9'><g transform='turn(3)'/></svg>", "line 1: transform 'turn(3)' is malformed or unknown"},
    {"<svg viewBox='0 0 9 9'><g transform='scale(1 2 3)'/></svg>",
     "line 1: transform 'scale(1 2 3)' is malformed or unknown"},
    {"<svg viewBox='0 0 9 9'><g stroke='reddish'/></svg>", "line 1: stroke 'reddish' is malformed or unknown"},
    {"<svg viewBox='0 0 9 9'><g stroke-width='-1'/></svg>", "line 1: stroke-width -1 is negative"},
    {"<svg viewBox='0 0 8 8'><path stroke='red' stroke-width='34' d='M1 1 2 2'/></svg>",
     "line 1: a stroke is 4.25 page widths wide, want at most 4"},
    {"<svg viewBox='0 0 9 9'><use href='other.svg#a'/></svg>",
     "line 1: <use> of 'other.svg#a': other files are not read"},
    {"<svg viewBox='0 0 9 9'>\n<g id='a'><use href='#b'/></g>\n<g id='b'><use href='#a'/></g></svg>",
     "line 2: 'a' contains a <use> of itself"},
    {"<svg viewBox='0 0 9 9'>\n<use id='u' href='#u'/></svg>", "line 2: 'u' contains a <use> of itself"},
    {"<svg viewBox='0 0 9 9' id='all'>\n<use href='#all'/></svg>", "line 1: 'all' contains a <use> of itself"},
    {"<svg viewBox='0 0 9 9'><use x='far' href='#a'/></svg>", "line 1: x: 'far' is not a length"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' stroke-dasharray='1 -2' d='M0 0 9 9'/></svg>",
     "line 1: stroke-dasharray: -2 is negative"},
    {"<svg viewBox='0 0 9 9'><path stroke='red' stroke-dasharray='1 b' d='M0 0 9 9'/></svg>",
     "line 1: stroke-dasharray: 'b' is not a length"},
    {"<svg viewBox='0 0 9 9'><g stroke-width='b'/></svg>", "line 1: stroke-width: 'b' is not a length"},
    {"<svg viewBox='0 0 9 9'><g stroke-dashoffset='b'/></svg>", "line 1: stroke-dashoffset: 'b' is not a length"},
    {"<svg viewBox='0 0 9 9'><symbol id='s' viewBox='0 0 1 1' height='b'/><use href='#s'/></svg>",
     "line 1: height: 'b' is not a length"},
    {"<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><svg viewBox='0 0 9 9'>&a;</svg>",
     "line 1: entity 'a' is external, which is not allowed"},
    {"<!DOCTYPE svg [<!ENTITY a 'ha'>\n<!ENTITY b '&a;&a;'>]><svg viewBox='0 0 9 9'>&b;</svg>",
     "line 2: entity 'b' refers to entities, which is not allowed"},
};

START_TEST(errors_name_their_line)
{
    list.count = notes.strokes = 77;
    ck_assert_int_eq(read_text(bad[_i].text), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, bad[_i].message);
    ck_assert(list.count == 77 && notes.strokes == 77);
}
END_TEST

START_TEST(the_limits_themselves_are_allowed)
{
    HATCH_TEST_OK(read_text("<svg viewBox='0 0 1e6 1e6'><path stroke='red' stroke-width='4e6' d='M5e5 5e5h9'/></svg>"),
                  &err);
    ck_assert_uint_eq(list.count, 1);
    HATCH_TEST_OK(read_text("<svg viewBox='0 0 8 8'><path stroke='red' stroke-width='0' d='M1 1h2'/></svg>"), &err);
    ck_assert_uint_eq(list.count, 0);
}
END_TEST

START_TEST(strokes_outside_may_be_wide_or_long)
{
    read_page("<g stroke='red' fill='none'><path stroke-width='500' d='M-400 0h-90'/>"
              "<path stroke-width='30' d='M20 20h9'/><path d='M-9e4 20H9e4'/><path d='M50 -1e4V1e4'/>"
              "<path d='M-6e3 20H6e3' id='near'/><path d='M-9e4 -20H9e4'/></g>");
    ck_assert_uint_eq(list.count, 2);
    ck_assert_float_eq_tol(list.items[0].width_px, 60, 1e-3f);
    ck_assert_float_eq_tol(list.items[1].length, 120, 1e-3f);
    ck_assert_uint_eq(notes.strokes, 2);
    ck_assert_uint_eq(notes.outside, 2);
    ck_assert_uint_eq(notes.far, 2);
}
END_TEST

START_TEST(a_huge_page_is_refused)
{
    ck_assert_int_eq(read_text("<svg width='1e9' height='1e9'/>"), HATCH_LIMIT);
    ck_assert_str_eq(err.text, "line 1: a page of 1e+09 x 1e+09 units, want at most 1e+06");
}
END_TEST

START_TEST(entities_and_units_are_read)
{
    HATCH_TEST_OK(read_text("<!DOCTYPE svg [<!ENTITY c 'navy'>]><svg width='10cm' height='100mm'>"
                            "<path stroke='&c;' d='M0 0 188.976 0'/></svg>"),
                  &err);
    ck_assert_uint_eq(list.count, 1);
    ck_assert_float_eq_tol(list.items[0].length, 0.5f, 1e-4f);
}
END_TEST

START_TEST(deep_groups_are_refused)
{
    static char text[100000];
    size_t at = (size_t)snprintf(text, sizeof text, "<svg viewBox='0 0 1 1'>");
    for (int i = 0; i < 300; i++, at += 3)
        memcpy(text + at, "<g>", 3);
    ck_assert_int_eq(read_text(text), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "line 1: elements nested deeper than 256");
}
END_TEST

START_TEST(drawings_are_distinguished_from_tables)
{
    static const char *const drawings[] = {"<svg/>", " \n<?xml?>", "\xef\xbb\xbf<svg/>", "\xff\xfe<"};
    static const char *const tables[] = {"", "x\ty\n", "# <svg>\nx", " "};
    for (int i = 0; i < 4; i++) {
        ck_assert(hatch_svg_is((struct hatch_bytes){(const uint8_t *)drawings[i], strlen(drawings[i])}));
        ck_assert(!hatch_svg_is((struct hatch_bytes){(const uint8_t *)tables[i], strlen(tables[i])}));
    }
}
END_TEST

static enum hatch_status make(void *context, struct hatch_arena *to, struct hatch_arena *work, struct hatch_err *error)
{
    const char *text = page("<style>.a{stroke-dasharray:3 4}</style><g id='g' stroke='red'>"
                            "<circle cx='9' cy='9' r='5'/>"
                            "<path class='a' d='M0 0 9 9'/></g><use href='#g'/>");
    (void)context;
    return hatch_svg_read((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, DRAWING_PX, to, work, &list,
                          &notes, error);
}

START_TEST(every_failed_allocation_is_a_limit)
{
    list.count = 0;
    hatch_test_fail_alloc(make, NULL, &list, sizeof list);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io svg");
    TCase *tests = tcase_create("svg");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, equivalent_paths_have_the_same_ends, 0, sizeof same_ends / sizeof *same_ends);
    tcase_add_loop_test(tests, points_of_curves_lie_on_them, 0, 3);
    tcase_add_test(tests, a_path_may_be_none);
    tcase_add_test(tests, shapes_have_the_right_lengths);
    tcase_add_test(tests, radii_may_be_absent);
    tcase_add_test(tests, arcs_lie_on_their_ellipse);
    tcase_add_loop_test(tests, a_stroke_has_its_computed_style, 0, sizeof styled / sizeof *styled);
    tcase_add_test(tests, ignored_elements_are_counted);
    tcase_add_loop_test(tests, errors_name_their_line, 0, sizeof bad / sizeof *bad);
    tcase_add_test(tests, the_limits_themselves_are_allowed);
    tcase_add_test(tests, strokes_outside_may_be_wide_or_long);
    tcase_add_test(tests, a_huge_page_is_refused);
    tcase_add_test(tests, entities_and_units_are_read);
    tcase_add_test(tests, deep_groups_are_refused);
    tcase_add_test(tests, clones_are_drawn_at_their_position);
    tcase_add_test(tests, dashes_become_strokes);
    tcase_add_test(tests, drawings_are_distinguished_from_tables);
    tcase_add_test(tests, every_failed_allocation_is_a_limit);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
