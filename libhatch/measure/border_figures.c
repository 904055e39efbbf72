#include "measure/border_figures.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

#include "measure/ink_figures.h"

#define INK_MIN 0.5f      /* darkness of ink */
#define SAME_MOST 0.0004f /* difference of grey between pixels of one patch */
#define NO_PATCH (-1.0f)
#define REACH HATCH_BORDER_REACH_PX
#define SIDE (2 * REACH + 1)

struct borders {
    int width, height;
    const float *dark;
    const float *greys; /* of the patches; NO_PATCH: none */
};

/* A border between patches, moved. */
struct shift {
    int x, y;
};

/* Replaces darkness by grey, and that of pixels without a patch by NO_PATCH. */
static void find_greys(const struct hatch_image *patches, float *dark)
{
    const uint32_t channels = patches->channel_count;
    for (size_t i = 0; i < (size_t)patches->width * patches->height; i++) {
        bool clear = channels % 2 == 0 && patches->pixels[i * channels + channels - 1] < 0.5f;
        dark[i] = clear || dark[i] <= SAME_MOST ? NO_PATCH : 1 - dark[i];
    }
}

static bool is_ink(const struct borders *borders, int x, int y)
{
    return x >= 0 && y >= 0 && x < borders->width && y < borders->height &&
           borders->dark[(size_t)y * (size_t)borders->width + (size_t)x] >= INK_MIN;
}

static float grey_at(const struct borders *borders, int x, int y)
{
    if (x < 0 || y < 0 || x >= borders->width || y >= borders->height)
        return NO_PATCH;
    return borders->greys[(size_t)y * (size_t)borders->width + (size_t)x];
}

/* Patches of a square of pixels. */
enum square { SQUARE_ONE, SQUARE_SEVERAL, SQUARE_OUTSIDE /* it has pixels without a patch */ };

static enum square square_around(const struct borders *borders, int x, int y, int reach_px)
{
    const float own = grey_at(borders, x, y);
    enum square found = SQUARE_ONE;
    for (int row = y - reach_px; row <= y + reach_px; row++)
        for (int column = x - reach_px; column <= x + reach_px; column++) {
            float grey = grey_at(borders, column, row);
            if (grey < 0)
                return SQUARE_OUTSIDE;
            if (fabsf(grey - own) > SAME_MOST)
                found = SQUARE_SEVERAL;
        }
    return found;
}

/* Gives pixels between patches, which have a mixture of their greys, the grey of the nearest pixel that has none. */
static enum hatch_status sharpen(struct borders *borders, struct hatch_arena *scratch, struct hatch_err *err)
{
    const int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const size_t width = (size_t)borders->width, count = width * (size_t)borders->height;
    size_t *queue, first = 0, end = 0;
    float *sharp;
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &queue, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &sharp, count, err));
    for (size_t i = 0; i < count; i++) {
        bool pure = square_around(borders, (int)(i % width), (int)(i / width), 1) == SQUARE_ONE;
        sharp[i] = pure ? borders->greys[i] : NO_PATCH;
        if (pure)
            queue[end++] = i;
    }
    for (; first < end; first++)
        for (int k = 0; k < 4; k++) {
            int x = (int)(queue[first] % width) + steps[k][0], y = (int)(queue[first] / width) + steps[k][1];
            size_t next = (size_t)y * width + (size_t)x;
            if (grey_at(borders, x, y) < 0 || sharp[next] >= 0)
                continue;
            sharp[next] = sharp[queue[first]];
            queue[end++] = next;
        }
    borders->greys = sharp;
    return HATCH_OK;
}

/* Returns whether no pixel near a pixel is of the patch with a grey. */
static bool is_clear_of(const struct borders *borders, int x, int y, float grey)
{
    for (int row = y - HATCH_BORDER_NEAR_PX; row <= y + HATCH_BORDER_NEAR_PX; row++)
        for (int column = x - HATCH_BORDER_NEAR_PX; column <= x + HATCH_BORDER_NEAR_PX; column++)
            if (fabsf(grey_at(borders, column, row) - grey) <= SAME_MOST)
                return false;
    return true;
}

/* Returns whether the ink of a pixel is connected to ink that is not near its patch. */
static bool goes_on(const struct borders *borders, int x, int y, struct shift shift)
{
    const float own = grey_at(borders, x + shift.x, y + shift.y);
    bool seen[SIDE * SIDE] = {false};
    int stack[SIDE * SIDE], waiting = 0;
    stack[waiting++] = REACH * SIDE + REACH;
    seen[REACH * SIDE + REACH] = true;
    while (waiting) {
        int at = stack[--waiting], column = at % SIDE, row = at / SIDE;
        const int to_x = x + column - REACH + shift.x, to_y = y + row - REACH + shift.y;
        if (is_clear_of(borders, to_x, to_y, own))
            return true;
        for (int k = 0; k < 9; k++) {
            int c = column + k % 3 - 1, r = row + k / 3 - 1;
            if (c < 0 || r < 0 || c >= SIDE || r >= SIDE || seen[r * SIDE + c] ||
                !is_ink(borders, x + c - REACH, y + r - REACH))
                continue;
            seen[r * SIDE + c] = true;
            stack[waiting++] = r * SIDE + c;
        }
    }
    return false;
}

/* Adds the ink near the moved borders, and that which goes on.
 *   sums  in, out: of all, of that which goes on */
static void add_ink(const struct borders *borders, struct shift shift, uint64_t sums[2])
{
    const bool moved = shift.x != 0 || shift.y != 0;
    for (int y = 0; y < borders->height; y++)
        for (int x = 0; x < borders->width; x++) {
            if (!is_ink(borders, x, y) ||
                square_around(borders, x + shift.x, y + shift.y, HATCH_BORDER_NEAR_PX) != SQUARE_SEVERAL ||
                square_around(borders, x + shift.x, y + shift.y, REACH) == SQUARE_OUTSIDE ||
                (moved && square_around(borders, x, y, REACH) != SQUARE_ONE))
                continue;
            sums[0]++;
            sums[1] += goes_on(borders, x, y, shift);
        }
}

static double share_of(const uint64_t sums[2])
{
    return sums[0] ? (double)sums[1] / (double)sums[0] : NAN;
}

/* Does the work of hatch_measure_borders, but leaves memory in the scratch arena. */
static enum hatch_status measure(const struct hatch_image *picture, const struct hatch_image *patches,
                                 struct hatch_arena *scratch, struct hatch_border_figures *figures,
                                 struct hatch_err *err)
{
    static const struct shift shifts[] = {{HATCH_BORDER_SHIFT_PX, 0},
                                          {-HATCH_BORDER_SHIFT_PX, 0},
                                          {0, HATCH_BORDER_SHIFT_PX},
                                          {0, -HATCH_BORDER_SHIFT_PX}};
    uint64_t at[2] = {0}, moved[2] = {0};
    const float *dark = hatch_ink_darkness(picture, scratch, err);
    float *greys = dark ? hatch_ink_darkness(patches, scratch, err) : NULL;
    struct borders borders = {(int)picture->width, (int)picture->height, dark, greys};
    if (!greys)
        return HATCH_LIMIT;
    find_greys(patches, greys);
    HATCH_TRY(sharpen(&borders, scratch, err));
    add_ink(&borders, (struct shift){0, 0}, at);
    for (size_t i = 0; i < sizeof shifts / sizeof *shifts; i++)
        add_ink(&borders, shifts[i], moved);
    *figures = (struct hatch_border_figures){share_of(at), share_of(moved), share_of(at) / share_of(moved)};
    return HATCH_OK;
}

enum hatch_status hatch_measure_borders(const struct hatch_image *picture, const struct hatch_image *patches,
                                        struct hatch_arena *scratch, struct hatch_border_figures *figures,
                                        struct hatch_err *err)
{
    assert(patches->width == picture->width && patches->height == picture->height);
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = measure(picture, patches, scratch, figures, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
