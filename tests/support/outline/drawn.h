/* Pictures of the outlines of a mesh as render-gl draws them, on white surfaces, and their agreement with the truth. */
#ifndef HATCH_TEST_OUTLINE_DRAWN_H
#define HATCH_TEST_OUTLINE_DRAWN_H

#include "outline/truth.h"
#include "render_frame.h"

#define DRAWN_VIEWS 12
#define DRAWN_CREASE_RAD 1.0471975512f

/* Lines of a picture as the GPU receives them. Segments that continue one another are one path. */
struct drawn_paths {
    size_t count, segments, shorter; /* shorter: paths below 2 pixels */
    double length_px;
};

struct drawn {
    struct test_frame frame;
    struct line_overlay lines, silhouettes; /* with boundaries, and without */
    struct hatch_mesh mesh;
};

/* Moves and scales a mesh into the unit sphere. */
static inline void drawn_normalize(struct hatch_mesh *mesh)
{
    float low[3], high[3], radius = 0, *p = mesh->attributes[0].data;
    hatch_mesh_bounds(mesh, low, high);
    for (int k = 0; k < 3; k++)
        radius += (high[k] - low[k]) * (high[k] - low[k]);
    radius = 0.5f * sqrtf(radius);
    for (size_t i = 0; i < 3 * (size_t)mesh->vertex_count; i++)
        p[i] = (p[i] - 0.5f * (low[i % 3] + high[i % 3])) / radius;
}

static inline void drawn_lines(struct test_frame *frame, uint32_t kinds, struct line_overlay *lines)
{
    const struct line_overlay_style style = {
        .lines = {.kinds = kinds, .width_px = 1, .crease_rad = (double)DRAWN_CREASE_RAD}};
    HATCH_TEST_OK(line_overlay_make(lines, &frame->on_gpu, &style, &frame->shown.programs, &frame->args, &frame->err),
                  &frame->err);
}

/* Opens a mesh that fits into the unit sphere; its arenas are those of frame, which frame_arenas has made. */
static inline void drawn_open(const struct hatch_mesh *mesh, struct drawn *drawn)
{
    struct test_frame *frame = &drawn->frame;
    drawn->mesh = *mesh;
    if (!hatch_mesh_find(mesh, "NORMAL", 3))
        HATCH_TEST_OK(hatch_mesh_add_normals(&frame->args.keep, &frame->args.scratch, &drawn->mesh, DRAWN_CREASE_RAD,
                                             &frame->err),
                      &frame->err);
    frame_open(&drawn->mesh, &frame_unit, NULL, frame);
    frame->shown.style.curve.high = 0;
    drawn_lines(frame, HATCH_LINES_SILHOUETTES | HATCH_LINES_BOUNDARIES, &drawn->lines);
    drawn_lines(frame, HATCH_LINES_SILHOUETTES, &drawn->silhouettes);
}

static inline void drawn_close(struct drawn *drawn)
{
    line_overlay_free(&drawn->lines);
    line_overlay_free(&drawn->silhouettes);
    frame_finish(&drawn->frame);
}

/* Returns view number i of DRAWN_VIEWS: all around, from above and from below. */
static inline struct hatch_view drawn_view(int i, double aspect)
{
    double azimuth = 0.3 + 2 * 3.14159265358979 * i / DRAWN_VIEWS, height = 0.7 * sin(1.7 * i);
    struct hatch_view view = {.aspect = aspect, .half_height = 0.27, .near = 1e-3, .far = 100, .pivot = 4};
    view.eye[0] = 4 * sin(azimuth) * cos(height);
    view.eye[1] = 4 * sin(height);
    view.eye[2] = 4 * cos(azimuth) * cos(height);
    hatch_view_set_back(&view, view.eye);
    return view;
}

/* Draws lines alone; ink is 1 where they cover a pixel. */
static inline void drawn_ink(struct drawn *drawn, struct line_overlay *lines, const struct hatch_view *view,
                             uint32_t width, uint32_t height, struct hatch_image *ink)
{
    drawn->frame.lines = lines;
    frame_draw(&drawn->frame, "gouraud", view, width, height, 2, ink);
    for (size_t i = 0; i < 3 * (size_t)width * height; i++)
        ink->pixels[i] = 1 - ink->pixels[i];
}

/* Counts the paths of the picture drawn last. */
static inline void drawn_count(const struct drawn *drawn, struct drawn_paths *paths)
{
    GLint64 size = 0;
    glGetNamedBufferParameteri64v(drawn->lines.segments, GL_BUFFER_SIZE, &size);
    size_t count = (size_t)size / sizeof(struct hatch_line_segment);
    struct hatch_line_segment *segments = calloc(count + 1, sizeof *segments);
    ck_assert_ptr_nonnull(segments);
    glGetNamedBufferSubData(drawn->lines.segments, 0, (GLsizeiptr)size, segments);
    double length = 0;
    for (size_t i = 0; i < count; i++) {
        const struct hatch_line_segment *s = &segments[i];
        length += hypot((double)(s->b[0] - s->a[0]), (double)(s->b[1] - s->a[1]));
        bool ends = i + 1 == count || s->b[0] != s[1].a[0] || s->b[1] != s[1].a[1];
        paths->count += ends;
        paths->shorter += ends && length < 2;
        paths->length_px += ends ? length : 0;
        length = ends ? 0 : length;
    }
    paths->segments += count;
    free(segments);
}

/* Draws a view and compares it with the truth: all outlines need a line, and all silhouettes must be outlines.
 *   shown  out: the lines, with faults in colour
 *   score  in and out: added to */
static inline void drawn_compare(struct drawn *drawn, const struct hatch_view *view, uint32_t width, uint32_t height,
                                 struct hatch_image *shown, struct outline_score *score)
{
    struct outline_truth truth;
    struct hatch_image ink, silhouettes;
    struct hatch_arena_mark mark = hatch_arena_mark(&drawn->frame.args.scratch);
    truth_make(&drawn->mesh, view, width, height, &drawn->frame.args.scratch, &truth);
    drawn_ink(drawn, &drawn->silhouettes, view, width, height, &silhouettes);
    drawn_ink(drawn, &drawn->lines, view, width, height, &ink);
    HATCH_TEST_OK(hatch_image_make(&drawn->frame.args.keep, width, height, "RGB", shown, &drawn->frame.err),
                  &drawn->frame.err);
    for (size_t i = 0; i < 3 * (size_t)width * height; i++)
        shown->pixels[i] = 1 - ink.pixels[i];
    truth_find_lines(&truth, &ink, shown, score);
    truth_check_lines(&truth, &silhouettes, shown, score);
    hatch_arena_rewind(&drawn->frame.args.scratch, mark);
}

#endif
