/* Measures how well outlines agree with the outline of the faces that are drawn (tests/support/outline/truth.h): on
 * built-in shapes of 80 to 2,000 faces, on scans decimated to as many, and on fine meshes, in twelve views each.
 * Arguments, all optional: a folder of scans; a folder for pictures; the name of the only mesh to measure. */
#include <stdio.h>

#include "bench.h"
#include "io/mesh/file.h"
#include "io/openmesh/openmesh.h"
#include "io/png/png.h"
#include "outline/drawn.h"

enum { WIDTH = 960, HEIGHT = 720 };

static const char *scans, *pictures, *only;

static const struct subject {
    const char *name; /* of a built-in shape, or of a scan's file */
    uint32_t faces;   /* 0: those of the scan */
} subjects[] = {
    {"sphere", 80},
    {"sphere", 300},
    {"sphere", 2000},
    {"ellipsoid", 200},
    {"torus", 120},
    {"torus", 400},
    {"torus", 1500},
    {"teapot", 400},
    {"teapot", 1000},
    {"teapot", 2000},
    {"superquadric", 150},
    {"superquadric", 800},
    {"bump", 300},
    {"bump", 1000},
    {"cylinder", 100},
    {"frustum", 200},
    {"saddle", 200},
    {"eggbox", 800},
    {"stanford-bunny.ply", 500},
    {"stanford-bunny.ply", 2000},
    {"cow.obj", 500},
    {"cow.obj", 2000},
    {"igea.ply", 1000},
    {"armadillo.obj", 2000},
    {"horse.ply", 1000},
    {"hand.off", 600},
    {"blub.obj", 1000},
    {"rocker-arm.obj", 500},
    {"gargoyle.obj", 1500},
    {"teapot.obj", 1000},
    {"featuretype.stl", 2000},
    {"teapot", 6320},
    {"teapot", 20000},
    {"sphere", 20000},
    {"torus", 20000},
    {"teapot.obj", 0},
    {"stanford-bunny.ply", 0},
    {"igea.ply", 60000},
    {"armadillo.obj", 0},
};

/* Reads a scan, decimated; returns false if there is none. */
static bool read_scan(struct test_frame *frame, const struct subject *subject, struct hatch_mesh *mesh)
{
    char path[1024];
    struct hatch_mesh_file file;
    struct hatch_mesh_notes notes = {0};
    struct hatch_mesh whole;
    double origin[3];
    snprintf(path, sizeof path, "%s/%s", scans ? scans : "", subject->name);
    FILE *there = scans ? fopen(path, "rb") : NULL;
    if (!there)
        return false;
    fclose(there);
    file.bytes = cmd_read(&frame->args, path);
    file.format = hatch_mesh_format_of(file.bytes, path);
    HATCH_TEST_OK(hatch_mesh_read(file, &frame->args.keep, &frame->args.scratch, &whole, origin, &notes, &frame->err),
                  &frame->err);
    *mesh = whole;
    mesh->attribute_count = 1;
    if (subject->faces)
        HATCH_TEST_OK(hatch_mesh_decimate(&whole, subject->faces, &frame->args.keep, &frame->args.scratch, mesh, NULL,
                                          &frame->err),
                      &frame->err);
    return true;
}

static bool make(struct test_frame *frame, const struct subject *subject, struct hatch_mesh *mesh)
{
    for (uint32_t i = 0; hatch_shape_names[i]; i++)
        if (strcmp(hatch_shape_names[i], subject->name) == 0) {
            *mesh = frame_shape(frame, (enum hatch_shape)i, subject->faces);
            return true;
        }
    return read_scan(frame, subject, mesh);
}

static void keep_picture(struct drawn *drawn, const struct subject *subject, int view, struct hatch_image *shown)
{
    char path[1024];
    struct hatch_buffer file = {.arena = &drawn->frame.args.keep};
    snprintf(path, sizeof path, "%s/%s-%u-%d.png", pictures, subject->name, (unsigned)subject->faces, view);
    HATCH_TEST_OK(hatch_png_write(shown, HATCH_PNG_SRGB, 8, NULL, &drawn->frame.args.scratch, &file, &drawn->frame.err),
                  &drawn->frame.err);
    FILE *out = fopen(path, "wb");
    ck_assert_ptr_nonnull(out);
    ck_assert_uint_eq(fwrite(file.data, 1, file.size, out), file.size);
    ck_assert_int_eq(fclose(out), 0);
}

static double percent(size_t part, size_t whole)
{
    return whole ? 100.0 * (double)part / (double)whole : 0;
}

static void measure_subject(const struct subject *subject)
{
    static struct drawn drawn;
    struct outline_score score = {0};
    struct drawn_paths paths = {0};
    struct hatch_mesh mesh;
    memset(&drawn, 0, sizeof drawn);
    frame_arenas(&drawn.frame);
    if (!make(&drawn.frame, subject, &mesh)) {
        hatch_arena_free(&drawn.frame.args.keep);
        return;
    }
    drawn_normalize(&mesh);
    drawn_open(&mesh, &drawn);
    for (int i = 0; i < DRAWN_VIEWS; i++) {
        struct hatch_view view = drawn_view(i, (double)WIDTH / HEIGHT);
        struct hatch_image shown;
        struct hatch_arena_mark mark = hatch_arena_mark(&drawn.frame.args.keep);
        drawn_compare(&drawn, &view, WIDTH, HEIGHT, &shown, &score);
        drawn_count(&drawn, &paths);
        if (pictures && i % 4 == 0)
            keep_picture(&drawn, subject, i, &shown);
        hatch_arena_rewind(&drawn.frame.args.keep, mark);
    }
    printf("%s\t%u\t%.3f\t%.3f\t%.3f\t%.3f\t%.1f\t%.3f\n", subject->name, (unsigned)mesh.face_count,
           percent(score.outline_missed, score.outline), percent(score.steps_missed, score.steps),
           percent(score.outline_missed + score.steps_missed, score.outline + score.steps),
           percent(score.lines_off, score.lines), (double)paths.count / DRAWN_VIEWS,
           percent(paths.shorter, paths.count));
    fflush(stdout);
    drawn_close(&drawn);
}

START_TEST(measure)
{
    printf("mesh\tfaces\toutline_missed_percent\tsteps_missed_percent\tall_missed_percent\tlines_off_"
           "percent\tpaths\tshort_percent\n");
    for (size_t i = 0; i < sizeof subjects / sizeof *subjects; i++)
        if (!only || strcmp(only, subjects[i].name) == 0)
            measure_subject(&subjects[i]);
}
END_TEST

int main(int argc, char **argv)
{
    scans = argc > 1 ? argv[1] : NULL;
    pictures = argc > 2 ? argv[2] : NULL;
    only = argc > 3 ? argv[3] : NULL;
    return hatch_bench_main("bench outline", measure);
}
