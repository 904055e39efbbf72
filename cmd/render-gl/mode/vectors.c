/* Writes drawings for pens: the feature lines of frames, and their strokes, as SVG files or stroke scripts. The
 * visible parts of lines are computed on the processor, so that lines alone need no context. */
#include <stdio.h>
#include <string.h>

#include "io/script/write.h"
#include "io/svg/write.h"
#include "math/angle.h"
#include "render-gl/mode/modes.h"
#include "render-gl/mode/outlines.h"
#include "vector/project.h"
#include "vector/tidy/tidy.h"

/* The pens of a drawing. Strokes have one for each direction and each ink. */
enum layer {
    LAYER_OUTLINES,
    LAYER_HIDDEN,
    LAYER_STROKES,
    LAYER_LIGHT = LAYER_STROKES + HATCH_CURVE_FAMILIES_MAX, /* strokes of the second ink */
    LAYER_COUNT = LAYER_LIGHT + HATCH_CURVE_FAMILIES_MAX
};

#define DOUBLE_PENS 0.5   /* lines at most this many pen widths apart are one line */
#define JOIN_PENS 1.0     /* ends at most this many pen widths apart, whose round caps touch, are joined */
#define TOLERANCE_MM 0.05 /* largest distance from a line to its simplified path */
#define SPECK_PX 6.0      /* shorter paths of which no end meets another path are left out */
#define MEET_PX 2.0       /* a path meets another one at most this far from its end */
#define SHORTEST_PX 2.0   /* shorter paths are left out */
#define DASH_PENS 6.0     /* length of dashes and of the gaps between them, in pen widths */
#define GAP_PENS 4.0
#define LAYER_NAME_BYTES 24u

static const struct hatch_vector_care care = {.gap_px = 1, .speck_px = 1};

/* State of writing the frames of a job. */
struct drawing {
    struct job *job;
    struct hatch_lines lines;
    struct hatch_arena *arena;            /* of one frame */
    uint32_t film;                        /* of the frame, as in struct frame_request */
    struct canvas canvas;                 /* zeroed: the technique has no curves */
    uint32_t stroke_layers[2];            /* of the frame, of each ink */
    const struct hatch_stroke_look *look; /* of its strokes */
    struct hatch_page page;
    double pixel_mm, pen_mm;           /* on the page */
    struct hatch_vector_builder paths; /* of one frame, on the page */
};

/* Places paths on the page and makes them ready for the pen.
 *   drawn   paths on the page that they must not run along; NULL: none
 *   single  out: what remains of them before ends are joined */
static enum hatch_status tidy(struct drawing *drawing, const struct hatch_vector_paths *drawn,
                              struct hatch_vector_paths *paths, struct hatch_vector_paths *single,
                              struct hatch_err *err)
{
    const struct options *options = drawing->job->options;
    struct hatch_arena *arena = drawing->arena, *scratch = &drawing->job->args.scratch;
    double pixel_mm = drawing->pixel_mm, pen_mm = drawing->pen_mm;
    hatch_page_place(&drawing->page, options->width, options->height, pixel_mm, paths);
    HATCH_TRY(hatch_vector_drop_doubles(paths, drawn, DOUBLE_PENS * pen_mm, arena, scratch, single, err));
    HATCH_TRY(hatch_vector_join(single, JOIN_PENS * pen_mm, arena, scratch, paths, err));
    HATCH_TRY(hatch_vector_drop_specks(paths, SPECK_PX * pixel_mm, MEET_PX * pixel_mm, scratch, err));
    return hatch_vector_simplify(paths, TOLERANCE_MM, SHORTEST_PX * pixel_mm, scratch, err);
}

/* Adds the visible parts of curves to the drawing, and the hidden ones, as dashes, if they are wanted. */
static enum hatch_status add_curves(struct drawing *drawing, const struct hatch_occluders *occluders,
                                    const struct hatch_vector_curves *curves, struct hatch_err *err)
{
    struct hatch_arena *arena = drawing->arena, *scratch = &drawing->job->args.scratch;
    bool dashed = drawing->job->options->hidden == OPTION_HIDDEN_DASH;
    struct hatch_vector_paths visible, drawn, hidden, rest, dashes;
    HATCH_TRY(hatch_vector_see(occluders, curves, NULL, &care, arena, scratch, &visible, dashed ? &hidden : NULL, err));
    HATCH_TRY(tidy(drawing, NULL, &visible, &drawn, err));
    HATCH_TRY(hatch_vector_append(&drawing->paths, &visible, err));
    if (!dashed)
        return HATCH_OK;
    HATCH_TRY(tidy(drawing, &drawn, &hidden, &rest, err));
    HATCH_TRY(hatch_vector_dash(&hidden, DASH_PENS * drawing->pen_mm, GAP_PENS * drawing->pen_mm, arena, scratch,
                                &dashes, err));
    for (uint32_t i = 0; i < dashes.count; i++)
        dashes.paths[i].layer = LAYER_HIDDEN;
    return hatch_vector_append(&drawing->paths, &dashes, err);
}

static struct hatch_tile whole(const struct drawing *drawing)
{
    const double width = drawing->job->options->width, height = drawing->job->options->height;
    return (struct hatch_tile){0, 0, width, height, width, height};
}

/* film: as in struct frame_request */
static struct frame_request request_of(const struct drawing *drawing, const struct hatch_view *view,
                                       const struct hatch_tile *tile, uint32_t film)
{
    return (struct frame_request){.view = view,
                                  .tile = tile,
                                  .canvas = &drawing->canvas,
                                  .background = drawing->job->options->inks.paper,
                                  .film = film};
}

static double pen_px(const struct drawing *drawing)
{
    return drawing->pen_mm / drawing->pixel_mm;
}

/* Adds the visible parts of the technique's strokes. */
static enum hatch_status add_strokes(struct drawing *drawing, const struct hatch_view *view,
                                     const struct hatch_occluders *occluders, struct hatch_err *err)
{
    struct job *job = drawing->job;
    const struct options *options = job->options;
    struct hatch_arena *arena = drawing->arena, *scratch = &job->args.scratch;
    const struct hatch_tile tile = whole(drawing);
    const struct frame_request request = request_of(drawing, view, &tile, drawing->film);
    struct technique_curves strokes;
    struct hatch_vector_paths visible;
    HATCH_TRY(technique_find_curves(&job->context, job_open(job, options->technique, err), &request, pen_px(drawing),
                                    arena, &strokes, err));
    visible = strokes.paths;
    if (strokes.curves.count)
        HATCH_TRY(
            hatch_vector_see(occluders, &strokes.curves, &strokes.pen, &care, arena, scratch, &visible, NULL, err));
    hatch_page_place(&drawing->page, options->width, options->height, drawing->pixel_mm, &visible);
    HATCH_TRY(hatch_vector_simplify(&visible, TOLERANCE_MM, strokes.shortest_px * drawing->pixel_mm, scratch, err));
    memcpy(drawing->stroke_layers, strokes.layer_counts, sizeof drawing->stroke_layers);
    for (uint32_t i = 0; i < visible.count; i++)
        visible.paths[i].layer += LAYER_STROKES;
    drawing->look = strokes.look;
    return hatch_vector_append(&drawing->paths, &visible, err);
}

/* Sets the page, and the pen, which --animate may change. */
static void set_page(struct drawing *drawing)
{
    const struct options *options = drawing->job->options;
    drawing->page = options->page;
    drawing->pixel_mm = hatch_page_pixel_mm(&drawing->page, options->width, options->height);
    drawing->pen_mm = options->pen_mm > 0 ? options->pen_mm : options->line_px * drawing->pixel_mm;
}

/* Foresees the strokes of a drawing. */
static enum hatch_status foresee(void *data, uint32_t film, const struct hatch_view *view, struct hatch_err *err)
{
    struct drawing *drawing = data;
    struct job *job = drawing->job;
    const struct hatch_tile tile = whole(drawing);
    const struct frame_request request = request_of(drawing, view, &tile, film);
    set_page(drawing);
    return technique_foresee(&job->context, job_open(job, job->options->technique, err), &request, pen_px(drawing),
                             err);
}

/* Returns the number of layers of feature lines: LAYER_OUTLINES, and LAYER_HIDDEN if hidden ones are dashed. */
static uint32_t line_layers(const struct options *options)
{
    return options->line_kinds == HATCH_LINES_NONE ? 0 : options->hidden == OPTION_HIDDEN_DASH ? 2 : 1;
}

/* Returns the place of a layer among those of the frame. Strokes of the second ink come first, so that outlines and the
 * first ink lie over them. */
static uint32_t place_of(const struct drawing *drawing, uint32_t layer)
{
    if (layer >= LAYER_LIGHT)
        return layer - LAYER_LIGHT;
    if (layer < LAYER_STROKES)
        return drawing->stroke_layers[1] + layer;
    return drawing->stroke_layers[1] + line_layers(drawing->job->options) + layer - LAYER_STROKES;
}

/* Finds the paths of the posed scene on the page. */
static enum hatch_status find_paths(struct drawing *drawing, const struct hatch_view *view,
                                    struct hatch_vector_paths *paths, struct hatch_err *err)
{
    static const enum hatch_vector_order orders[] = {HATCH_VECTOR_IMPROVED, HATCH_VECTOR_NEAREST};
    struct job *job = drawing->job;
    const struct options *options = job->options;
    struct hatch_arena *arena = drawing->arena, *scratch = &job->args.scratch;
    struct hatch_occluders occluders;
    struct hatch_vector_curves outlines;
    drawing->paths = hatch_vector_builder_of(arena);
    HATCH_TRY(
        hatch_occluders_make(&job->scene.unit, view, options->width, options->height, arena, scratch, &occluders, err));
    HATCH_TRY(outlines_trace(&drawing->lines, view, options->height, &occluders, arena, &outlines, err));
    HATCH_TRY(add_curves(drawing, &occluders, &outlines, err));
    if (options->technique->curves)
        HATCH_TRY(add_strokes(drawing, view, &occluders, err));
    *paths = hatch_vector_built(&drawing->paths);
    for (uint32_t i = 0; i < paths->count; i++)
        paths->paths[i].layer = place_of(drawing, paths->paths[i].layer);
    return options->sort == OPTION_SORT_NONE ? HATCH_OK : hatch_vector_sort(paths, orders[options->sort], scratch, err);
}

/* Tells with --verbose what the pen does. */
static void note_ways(const struct hatch_vector_paths *paths)
{
    double drawn_mm, lifted_mm;
    hatch_vector_ways(paths, &drawn_mm, &lifted_mm);
    cmd_note("%u %s, %.0f mm drawn, %.0f mm lifted", paths->count, cmd_plural(paths->count, "path", "paths"), drawn_mm,
             lifted_mm);
}

/* Names the layers of a frame, in their order, and gives them colours and pens.
 *   names   out: memory for the names
 *   layers  out: LAYER_COUNT of them */
static void set_layers(const struct drawing *drawing, char (*names)[LAYER_NAME_BYTES],
                       struct hatch_drawing_layer *layers)
{
    const struct options *options = drawing->job->options;
    for (uint32_t i = 0; i < LAYER_COUNT; i++) {
        const bool lines = i < LAYER_STROKES, second = i >= LAYER_LIGHT;
        const uint32_t first = second ? LAYER_LIGHT : LAYER_STROKES;
        if (lines ? i >= line_layers(options) : i - first >= drawing->stroke_layers[second])
            continue;
        struct hatch_drawing_layer *layer = &layers[place_of(drawing, i)];
        snprintf(names[i], sizeof names[i], second ? "light-%u" : "strokes-%u", i - first + 1);
        layer->name = i == LAYER_OUTLINES ? "outlines" : lines ? "hidden" : names[i];
        layer->look = lines ? NULL : drawing->look;
        layer->pen_mm = drawing->pen_mm;
        memcpy(layer->color,
               lines    ? options->line_color
               : second ? options->inks.light_ink
                        : options->inks.ink,
               sizeof layer->color);
    }
}

/* Draws the posed scene as a file.
 *   empty  in, out: number of drawings without paths */
static enum hatch_status draw(struct drawing *drawing, const struct hatch_view *view, struct hatch_buffer *file,
                              uint32_t *empty, struct hatch_err *err)
{
    const struct options *options = drawing->job->options;
    struct hatch_drawing made = {.layers = NULL};
    const struct hatch_page *page = &drawing->page;
    struct hatch_drawing_layer layers[LAYER_COUNT] = {{.name = NULL}};
    char names[LAYER_COUNT][LAYER_NAME_BYTES];
    set_page(drawing);
    memcpy(made.paper, options->inks.paper, sizeof made.paper);
    made.layers = layers;
    made.width_mm = page->width_mm;
    made.height_mm = page->height_mm;
    HATCH_TRY(find_paths(drawing, view, &made.paths, err));
    set_layers(drawing, names, layers);
    made.layer_count = line_layers(options) + drawing->stroke_layers[0] + drawing->stroke_layers[1];
    note_ways(&made.paths);
    *empty += !made.paths.count;
    return (options->script ? hatch_script_write : hatch_svg_write)(&made, &drawing->job->args.scratch, file, err);
}

/* Returns why a drawing is empty. */
static const char *reason_of(const struct options *options)
{
    const bool strokes = options->technique->curves != NULL, lines = options->line_kinds != HATCH_LINES_NONE;
    return strokes && lines ? "no stroke and no feature line is in sight"
           : strokes        ? "no stroke is in sight"
           : lines          ? "no feature line is in sight"
                            : "--lines none draws no feature lines, and the technique has no strokes for a pen";
}

void vectors_write(struct job *job)
{
    const struct options *options = job->options;
    struct hatch_arena *keep = &job->args.keep;
    const struct hatch_line_style style = {
        .kinds = options->line_kinds, .width_px = options->line_px, .crease_rad = options->crease_deg * HATCH_RADIANS};
    struct drawing drawing = {.job = job, .arena = keep};
    struct hatch_err err;
    struct cmd_file *files = HATCH_NEW(keep, struct cmd_file, options->frames, &err);
    cmd_check(files ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    if (options->technique->curves)
        job_make_canvas(job, &drawing.canvas);
    cmd_check(hatch_lines_make(&job->scene.unit, &style, keep, &job->args.scratch, &drawing.lines, &err), NULL, &err);
    uint32_t empty = 0;
    for (uint32_t frame = 0; frame < options->frames; frame++) {
        struct hatch_view view;
        cmd_progress("drawing", (double)frame / options->frames);
        drawing.film = job_set_film_frame(job, frame, foresee, &drawing, &view);
        struct hatch_arena_mark mark = hatch_arena_mark(keep);
        struct hatch_buffer bytes = {.arena = keep};
        cmd_check(draw(&drawing, &view, &bytes, &empty, &err), NULL, &err);
        files[frame] = (struct cmd_file){.output = job->outputs[frame], .data = bytes.data, .size = bytes.size};
        if (cmd_write_ahead(&files[frame])) {
            files[frame] = (struct cmd_file){.output = job->outputs[frame]};
            hatch_arena_rewind(keep, mark);
        }
    }
    if (empty && !job->empty)
        cmd_warn(cmd_input_name(options->scene_path), "%u of %u drawings %s empty: %s", empty, options->frames,
                 cmd_plural(empty, "is", "are"), reason_of(options));
    cmd_write_all(files, options->frames);
}
