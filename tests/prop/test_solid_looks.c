/* Looks of solid textures: pictures whose colours are known. */
#include "run.h"

#include "solid/solids.h"

enum { WIDTH = 640, HEIGHT = 400, SMALL = 60 };

static struct test_frame frame;
static struct hatch_mesh mesh;
static struct hatch_solid solid;
static const struct hatch_bounds teapot_bounds = {.center = {0.2, 1.5, 0}, .radius = 3.5};

static void begin(void)
{
    frame_arenas(&frame);
    mesh = frame_shape(&frame, HATCH_SHAPE_TEAPOT, 6000);
    frame_open(&mesh, &teapot_bounds, NULL, &frame);
    frame.shown.style.light = (struct hatch_key_light){.azimuth_rad = -0.7, .elevation_rad = 0.7};
    solid = solid_of_waves(&frame.args.keep, 32, 6);
}

static void end(void)
{
    frame_finish(&frame);
}

/* Counts regions of white pixels of at most SMALL pixels that touch by their sides. */
static int count_specks(const struct hatch_image *image)
{
    static int region[WIDTH * HEIGHT], queue[WIDTH * HEIGHT];
    int specks = 0, regions = 0;
    memset(region, 0, sizeof region);
    for (int start = 0; start < WIDTH * HEIGHT; start++) {
        int done = 0, found = 0;
        if (region[start] || image->pixels[3 * start] < 0.97f)
            continue;
        region[queue[found++] = start] = ++regions;
        for (; done < found; done++) {
            const int x = queue[done] % WIDTH, y = queue[done] / WIDTH;
            const int near[4][2] = {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
            for (int k = 0; k < 4; k++) {
                int at = near[k][1] * WIDTH + near[k][0];
                if (near[k][0] < 0 || near[k][0] >= WIDTH || near[k][1] < 0 || near[k][1] >= HEIGHT || region[at] ||
                    image->pixels[3 * at] < 0.97f)
                    continue;
                region[queue[found++] = at] = regions;
            }
        }
        specks += found <= SMALL;
    }
    return specks;
}

/* The papers are darker than the borders, so that white is a border or the background. */
START_TEST(borders_of_strips_leave_no_specks)
{
    static const double distances[] = {1, 2, 4};
    struct hatch_image image;
    begin();
    solid_use_look(&frame, &solid, 64, SOLID_COLLAGE);
    solid_options.grain = 0;
    for (int i = 0; i < 3; i++) {
        struct hatch_view view = frame_view(&frame, (double)WIDTH / HEIGHT);
        for (int k = 0; k < 3; k++)
            view.eye[k] *= distances[i];
        frame_draw(&frame, "solid", &view, WIDTH, HEIGHT, 2, &image);
        ck_assert_msg(count_specks(&image) == 0, "at %g: %d specks", distances[i], count_specks(&image));
    }
    end();
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("looks");
    TCase *tests = tcase_create("looks");
    tcase_add_test(tests, borders_of_strips_leave_no_specks);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
