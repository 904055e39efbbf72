/* bench_solid_contrast NAME=FILE.ktx2 ...: prints how much contrast the infinite zoom takes from solid textures and how
 * much each blend gives back. Of the texture's first value: its standard deviation; that of the blend relative to it,
 * as a mean over a zoom cycle; the share of the loss by the linear blend that is won back; and the distance of the
 * distributions, the mean difference of values of equal rank. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "io/texture/container.h"
#include "solid/zoom.h"

enum { POINTS = 1 << 15, LEVELS = 2 };

static struct hatch_arena keep, scratch;
static struct hatch_err err;
static float blended[POINTS], original[POINTS];

static void check(enum hatch_status status)
{
    if (status == HATCH_OK)
        return;
    fprintf(stderr, "bench_solid_contrast: %s\n", err.text);
    exit((int)status);
}

static struct hatch_solid read_solid(const char *path)
{
    struct hatch_buffer file = {.arena = &keep};
    struct hatch_texels texels;
    struct hatch_solid solid;
    FILE *from = fopen(path, "rb");
    char piece[1 << 16];
    for (size_t bytes; from && (bytes = fread(piece, 1, sizeof piece, from)) > 0;)
        check(hatch_buffer_add(&file, piece, bytes, &err));
    if (!from || fclose(from) != 0) {
        perror(path);
        exit(1);
    }
    check(hatch_ktx2_read((struct hatch_bytes){file.data, file.size}, &keep, &texels, &err));
    check(hatch_solid_take(&texels, &keep, &solid, &err));
    return solid;
}

/* Reads the table as shaders do, interpolated between values and steps of s. */
static double changed(const struct hatch_zoom_table *table, double s, double value)
{
    double x = fmin(fmax(value * HATCH_ZOOM_VALUES - 0.5, 0), HATCH_ZOOM_VALUES - 1), y = s * (HATCH_ZOOM_STEPS - 1);
    size_t column = (size_t)x, row = (size_t)y;
    size_t column_2 = column + (column + 1 < HATCH_ZOOM_VALUES), row_2 = row + (row + 1 < HATCH_ZOOM_STEPS);
    double along = x - (double)column, across = y - (double)row;
    uint16_t(*rows)[HATCH_ZOOM_VALUES] = table->entries[0];
    double low = rows[row][column] * (1 - along) + rows[row][column_2] * along;
    double high = rows[row_2][column] * (1 - along) + rows[row_2][column_2] * along;
    return (low * (1 - across) + high * across) / 65535;
}

static int by_value(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static void spread(const float *values, double *mean, double *deviation)
{
    double sum = 0, squares = 0;
    for (size_t i = 0; i < POINTS; i++) {
        sum += (double)values[i] / POINTS;
        squares += (double)values[i] * (double)values[i] / POINTS;
    }
    *mean = sum;
    *deviation = sqrt(fmax(squares - sum * sum, 0));
}

static void place_of(uint32_t i, float place[3])
{
    for (uint32_t k = 0; k < 3; k++)
        place[k] = 2 * hatch_random_unit(5, k, i);
}

struct figures {
    double deviation, drift, distance; /* relative deviation; largest change of the mean; of distributions */
};

static struct figures measure(const struct hatch_texels *mips, const struct hatch_zoom_table *table, uint32_t level,
                              double deviation)
{
    enum { STEPS = 12 };
    struct figures found = {0, 0, 0};
    double low = 1, high = 0;
    for (int step = 0; step < STEPS; step++) {
        double s = (step + 0.5) / STEPS, mean, now;
        for (uint32_t i = 0; i < POINTS; i++) {
            float place[3], value[3];
            place_of(i, place);
            hatch_zoom_blend_at(mips, HATCH_ZOOM_LINEAR, place, (float)s, (float)level, value);
            blended[i] = (float)changed(table, s, (double)value[0]);
        }
        spread(blended, &mean, &now);
        low = fmin(low, mean);
        high = fmax(high, mean);
        found.deviation += now / deviation / STEPS;
        qsort(blended, POINTS, sizeof *blended, by_value);
        for (size_t i = 0; i < POINTS; i++)
            found.distance += (double)fabsf(blended[i] - original[i]) / POINTS / STEPS;
    }
    found.drift = high - low;
    return found;
}

/* Fills `original` with values of the texture in their order; returns their deviation. */
static double measure_texture(const struct hatch_zoom *zoom)
{
    double mean, deviation;
    for (uint32_t i = 0; i < POINTS; i++) {
        size_t texel = (size_t)(hatch_random_unit(6, 0, i) * (float)hatch_solid_count(&zoom->base));
        original[i] = (float)zoom->base.texels[texel * zoom->base.channels] / 255;
    }
    spread(original, &mean, &deviation);
    qsort(original, POINTS, sizeof *original, by_value);
    return deviation;
}

static void print_exemplar(const char *name, const struct hatch_solid *solid)
{
    static const char *const blends[] = {"linear", "contrast", "histogram"};
    struct hatch_arena_mark mark = hatch_arena_mark(&keep);
    double linear[LEVELS];
    for (int blend = HATCH_ZOOM_LINEAR; blend <= HATCH_ZOOM_HISTOGRAM; blend++) {
        struct hatch_zoom zoom;
        struct hatch_texels mips;
        struct hatch_zoom_table table;
        check(hatch_zoom_make(solid, 2 * solid->size, false, HATCH_ZOOM_LINEAR, NULL, &keep, &scratch, &zoom, &err));
        check(hatch_zoom_mips(&zoom, (enum hatch_zoom_blend)blend, &keep, &mips, &err));
        check(hatch_zoom_table_make(&zoom, &mips, (enum hatch_zoom_blend)blend, -1, &keep, &scratch, &table, &err));
        double deviation = measure_texture(&zoom);
        for (uint32_t level = 0; level < LEVELS; level++) {
            struct figures found = measure(&mips, &table, level, deviation);
            linear[level] = blend == HATCH_ZOOM_LINEAR ? found.deviation : linear[level];
            printf("%s\t%s\t%u\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\n", name, blends[blend], level, deviation, found.deviation,
                   (found.deviation - linear[level]) / (1 - linear[level]), found.distance, found.drift);
        }
        hatch_arena_rewind(&keep, mark);
    }
}

int main(int argc, char **argv)
{
    hatch_arena_init(&keep, (size_t)4 << 30);
    hatch_arena_init(&scratch, (size_t)4 << 30);
    printf("texture\tblend\tlevel\tdeviation\trelative\twon_back\tdistance\tdrift\n");
    for (int i = 1; i < argc; i++) {
        char *path = strchr(argv[i], '=');
        *path++ = '\0';
        const struct hatch_solid solid = read_solid(path);
        print_exemplar(argv[i], &solid);
    }
    hatch_arena_free(&keep);
    hatch_arena_free(&scratch);
    return 0;
}
