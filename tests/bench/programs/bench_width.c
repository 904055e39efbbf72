/* Measures the width of strokes on the screen relative to the requested width, on the teapot from 0.01 to 1000 radii:
 * for rptam as drawn; for Algorithm 2 as printed, which measures across the strokes on the surface and not in the
 * picture; and for a tonal art map of four levels made for a distance of 3 radii. Widths are measured across the stroke
 * in the picture, with the exact derivatives of each face's texture coordinates. */
#include <stdio.h>

#include "bench.h"
#include "rptam_model.h"
#include "zoom_reference.h"

enum { COLUMNS = 24, ROWS = 18, VIEWS = 12, SAMPLES = VIEWS * COLUMNS * ROWS, HEIGHT_PX = 720 };
enum { MAP_PX = 512, LEVELS = 4 };

#define RADIUS 1.7

static struct test_frame frame;
static struct hatch_rptam rptam;
static struct hatch_mesh mesh;

static void begin(void)
{
    static const struct model_how how_drawn = {.tile_px = 256, .length_px = 80, .width_px = 3};
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_TEAPOT, 20000);
    model_make(&how_drawn, &frame.args.keep, &frame.args.scratch, &rptam);
    const struct hatch_bounds bounds = {.radius = RADIUS};
    frame_open(&mesh, &bounds, NULL, &frame);
    frame.model = &rptam;
    frame_picture(&frame, "rptam");
}

/* The width on the screen of a strip along u that is one unit of v wide. */
static double across(double pixels[2][2])
{
    return fabs(pixels[0][0] * pixels[1][1] - pixels[0][1] * pixels[1][0]) / hypot(pixels[0][0], pixels[0][1]);
}

struct widths {
    size_t count;
    double rptam[SAMPLES], paper[SAMPLES], map[SAMPLES];
};

/* Computes the derivatives of the position with respect to u and v on a face, in the unit scene. */
static bool face_spans(const struct hatch_view *view, const struct zoom_corner *const c[3], double span[6])
{
    const double *axes[3] = {view->right, view->up, view->back};
    double edge[2][3], uv[2][2];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++)
            edge[i][k] = hatch_pair_round(hatch_pair_sub(c[i + 1]->at[k], c[0]->at[k]));
        for (int k = 0; k < 2; k++)
            uv[i][k] = hatch_pair_round(hatch_pair_sub(c[i + 1]->uv[k], c[0]->uv[k]));
    }
    double turn = uv[0][0] * uv[1][1] - uv[1][0] * uv[0][1];
    for (int k = 0; k < 6; k++)
        span[k] = 0;
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 3; axis++) {
            span[axis] += axes[k][axis] * (uv[1][1] * edge[0][k] - uv[0][1] * edge[1][k]) / turn;
            span[3 + axis] += axes[k][axis] * (uv[0][0] * edge[1][k] - uv[1][0] * edge[0][k]) / turn;
        }
    return fabs(turn) > 0;
}

/* Width of the strokes of a map with one tile per unit of u and v, at the level given by the longer side of its texels
 * on the screen. */
static double map_width(double pixels[2][2])
{
    const double texels = MAP_PX;
    double area = fabs(pixels[0][0] * pixels[1][1] - pixels[0][1] * pixels[1][0]);
    double x = hypot(pixels[1][1], pixels[0][1]) / area * texels, y = hypot(pixels[1][0], pixels[0][0]) / area * texels;
    double level = fmin(fmax(log2(fmax(x, y)), 0), LEVELS - 1);
    return across(pixels) / texels * exp2(level);
}

static void look(const struct hatch_view *view, double window, struct widths *widths)
{
    struct hatch_arena_mark mark = hatch_arena_mark(&frame.args.keep);
    struct zoom_corner *corners = HATCH_NEW(&frame.args.keep, struct zoom_corner, mesh.vertex_count, &frame.err);
    zoom_corners(&frame, view, corners);
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        double x = 0.5 + window * ((i % COLUMNS + 0.5) / COLUMNS - 0.5);
        double y = 0.5 + window * ((i / COLUMNS + 0.5) / ROWS - 0.5);
        const struct zoom_ray ray = zoom_ray_of(view, x, y);
        const struct zoom_corner *face[3];
        struct hatch_pair uv[2];
        double smooth[6], span[6], drawn[2][2], pixels[2][2], hit = zoom_hit(&mesh, corners, &ray, uv, smooth, face);
        if (!(hit > 0) || !face_spans(view, face, span))
            continue;
        zoom_pixels(view, &ray, hit, HEIGHT_PX, smooth, drawn);
        zoom_pixels(view, &ray, hit, HEIGHT_PX, span, pixels);
        widths->rptam[widths->count] = across(pixels) / across(drawn);
        widths->paper[widths->count] = across(pixels) / hypot(drawn[1][0], drawn[1][1]);
        widths->map[widths->count++] = map_width(pixels);
    }
    hatch_arena_rewind(&frame.args.keep, mark);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_row(const char *method, double radii, double *widths, size_t count)
{
    size_t within = 0;
    for (size_t i = 0; i < count; i++)
        within += widths[i] > 0.75 && widths[i] < 1.25;
    qsort(widths, count, sizeof *widths, by_size);
    printf("%s\t%g\t%zu\t%.4f\t%.4f\t%.4f\t%.4f\n", method, radii, count, widths[count / 20], widths[count / 2],
           widths[count - 1 - count / 20], (double)within / (double)count);
}

/* A view of the centroid of a face, half a radian off its normal. */
static struct hatch_view view_over(uint32_t face, double radii)
{
    double corner[3][3], point[3], normal[3], side[3];
    hatch_mesh_corners(&mesh, face, corner);
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    hatch_vec_normalize(normal);
    hatch_vec_any_orthogonal(normal, side);
    for (int k = 0; k < 3; k++)
        point[k] = (corner[0][k] + corner[1][k] + corner[2][k]) / 3;
    hatch_vec_add_scaled(normal, tan(0.5), side, side);
    hatch_vec_normalize(side);
    return zoomed_view(&frame, point, side, RADIUS * radii, 4.0 / 3);
}

START_TEST(measure)
{
    static struct widths widths;
    printf("method\tradii\tsamples\tp5\tmedian\tp95\twithin_quarter\n");
    begin();
    for (int step = -4; step <= 6; step++) {
        double radii = pow(10, 0.5 * step);
        widths.count = 0;
        for (uint32_t i = 0; i < VIEWS; i++) {
            struct hatch_view view = view_over((2 * i + 1) * (mesh.face_count / (2 * VIEWS)), radii);
            look(&view, fmin(1, 4 / radii), &widths);
        }
        print_row("rptam", radii, widths.rptam, widths.count);
        print_row("rptam, as printed", radii, widths.paper, widths.count);
        print_row("tam", radii, widths.map, widths.count);
    }
    fflush(stdout);
    frame_finish(&frame);
}
END_TEST

HATCH_BENCH_MAIN("bench width", measure)
