#include "tam_made.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "fail_alloc.h"
#include "stroke/footprint.h"
#include "stroke/path.h"
#include "cover/cover.h"
#include "cover/strokes.h"

static struct test_map map;
static struct hatch_cover cover;

/* Makes a map and the lists of its texels.
 *   length  of all strokes, in tiles; 0: those of the style */
static void make_of(const char *style, uint32_t size_px, float length)
{
    map_style(style, NULL, &map);
    if (length > 0) {
        map.style.length_min = map.style.length_max = length;
        for (uint32_t i = 0; i < map.style.direction_count; i++)
            map.style.directions[i].angle_rad += 0.3f; /* else they lie on themselves */
    }
    map.options.ids = true;
    map.options.size_px = size_px;
    map_fill(&map);
    HATCH_TEST_OK(hatch_cover_make(&map.tam, &map.strokes, &map_arena, &map_scratch, &cover, &map_err), &map_err);
    ck_assert_uint_eq(cover.levels, map.options.levels);
}

static void make(const char *style, uint32_t size_px)
{
    make_of(style, size_px, 0);
}

/* A mark of a level and what it says. */
struct found {
    const struct hatch_stroke *stroke; /* as it was drawn */
    uint32_t column, layer;
    float t, share;
    float away; /* distance of the texel from the stroke's place at t, in texels */
};

/* Reads the mark, on the way from the texel to the tile of the stroke's middle. */
static struct found read_mark(uint32_t level, uint32_t texel, const struct hatch_cover_mark *mark)
{
    uint32_t id = mark->id & ((1u << HATCH_COVER_MARK_LAYER_SHIFT) - 1), bits = mark->bits;
    uint32_t size = hatch_mip_size(map.tam.size_px, level);
    ck_assert_uint_ge(id, 1);
    ck_assert_uint_le(id, map.strokes.count);
    struct found found = {.stroke = &map.strokes.items[id - 1],
                          .column = bits >> HATCH_COVER_MARK_COLUMN_SHIFT & 255,
                          .layer = mark->id >> HATCH_COVER_MARK_LAYER_SHIFT & 63,
                          .t = (float)(bits & 4095) / 4095,
                          .share = (float)(bits >> HATCH_COVER_MARK_COVER_SHIFT & 255) / 255};
    const uint32_t from = hatch_cover_mark_tile(mark);
    const float tile[2] = {(float)(from & 7) - HATCH_COVER_TILES, (float)(from >> 3) - HATCH_COVER_TILES};
    float along = (found.t - 0.5f) * found.stroke->length;
    float x = ((float)(texel % size) + 0.5f) / (float)size - (found.stroke->x + tile[0]);
    float y = ((float)(texel / size) + 0.5f) / (float)size - (found.stroke->y + tile[1]);
    x -= along * cosf(found.stroke->angle_rad);
    y -= along * sinf(found.stroke->angle_rad);
    /* A stroke whose middle is at the border may count as one of the neighbouring tile. */
    x -= rintf(x * (fabsf(found.stroke->x - 0.5f) > 0.45f));
    y -= rintf(y * (fabsf(found.stroke->y - 0.5f) > 0.45f));
    found.away = hypotf(x, y) * (float)size;
    return found;
}

START_TEST(marks_lie_on_their_strokes)
{
    uint32_t off = 0, wrapped = 0;
    make("ink", 128);
    for (uint32_t level = 0; level < cover.levels; level++) {
        uint32_t size = hatch_mip_size(map.tam.size_px, level);
        for (uint32_t texel = 0; texel < size * size; texel++)
            for (uint32_t i = cover.ends[cover.first[level] + texel]; i < cover.ends[cover.first[level] + texel + 1];
                 i++) {
                struct found found = read_mark(level, texel, &cover.marks[i]);
                off += found.away > 3;
                wrapped += hatch_cover_mark_tile(&cover.marks[i]) != (HATCH_COVER_TILES | HATCH_COVER_TILES << 3);
                ck_assert_uint_eq(found.layer, found.stroke->column);
                ck_assert_uint_ge(found.column, found.stroke->column);
            }
    }
    ck_assert_uint_lt(100 * off, cover.mark_count);
    ck_assert_uint_gt(10 * wrapped, cover.mark_count); /* strokes do cross the border of the tile */
}
END_TEST

/* Strokes of several tiles are listed up to both ends, which taper. */
START_TEST(long_strokes_are_whole)
{
    uint32_t outer = 0;
    make_of("ink", 64, 4);
    const uint32_t count = cover.ends[cover.first[0] + map.tam.size_px * map.tam.size_px] - cover.ends[cover.first[0]];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t bits = cover.marks[cover.ends[cover.first[0]] + i].bits;
        outer += fabsf((float)(bits & 4095) / 4095 - 0.5f) > 0.375f;
    }
    ck_assert_msg(7 * outer > count, "%u of %u marks are in the outer quarter", outer, count);
}
END_TEST

/* Where strokes lie below others, the texels do not name them, but the marks do. */
START_TEST(strokes_have_all_their_ink)
{
    struct hatch_footprint footprint;
    double drawn = 0, named = 0, marked = 0;
    make("ink", 128);
    HATCH_TEST_OK(hatch_footprint_make(&map_arena, map.tam.size_px, map.style.length_max, map.style.width_px,
                                       &footprint, &map_err),
                  &map_err);
    for (uint32_t i = 0; i < map.strokes.count; i++) {
        hatch_footprint_draw(&map.strokes.items[i], &map.brush, map.tam.size_px, 1, 1, &footprint);
        for (uint32_t k = 0; k < footprint.count; k++)
            drawn += (double)footprint.alpha[k];
    }
    for (uint32_t texel = 0; texel < map.tam.size_px * map.tam.size_px; texel++) {
        const uint32_t *ends = &cover.ends[cover.first[0] + texel];
        named += 1 - (double)map.tam.columns[map.tam.tones - 1].levels[0].pixels[3 * (size_t)texel];
        for (uint32_t i = ends[0]; i < ends[1]; i++)
            marked += (double)(read_mark(0, texel, &cover.marks[i]).share * cover.ink);
    }
    ck_assert_double_lt(named, 0.8 * drawn); /* the rest is below other strokes */
    ck_assert_double_gt(marked, 0.93 * drawn);
    ck_assert_double_lt(marked, 1.07 * drawn);
    ck_assert_float_gt(cover.ink, 0.9f);
    ck_assert_float_gt(cover.width_px, 0.8f * map.style.width_px);
    ck_assert_float_lt(cover.width_px, 1.2f * map.style.width_px);
}
END_TEST

/* Returns the number of strokes that have marks on a level.
 *   seen  out: per id */
static uint32_t count_marked(uint32_t level, bool *seen)
{
    const uint32_t size = hatch_mip_size(map.tam.size_px, level), *ends = &cover.ends[cover.first[level]];
    uint32_t count = 0;
    memset(seen, 0, (map.strokes.count + 1) * sizeof *seen);
    for (uint32_t i = ends[0]; i < ends[size * size]; i++) {
        uint32_t id = cover.marks[i].id & ((1u << HATCH_COVER_MARK_LAYER_SHIFT) - 1);
        count += !seen[id];
        seen[id] = true;
    }
    return count;
}

/* The list tells about strokes that no texel names, on each level that has them. */
START_TEST(strokes_below_others_are_known_from_the_list)
{
    static bool seen[1 << 16];
    const struct hatch_stroke_list none = {.count = 0};
    struct hatch_cover listed;
    uint32_t on[2] = {0, 0};
    make("pencil", 128);
    ck_assert_uint_lt(map.strokes.count, sizeof seen);
    for (uint32_t i = 0; i < map.strokes.count; i++)
        for (uint32_t level = 0; level < 2; level++)
            on[level] += map.strokes.items[i].level >= level;
    for (uint32_t level = 0; level < 2; level++)
        ck_assert_uint_ge(count_marked(level, seen) * 100, on[level] * 99);
    for (uint32_t texel = 0; texel < map.tam.size_px * map.tam.size_px; texel++)
        for (uint32_t i = cover.ends[cover.first[0] + texel]; i < cover.ends[cover.first[0] + texel + 1]; i++)
            ck_assert_uint_ge(read_mark(0, texel, &cover.marks[i]).column, read_mark(0, texel, &cover.marks[i]).layer);
    listed = cover;
    HATCH_TEST_OK(hatch_cover_make(&map.tam, &none, &map_arena, &map_scratch, &cover, &map_err), &map_err);
    ck_assert_uint_lt(count_marked(0, seen) * 100, on[0] * 90);
    ck_assert_uint_gt(listed.mark_count, cover.mark_count);
}
END_TEST

/* A list from a file may say anything. */
START_TEST(lists_of_other_strokes_do_no_harm)
{
    struct hatch_stroke strokes[] = {{.id = 0},
                                     {.id = 1 << 24},
                                     {.id = 7, .column = 255},
                                     {.id = 1, .level = 31},
                                     {.id = 7, .length = 1e9f},
                                     {.id = 9, .width_px = 1, .length = 15, .level = 2}};
    const struct hatch_stroke_list list = {strokes, sizeof strokes / sizeof *strokes, 0};
    make("ink", 64);
    HATCH_TEST_OK(hatch_cover_make(&map.tam, &list, &map_arena, &map_scratch, &cover, &map_err), &map_err);
    strokes[5].id = 16 * 4097;
    ck_assert_int_eq(hatch_cover_make(&map.tam, &list, &map_arena, &map_scratch, &cover, &map_err), HATCH_BAD_INPUT);
}
END_TEST

/* A straight stroke and an arc, by bend: both are as long as the list says, whose unit is a tile, and pass through the
 * places of hatch_stroke_place, up to whole tiles. */
START_TEST(listed_strokes_have_their_length_and_place)
{
    struct hatch_stroke listed[] = {{.id = 3, .length = 0.5f, .x = 0.9f, .y = 0.2f, .angle_rad = 0.3f, .column = 4},
                                    {.id = 5, .length = 0.75f, .x = 0.1f, .y = 0.6f, .angle_rad = 2, .bend_rad = 0.4f},
                                    {.id = 2, .length = 0.25f, .x = 0.5f, .y = 0.5f}};
    const struct hatch_stroke_list list = {listed, 3, 0};
    struct hatch_cover_stroke strokes[6] = {[2] = {.is_there = true, .length = 7}};
    hatch_cover_add_listed(&list, 128, 5, strokes);
    for (int i = 0; i < 2; i++) {
        const struct hatch_cover_stroke *stroke = &strokes[listed[i].id];
        ck_assert(stroke->is_there && stroke->original == &listed[i] && stroke->column == listed[i].column);
        ck_assert_float_eq_tol(stroke->length, 128 * listed[i].length, 0.1f);
        for (int k = 0; k <= 4; k++) {
            float place[2], want[2];
            hatch_cover_stroke_at(stroke, (float)k / 4, place);
            hatch_stroke_place(&listed[i], (float)k / 4, want);
            for (int axis = 0; axis < 2; axis++) {
                float tiles = (place[axis] - 128 * want[axis]) / 128;
                ck_assert_float_eq_tol(tiles, rintf(tiles), 1e-3f);
                ck_assert(k != 2 || (place[axis] >= 0 && place[axis] < 128));
            }
        }
    }
    ck_assert(strokes[2].original == &listed[2] && strokes[2].length == 7); /* its curve is of the texels */
    ck_assert(!strokes[1].is_there && !strokes[4].is_there);
}
END_TEST

START_TEST(refuses_ids_without_texels)
{
    make("ink", 64);
    struct hatch_cover before = cover;
    map.tam.columns[0].levels[0].pixels[1] = 1e6f;
    ck_assert_int_eq(hatch_cover_make(&map.tam, &map.strokes, &map_arena, &map_scratch, &cover, &map_err),
                     HATCH_BAD_INPUT);
    ck_assert_str_eq(map_err.text, "id 1000000, but the finest level has only 4096 texels");
    ck_assert_mem_eq(&before, &cover, sizeof cover);
}
END_TEST

/* There are sixteen strokes for each of 4096 texels, and one more takes a seventeenth. */
START_TEST(as_many_ids_are_allowed_as_there_may_be_strokes)
{
    make("ink", 64);
    map.tam.columns[0].levels[0].pixels[1] = 16 * 4097 - 1;
    HATCH_TEST_OK(hatch_cover_make(&map.tam, &map.strokes, &map_arena, &map_scratch, &cover, &map_err), &map_err);
    map.tam.columns[0].levels[0].pixels[1] = 16 * 4097;
    ck_assert_int_eq(hatch_cover_make(&map.tam, &map.strokes, &map_arena, &map_scratch, &cover, &map_err),
                     HATCH_BAD_INPUT);
}
END_TEST

static enum hatch_status make_again(void *context, struct hatch_arena *keep, struct hatch_arena *scratch,
                                    struct hatch_err *err)
{
    (void)context;
    return hatch_cover_make(&map.tam, &map.strokes, keep, scratch, &cover, err);
}

START_TEST(survives_failed_allocations)
{
    make("pencil", 64);
    hatch_test_fail_alloc(make_again, NULL, &cover, sizeof cover);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("cover");
    TCase *tests = tcase_create("cover");
    tcase_add_unchecked_fixture(tests, map_begin, map_end);
    tcase_add_test(tests, marks_lie_on_their_strokes);
    tcase_add_test(tests, long_strokes_are_whole);
    tcase_add_test(tests, strokes_have_all_their_ink);
    tcase_add_test(tests, as_many_ids_are_allowed_as_there_may_be_strokes);
    tcase_add_test(tests, strokes_below_others_are_known_from_the_list);
    tcase_add_test(tests, lists_of_other_strokes_do_no_harm);
    tcase_add_test(tests, listed_strokes_have_their_length_and_place);
    tcase_add_test(tests, refuses_ids_without_texels);
    tcase_add_test(tests, survives_failed_allocations);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
