/* Compares the outlines of a drawing with the faces that it shows:
 *     bench_drawing OPTION ... -o FILE.svg   the options that render-gl has drawn FILE with
 * Prints the number of paths, their length in pixels, the percentage of the outline, and of the outline and the deeper
 * steps (tests/support/outline/truth.h), without a path within 1.5 pixels, and the largest distance of a path from the
 * faces, in pixels. */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "outline/truth.h"
#include "render-gl/mode/modes.h"
#include "vector/project.h"
#include "vector/step.h"

#define FOUND_PX 1.5
#define WALK_PX 0.125 /* distance of the places on paths that are looked at */

static struct job job;
static struct hatch_err err;
static struct hatch_view view;
static struct hatch_occluders occluders;
static struct outline_truth truth;

/* The paths of the layer of outlines, in pixels from the lower left corner of the picture. */
static struct hatch_vector_paths paths;

/* Short parts of paths, listed by pixel. */
struct part {
    double a[2], b[2];
    uint32_t next; /* in its pixel, + 1; 0: none */
};
static struct part *parts;
static uint32_t *pixels; /* the first part + 1 */

static void make_truth(void)
{
    struct hatch_unit_scene *unit = &job.scene.unit;
    struct hatch_arena *keep = &job.args.keep;
    static struct hatch_mesh whole;
    size_t vertices = 0, faces = 0, v = 0, f = 0;
    for (uint32_t i = 0; i < unit->item_count; i++) {
        vertices += unit->meshes[unit->items[i].mesh].surface->vertex_count;
        faces += unit->meshes[unit->items[i].mesh].surface->face_count;
    }
    cmd_check(hatch_mesh_make(keep, (uint32_t)vertices, (uint32_t)faces, &whole, &err), NULL, &err);
    double *at = HATCH_NEW(keep, double, 3 * vertices, &err);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        const struct hatch_mesh *surface = unit->meshes[unit->items[i].mesh].surface;
        hatch_item_surface(unit, &unit->items[i], at, NULL);
        for (size_t k = 0; k < 3 * (size_t)surface->vertex_count; k++)
            whole.attributes[0].data[3 * v + k] = (float)at[k];
        for (size_t k = 0; k < 3 * (size_t)surface->face_count; k++)
            whole.indices[3 * f + k] = (uint32_t)v + surface->indices[k];
        v += surface->vertex_count;
        f += surface->face_count;
    }
    truth_make(&whole, &view, job.options->width, job.options->height, keep, &truth);
    cmd_check(hatch_occluders_make(unit, &view, job.options->width, job.options->height, keep, &job.args.scratch,
                                   &occluders, &err),
              NULL, &err);
}

static void read_paths(void)
{
    struct options *options = job.options;
    const struct hatch_bytes bytes = cmd_read(&job.args, job.args.output);
    struct hatch_vector_builder builder = hatch_vector_builder_of(&job.args.keep);
    struct hatch_page page = options->page;
    double pixel = hatch_page_pixel_mm(&page, options->width, options->height);
    char *text = HATCH_NEW(&job.args.keep, char, bytes.size + 1, &err);
    memcpy(text, bytes.data, bytes.size);
    char *from = strstr(text, "<g id=\"outlines\""), *end = from ? strstr(from, "</g>") : NULL;
    while (from && (from = strstr(from, " d=\"M")) && from < end) {
        bool closed = false;
        static const struct hatch_vector_path like;
        hatch_vector_begin(&builder, &like);
        for (from += 5; *from != '"';) {
            if (*from == 'Z') {
                closed = true;
                from++;
                continue;
            }
            from += *from == 'L' || *from == ' ';
            double x = strtod(from, &from), y = strtod(from, &from);
            const double at[2] = {0.5 * options->width + (x - 0.5 * page.width_mm) / pixel,
                                  0.5 * options->height - (y - 0.5 * page.height_mm) / pixel};
            cmd_check(hatch_vector_add(&builder, at, &err), NULL, &err);
        }
        cmd_check(hatch_vector_end(&builder, closed, &err), NULL, &err);
    }
    paths = hatch_vector_built(&builder);
}

/* Lists the parts of a segment by pixel.
 *   count  in, out: number of parts */
static void list_segment(const double a[2], const double b[2], size_t *count)
{
    const uint32_t width = job.options->width, height = job.options->height;
    double n = ceil(hatch_vector_distance(a, b));
    for (double s = 0; s < n; s++) {
        struct part *part = &parts[*count];
        for (int c = 0; c < 2; c++) {
            part->a[c] = a[c] + s / n * (b[c] - a[c]);
            part->b[c] = a[c] + (s + 1) / n * (b[c] - a[c]);
        }
        double x = 0.5 * (part->a[0] + part->b[0]), y = 0.5 * (part->a[1] + part->b[1]);
        if (!(x >= 0 && y >= 0 && x < width && y < height))
            continue;
        uint32_t *first = &pixels[(size_t)y * width + (size_t)x];
        part->next = *first;
        *first = (uint32_t)++ * count;
    }
}

static void list_parts(void)
{
    size_t most = 0, count = 0;
    for (uint32_t i = 0; i < paths.count; i++)
        most += (size_t)hatch_vector_length(&paths, &paths.paths[i]) + 2 * (size_t)paths.paths[i].count;
    cmd_check(HATCH_ALLOC(&job.args.keep, &parts, most, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&job.args.keep, &pixels, (size_t)job.options->width * job.options->height, &err), NULL, &err);
    for (uint32_t i = 0; i < paths.count; i++)
        for (uint32_t k = 0; k < hatch_vector_segments(&paths.paths[i]); k++)
            list_segment(hatch_vector_point(&paths, &paths.paths[i], k),
                         hatch_vector_point(&paths, &paths.paths[i], k + 1), &count);
}

/* Returns the distance of a place from the paths, up to 3 pixels. */
static double path_distance(const double at[2])
{
    const long width = (long)job.options->width, height = (long)job.options->height;
    double least = 3;
    for (long y = (long)at[1] - 3; y <= (long)at[1] + 3; y++)
        for (long x = (long)at[0] - 3; x <= (long)at[0] + 3; x++)
            for (uint32_t i = x < 0 || y < 0 || x >= width || y >= height ? 0 : pixels[y * width + x]; i;
                 i = parts[i - 1].next)
                least = fmin(least, hatch_vector_distance_to(at, parts[i - 1].a, parts[i - 1].b));
    return least;
}

/* Returns the distance of a place in the background from the faces, up to 100 pixels. */
static double face_distance(const double at[2])
{
    double least = 100;
    uint32_t count = occluders.first_face[job.scene.unit.item_count];
    for (uint32_t f = 0; f < count; f++) {
        double p[3][2];
        if (!occluders.facing[f])
            continue;
        for (int c = 0; c < 3; c++) {
            const double *q = &occluders.points[3 * (size_t)occluders.corners[3 * (size_t)f + (size_t)c]];
            double w = view.orthographic ? 1 : q[2];
            p[c][0] = q[0] / w;
            p[c][1] = q[1] / w;
        }
        bool far = false;
        for (int k = 0; k < 2; k++)
            far = far || fmin(p[0][k], fmin(p[1][k], p[2][k])) > at[k] + least ||
                  fmax(p[0][k], fmax(p[1][k], p[2][k])) < at[k] - least;
        for (int c = 0; c < 3 && !far; c++)
            least = fmin(least, hatch_vector_distance_to(at, p[c], p[(c + 1) % 3]));
    }
    return least;
}

/* Returns the number of places of the outline and of steps that have no path.
 *   count  out: number of places
 *   kinds  bits of truth.border */
static size_t find_missed(uint8_t kinds, size_t *count)
{
    size_t missed = 0;
    *count = 0;
    for (size_t i = 0; i < (size_t)truth.width * truth.height; i++) {
        if (!(truth.border[i] & kinds))
            continue;
        const double at[2] = {((double)(i % truth.width) + 0.75) / TRUTH_SIDE,
                              ((double)(i / truth.width) + 0.75) / TRUTH_SIDE};
        ++*count;
        missed += path_distance(at) > FOUND_PX;
    }
    return missed;
}

/* Returns the largest distance of a path from the faces. */
static double find_outside(void)
{
    double most = 0;
    for (uint32_t i = 0; i < paths.count; i++)
        for (uint32_t k = 0; k < hatch_vector_segments(&paths.paths[i]); k++) {
            const double *a = hatch_vector_point(&paths, &paths.paths[i], k);
            const double *b = hatch_vector_point(&paths, &paths.paths[i], k + 1);
            double n = ceil(hatch_vector_distance(a, b) / WALK_PX), depth;
            for (double s = 0; s <= n; s++) {
                const double at[2] = {a[0] + s / n * (b[0] - a[0]), a[1] + s / n * (b[1] - a[1])};
                if (!hatch_occluders_find(&occluders, at, &depth))
                    most = fmax(most, face_distance(at));
            }
        }
    return most;
}

static int argument_count;
static char **arguments;

START_TEST(measure)
{
    job.options = options_read(argument_count, arguments, &job.args);
    params_read(job.options);
    job_read(&job);
    job_prepare_without_gpu(&job);
    job_set_frame(&job, 0, &view);
    make_truth();
    read_paths();
    list_parts();
    size_t outline, all, outline_missed = find_missed(TRUTH_OUTLINE, &outline);
    size_t missed = find_missed(TRUTH_OUTLINE | TRUTH_STEP, &all);
    double length = 0;
    for (uint32_t i = 0; i < paths.count; i++)
        length += hatch_vector_length(&paths, &paths.paths[i]);
    printf("%u\t%.0f\t%.3f\t%.3f\t%.2f\n", (unsigned)paths.count, length,
           100 * (double)outline_missed / (double)outline, 100 * (double)missed / (double)all, find_outside());
    fflush(stdout);
}
END_TEST

int main(int argc, char **argv)
{
    argument_count = argc;
    arguments = argv;
    return hatch_bench_main("bench drawing", measure);
}
