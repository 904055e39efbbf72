#include "lapped/outline.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "base/random.h"

/* Number of Fourier coefficients of the radius. */
#define WAVES 8
/* Largest radius: the mask's border texels must stay 0 under filtering. */
#define REACH_MAX 0.48
/* Depth of the dents of the roughest outline, as a share of its radius. */
#define DENT_MAX 0.22
/* Number of directions per half turn at which the border is measured. */
#define SAMPLES 512

/* Returns the core's radius in a direction. It sums powers of a complex number of length 1, which, unlike sines of
 * multiples of the angle, have the same bits on every machine. */
static double wave_at(const struct hatch_outline *outline, double cosine, double sine)
{
    double sum = outline->wave[0][0], re = 1, im = 0;
    for (int k = 1; k < WAVES; k++) {
        double next = re * cosine - im * sine;
        im = re * sine + im * cosine;
        re = next;
        sum += outline->wave[k][0] * re + outline->wave[k][1] * im;
    }
    return sum;
}

/* Returns an upper bound of the derivative of the radius with respect to the angle. */
static double slope_of(const struct hatch_outline *outline)
{
    double slope = 0;
    for (int k = 1; k < WAVES; k++)
        slope += k * sqrt(outline->wave[k][0] * outline->wave[k][0] + outline->wave[k][1] * outline->wave[k][1]);
    return slope;
}

/* Computes bounds of the radius over all directions from samples and a bound of the change between two of them. */
static void measure(const struct hatch_outline *outline, double bounds[2])
{
    bounds[0] = HUGE_VAL;
    bounds[1] = -HUGE_VAL;
    for (int i = 0; i <= 2 * SAMPLES; i++) {
        double t = (double)(i % (SAMPLES + 1)) * 2 / SAMPLES - 1, side = i > SAMPLES ? -1 : 1;
        double cosine = side * (1 - t * t) / (1 + t * t), sine = side * 2 * t / (1 + t * t);
        double radius = wave_at(outline, cosine, sine);
        bounds[0] = fmin(bounds[0], radius);
        bounds[1] = fmax(bounds[1], radius);
    }
    double between = slope_of(outline) * 2 / SAMPLES;
    bounds[0] -= between;
    bounds[1] += between;
}

void hatch_outline_make(uint64_t seed, double roughness, double feather, struct hatch_outline *outline)
{
    assert(roughness >= 0 && roughness <= 1 && feather >= 0.01 && feather <= 0.3);
    *outline = (struct hatch_outline){.feather = feather};
    /* The first harmonic would only shift the blob. */
    for (uint64_t k = 2; k < WAVES; k++)
        for (uint64_t i = 0; i < 2; i++)
            outline->wave[k][i] = (2 * (double)hatch_random_unit(seed, k, i) - 1) / (double)k;
    double bounds[2];
    measure(outline, bounds);
    double core_max = REACH_MAX - feather;
    double dent = roughness * DENT_MAX * core_max / (bounds[1] - bounds[0]);
    for (int k = 2; k < WAVES; k++)
        for (int i = 0; i < 2; i++)
            outline->wave[k][i] *= dent;
    outline->wave[0][0] = core_max - dent * bounds[1];
    measure(outline, bounds);
    outline->core_min = bounds[0];
    outline->reach_max = bounds[1] + feather;
    /* The bound of the slope that hatch_outline_depth relies on. */
    double inner = outline->core_min - (bounds[1] - bounds[0]) / 2;
    double slope = slope_of(outline) / inner;
    outline->steep = sqrt(1 + slope * slope);
}

/* Returns the distance from the middle, and in *radius the core's radius in that direction. */
static double polar(const struct hatch_outline *outline, const double uv[2], double *radius)
{
    double x = uv[0] - 0.5, y = uv[1] - 0.5;
    double distance = sqrt(x * x + y * y);
    *radius = distance > 0 ? wave_at(outline, x / distance, y / distance) : outline->core_min;
    return distance;
}

double hatch_outline_opacity(const struct hatch_outline *outline, const double uv[2])
{
    double radius, distance = polar(outline, uv, &radius);
    return fmin(1, fmax(0, 1 - (distance - radius) / outline->feather));
}

/* Along a segment outside the circle of radius `inner`, the radial distance to the border changes by at most `steep`
 * per length. A segment from uv to the border that enters this circle is at least as long as the distance from uv to
 * the circle plus that from the circle to radius core_min. */
double hatch_outline_depth(const struct hatch_outline *outline, const double uv[2])
{
    double radius, distance = polar(outline, uv, &radius);
    double depth = radius - distance;
    if (depth <= 0)
        return depth;
    double spread = outline->reach_max - outline->feather - outline->core_min;
    double inner = outline->core_min - spread / 2;
    double through = fmax(0, distance - inner) + spread / 2;
    return fmax(outline->core_min - distance, fmin(depth / outline->steep, through));
}

double hatch_outline_distance(const struct hatch_outline *outline, const double uv[2])
{
    double x = uv[0] - 0.5, y = uv[1] - 0.5;
    double outside = sqrt(x * x + y * y) - outline->reach_max;
    if (outside >= outline->feather)
        return outside;
    double radius, distance = polar(outline, uv, &radius);
    double outside_ramp = distance - radius - outline->feather;
    return outside_ramp <= 0 ? outside_ramp : fmax(outside, outside_ramp / outline->steep);
}

uint32_t hatch_outline_levels(uint32_t side_px)
{
    return side_px < 512 ? 1 : side_px < 1024 ? 2 : 3;
}

/* Returns whether the core may reach into the square of half side `footprint` around uv. It is tested at 25 points; no
 * point of the square is further than 0.36 of the half side from one of them. */
static bool square_meets_core(const struct hatch_outline *outline, const double uv[2], double footprint)
{
    double depth = hatch_outline_depth(outline, uv);
    if (depth >= 0 || -depth > 1.5 * footprint * outline->steep)
        return depth >= 0;
    for (int i = 0; i < 25; i++) {
        double at[2] = {uv[0] + footprint * (i % 5 - 2) / 2, uv[1] + footprint * (i / 5 - 2) / 2};
        if (hatch_outline_depth(outline, at) >= -0.36 * footprint * outline->steep)
            return true;
    }
    return false;
}

static float texel(const struct hatch_outline *outline, double footprint, const double uv[2])
{
    double x = uv[0] - 0.5, y = uv[1] - 0.5, away = x * x + y * y;
    if (away >= outline->reach_max * outline->reach_max)
        return 0;
    if (away <= outline->core_min * outline->core_min || square_meets_core(outline, uv, footprint))
        return 1;
    double radius, distance = polar(outline, uv, &radius);
    double ramp_start = fmin(1.42 * footprint, outline->feather * 0.75);
    double ramp = 1 - (distance - radius - ramp_start) / (outline->feather - ramp_start);
    return (float)fmin(1, fmax(0, ramp));
}

enum hatch_status hatch_outline_raster(const struct hatch_outline *outline, uint32_t side_px, struct hatch_arena *arena,
                                       struct hatch_image *mask, struct hatch_err *err)
{
    assert(side_px >= HATCH_OUTLINE_PX_MIN);
    struct hatch_image made;
    HATCH_TRY(hatch_image_make(arena, side_px, side_px, "Y", &made, err));
    /* Half the side of the footprint of a bilinear lookup on the coarsest level. */
    double footprint = (0.5 + 1.5 * ldexp(1, (int)hatch_outline_levels(side_px) - 1)) / side_px;
    for (uint32_t y = 1; y + 1 < side_px; y++) {
        for (uint32_t x = 1; x + 1 < side_px; x++) {
            double uv[2] = {(x + 0.5) / side_px, (y + 0.5) / side_px};
            made.pixels[y * side_px + x] = texel(outline, footprint, uv);
        }
    }
    *mask = made;
    return HATCH_OK;
}
