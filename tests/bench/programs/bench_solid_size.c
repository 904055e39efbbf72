/* Measures a solid texture on a plane that faces the camera, from distances of 2^-20 to 2^20, and the same texture
 * fixed to the plane: the frequency of the largest power in the picture; over two octaves, the mean of the picture and
 * the mean change of a pixel between two of 64 frames per octave. */
#include <stdio.h>

#include "bench.h"
#include "solid/facing.h"

enum { TEXELS = 32, PERIODS = 6, PERIOD_PX = 64 };

static struct test_frame frame;
static struct hatch_mesh mesh;
static double values[2][FACING_SIZE * FACING_SIZE];
static const char *const names[] = {"linear", "contrast", "histogram"};

static void print_peak(const char *name, double octave)
{
    double power[SPECTRUM_SIZE / 2];
    spectrum_of(values[0], power);
    printf("frequency\t%s\t%.4g\t%.3f\tperiods per %d px\n", name, octave, spectrum_peak(power), FACING_SIZE);
}

static void measure_frequencies(const char *name)
{
    for (double octave = -20; octave <= 20; octave += 0.25) {
        facing_draw(&frame, 0, 20 - octave, values[0]);
        print_peak(name, octave);
    }
}

/* The texture of which one period covers PERIOD_PX pixels at distance 1, with the mip level whose texels are nearest to
 * a pixel. */
static void measure_fixed(const struct hatch_solid *solid)
{
    struct hatch_texels mips;
    HATCH_TEST_OK(hatch_solid_mips(solid, &frame.args.keep, &mips, &frame.err), &frame.err);
    for (double octave = -2.5; octave <= 2; octave += 0.25) {
        double step = exp2(octave) / PERIOD_PX;
        uint32_t level = (uint32_t)fmax(round(log2(step * TEXELS)), 0);
        for (int i = 0; i < FACING_SIZE * FACING_SIZE; i++) {
            float value[3], place[3] = {(float)(step * (i % FACING_SIZE)), (float)(step * (i / FACING_SIZE)), 0.3f};
            hatch_zoom_sample(&mips, (float)level, place, value);
            values[0][i] = (double)value[0];
        }
        print_peak("fixed", octave);
    }
}

/* Each of the 32 pictures shows another plane of the texture: their distances differ by octaves. */
static void measure_mean(const char *name, const char *kind, const struct hatch_solid *solid,
                         enum hatch_zoom_blend blend, double period_px)
{
    enum { PLACES = 32 };
    solid_use(&frame, solid, blend, period_px);
    for (int step = 0; step <= 16; step += 2) {
        double mean = 0;
        for (int place = 0; place < PLACES; place++) {
            facing_draw(&frame, place, 3 + place - step / 16.0, values[0]);
            mean += facing_mean(values[0]) / PLACES;
        }
        printf("mean\t%s, %s, %g px\t%.4g\t%.6f\t1\n", name, kind, period_px, step / 16.0, mean);
    }
}

static void measure_changes(const char *name)
{
    facing_draw(&frame, 0, 20, values[0]);
    for (int t = 0; t < 128; t++) {
        facing_draw(&frame, 0, 20 - (t + 1) / 64.0, values[(t + 1) % 2]);
        printf("change\t%s\t%.6g\t%.6f\t1\n", name, t / 64.0, facing_change(values[0], values[1]));
    }
}

/* Most values light, few dark: clamping moves the mean of such a texture. */
static void skew(struct hatch_solid *solid)
{
    for (size_t i = 0; i < (size_t)TEXELS * TEXELS * TEXELS; i++) {
        float light = (float)solid->texels[i] / 255;
        solid->texels[i] = hatch_unorm8(1 - (1 - light) * (1 - light) * (1 - light));
    }
}

START_TEST(measure)
{
    facing_open(&frame, &mesh);
    struct hatch_solid even = solid_of_waves(&frame.args.keep, TEXELS, PERIODS);
    struct hatch_solid skewed = solid_of_waves(&frame.args.keep, TEXELS, PERIODS);
    skew(&skewed);
    printf("figure\tblend\toctave\tvalue\tunit\n");
    for (int blend = HATCH_ZOOM_LINEAR; blend <= HATCH_ZOOM_HISTOGRAM; blend++) {
        solid_use(&frame, &even, (enum hatch_zoom_blend)blend, PERIOD_PX);
        measure_frequencies(names[blend]);
        measure_changes(names[blend]);
        measure_mean(names[blend], "even", &even, (enum hatch_zoom_blend)blend, 24);
        measure_mean(names[blend], "skewed", &skewed, (enum hatch_zoom_blend)blend, 24);
        measure_mean(names[blend], "skewed", &skewed, (enum hatch_zoom_blend)blend, PERIOD_PX);
    }
    measure_fixed(&even);
    frame_finish(&frame);
}
END_TEST

HATCH_BENCH_MAIN("solid_size", measure)
