#include "arenas.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "base/random.h"
#include "fail_alloc.h"
#include "io/exr/exr.h"

#define LIMIT ((size_t)1 << 30)
#define PARTS 5u

struct kind {
    uint32_t width, height;
    bool mips;
    const char *names;
    bool ids; /* channels id and t follow */
};

static const struct kind kinds[] = {
    {64, 64, true, "Y", false},   {1, 1, false, "Y", false},    {1, 1, true, "Y", false},
    {256, 256, true, "Y", true},  {257, 257, true, "Y", false}, {300, 77, true, "RGB", false},
    {700, 531, true, "Y", true},  {5, 1000, true, "Y", false},  {1000, 3, false, "RGBA", false},
    {33, 17, false, "RGB", true}, {513, 40, false, "Y", false}, {600, 600, true, "RGB", true},
};

static float texel(const struct hatch_channel *channel, uint64_t stream, uint64_t i)
{
    uint64_t bits = hatch_random_u64(9, stream, i);
    if (channel->type == HATCH_UINT)
        return (float)(bits % 16777217u);
    if (channel->type == HATCH_FLOAT)
        return (float)((double)bits * 0x1p-64);
    if (i % 50 < 30)
        return 1; /* constant, so that compression shrinks some chunks and not others */
    uint16_t half = (uint16_t)bits;
    return (half & 0x7c00) == 0x7c00 ? 0 : hatch_float_from_half(half);
}

static void make_part(const struct kind *kind, uint32_t part, struct hatch_mipmap *mipmap)
{
    memset(mipmap, 0, sizeof *mipmap);
    mipmap->level_count = kind->mips ? hatch_mip_chain_length(kind->width, kind->height) : 1;
    mipmap->levels = HATCH_NEW(&keep, struct hatch_image, mipmap->level_count, &err);
    char names[8] = {0};
    strcat(names, kind->names);
    strcat(names, kind->ids ? "it" : "");
    for (uint32_t l = 0; l < mipmap->level_count; l++) {
        struct hatch_image *level = &mipmap->levels[l];
        HATCH_TEST_OK(hatch_image_make(&keep, hatch_mip_size(kind->width, l), hatch_mip_size(kind->height, l), names,
                                       level, &err),
                      &err);
        if (kind->ids) {
            level->channels[level->channel_count - 2] = (struct hatch_channel){"id", HATCH_UINT};
            level->channels[level->channel_count - 1] = (struct hatch_channel){"t", HATCH_FLOAT};
        }
        size_t count = (size_t)level->width * level->height * level->channel_count;
        for (size_t i = 0; i < count; i++)
            level->pixels[i] = texel(&level->channels[i % level->channel_count], part * 40 + l, i);
    }
    snprintf(mipmap->name, sizeof mipmap->name, "tone.%03u", part);
    hatch_mipmap_set_number(mipmap, "hatch:tone", (double)((float)part / 7), HATCH_ATTRIBUTE_FLOAT);
    hatch_mipmap_set_number(mipmap, "hatch:levels", part + 1, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_text(mipmap, "hatch:seed", "18446744073709551615");
}

struct adding {
    struct hatch_exr_writer *writer;
    struct hatch_mipmap *parts;
    enum hatch_status status[PARTS];
};

static void add_one(void *context, uint32_t part)
{
    struct adding *adding = context;
    adding->status[part] = hatch_exr_add_part(adding->writer, part, &adding->parts[part], NULL);
}

static struct hatch_buffer write_all(struct hatch_mipmap *parts, uint32_t count, uint32_t threads)
{
    struct hatch_buffer file = {.arena = &keep};
    struct adding adding = {.parts = parts};
    struct hatch_pool *pool = NULL;
    HATCH_TEST_OK(hatch_pool_make(threads, &keep, &pool, &err), &err);
    HATCH_TEST_OK(hatch_exr_begin(&parts[0], count, &keep, &adding.writer, &err), &err);
    hatch_parallel_for(pool, count, add_one, &adding);
    hatch_pool_free(pool);
    for (uint32_t i = 0; i < count; i++)
        ck_assert_int_eq(adding.status[i], HATCH_OK);
    HATCH_TEST_OK(hatch_exr_end(adding.writer, &file, &err), &err);
    return file;
}

static void same_part(const struct hatch_mipmap *got, const struct hatch_mipmap *want)
{
    ck_assert_str_eq(got->name, want->name);
    ck_assert_uint_eq(got->level_count, want->level_count);
    ck_assert_uint_eq(got->attribute_count, want->attribute_count);
    for (uint32_t i = 0; i < want->attribute_count; i++) {
        const struct hatch_attribute *a = hatch_mipmap_attribute(got, want->attributes[i].name);
        ck_assert_ptr_nonnull(a);
        ck_assert_int_eq(a->type, want->attributes[i].type);
        if (a->type == HATCH_ATTRIBUTE_TEXT)
            ck_assert_str_eq(a->text, want->attributes[i].text);
        else
            ck_assert_double_eq(a->number, want->attributes[i].number);
    }
    for (uint32_t l = 0; l < want->level_count; l++) {
        const struct hatch_image *a = &got->levels[l], *b = &want->levels[l];
        ck_assert_uint_eq(a->width, b->width);
        ck_assert_uint_eq(a->height, b->height);
        ck_assert_uint_eq(a->channel_count, b->channel_count);
        for (uint32_t c = 0; c < b->channel_count; c++) {
            ck_assert_str_eq(a->channels[c].name, b->channels[c].name);
            ck_assert_int_eq(a->channels[c].type, b->channels[c].type);
        }
        size_t bytes = (size_t)b->width * b->height * b->channel_count * sizeof(float);
        ck_assert_msg(memcmp(a->pixels, b->pixels, bytes) == 0, "level %u differs", l);
    }
}

START_TEST(files_survive_a_round_trip)
{
    const struct kind *kind = &kinds[_i];
    struct hatch_mipmap parts[PARTS], *got = NULL;
    uint32_t count = _i % 2 ? 1 : PARTS, got_count = 0;
    for (uint32_t i = 0; i < count; i++)
        make_part(kind, i, &parts[i]);
    struct hatch_buffer file = write_all(parts, count, 1);
    HATCH_TEST_OK(
        hatch_exr_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &got, &got_count, &err),
        &err);
    ck_assert_uint_eq(got_count, count);
    for (uint32_t i = 0; i < count; i++)
        same_part(&got[i], &parts[i]);
}
END_TEST

START_TEST(writing_does_not_depend_on_threads)
{
    struct hatch_mipmap parts[PARTS];
    for (uint32_t i = 0; i < PARTS; i++)
        make_part(&kinds[5], i, &parts[i]);
    struct hatch_buffer one = write_all(parts, PARTS, 1), four = write_all(parts, PARTS, 4);
    ck_assert_uint_eq(one.size, four.size);
    ck_assert(memcmp(one.data, four.data, one.size) == 0);
}
END_TEST

/* Neither pixels nor the message for a damaged file, which names its first damaged part. */
START_TEST(reading_does_not_depend_on_threads)
{
    struct hatch_mipmap parts[PARTS], *got[2] = {NULL, NULL};
    struct hatch_pool *pool;
    struct hatch_err errs[2];
    uint32_t count = 0;
    for (uint32_t i = 0; i < PARTS; i++)
        make_part(&kinds[0], i, &parts[i]);
    struct hatch_buffer file = write_all(parts, PARTS, 1);
    struct hatch_bytes bytes = {file.data, file.size};
    HATCH_TEST_OK(hatch_pool_make(4, &keep, &pool, &err), &err);
    HATCH_TEST_OK(hatch_exr_read(bytes, pool, &keep, &scratch, &got[0], &count, &err), &err);
    ck_assert_uint_eq(count, PARTS);
    for (uint32_t i = 0; i < PARTS; i++)
        same_part(&got[0][i], &parts[i]);
    uint32_t damaged = 0;
    for (size_t at = file.size / 4; at < file.size; at += file.size / 23) {
        enum hatch_status status[2];
        memset(file.data + at, 0x55, 40);
        for (int i = 0; i < 2; i++)
            status[i] = hatch_exr_read(bytes, i ? pool : NULL, &keep, &scratch, &got[i], &count, &errs[i]);
        ck_assert_int_eq(status[0], status[1]);
        damaged += status[0] != HATCH_OK;
        ck_assert(status[0] == HATCH_OK || strcmp(errs[0].text, errs[1].text) == 0);
    }
    ck_assert_uint_gt(damaged, 10);
    hatch_pool_free(pool);
}
END_TEST

START_TEST(a_truncated_file_is_refused)
{
    struct hatch_mipmap parts[2], *got = NULL;
    uint32_t count = 77;
    for (uint32_t i = 0; i < 2; i++)
        make_part(&kinds[0], i, &parts[i]);
    struct hatch_buffer file = write_all(parts, 2, 1);
    for (size_t size = 0; size < file.size; size += size < 1500 ? 1 : 97) {
        struct hatch_bytes truncated = {file.data, size};
        enum hatch_status status = hatch_exr_read(truncated, NULL, &keep, &scratch, &got, &count, &err);
        ck_assert_msg(status == HATCH_BAD_INPUT, "%zu of %zu bytes: status %d", size, file.size, (int)status);
        ck_assert(err.text[0] && !got && count == 77);
    }
}
END_TEST

START_TEST(files_of_other_formats_are_refused)
{
    struct hatch_mipmap *got = NULL;
    uint32_t count = 0;
    struct hatch_bytes glb = {(const uint8_t *)"glTF....", 8}, nothing = {0};
    ck_assert_int_eq(hatch_exr_read(glb, NULL, &keep, &scratch, &got, &count, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "not an OpenEXR file");
    ck_assert_int_eq(hatch_exr_read(nothing, NULL, &keep, &scratch, &got, &count, &err), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "empty");
}
END_TEST

START_TEST(a_file_larger_than_the_arena_is_refused_before_any_allocation)
{
    struct hatch_mipmap part, *got = NULL;
    uint32_t count = 0;
    make_part(&kinds[5], 0, &part);
    struct hatch_buffer file = write_all(&part, 1, 1);
    struct hatch_arena small;
    hatch_arena_init(&small, 65536);
    ck_assert_int_eq(
        hatch_exr_read((struct hatch_bytes){file.data, file.size}, NULL, &small, &scratch, &got, &count, &err),
        HATCH_LIMIT);
    ck_assert_uint_eq(small.peak_bytes, 0);
}
END_TEST

/* Reads a file of one pixel whose header claims more. Returns whether memory was allocated for them.
 *   size  of the file, which ends in zeros
 *   want  status */
static bool allocates(uint32_t width, uint32_t height, size_t size, size_t limit_bytes, enum hatch_status want)
{
    static const char name[] = "dataWindow\0box2i";
    uint32_t corner[2] = {width - 1, height - 1}, count = 0;
    struct hatch_mipmap part, *got = NULL;
    struct hatch_arena arena;
    make_part(&kinds[1], 0, &part);
    struct hatch_buffer file = write_all(&part, 1, 1);
    uint8_t *longer = HATCH_NEW(&keep, uint8_t, size, &err);
    ck_assert_uint_ge(size, file.size);
    memcpy(longer, file.data, file.size);
    size_t at = 0;
    while (memcmp(longer + at, name, sizeof name) != 0)
        at++;
    memcpy(longer + at + sizeof name + 4 + 8, corner, sizeof corner);
    hatch_arena_init(&arena, limit_bytes);
    ck_assert_int_eq(hatch_exr_read((struct hatch_bytes){longer, size}, NULL, &arena, &scratch, &got, &count, &err),
                     want);
    bool allocated = arena.peak_bytes > 0;
    hatch_arena_free(&arena);
    return allocated;
}

START_TEST(a_wrong_window_is_refused_before_any_allocation)
{
    ck_assert(!allocates(40000, 40000, 1000, SIZE_MAX, HATCH_BAD_INPUT));
    ck_assert(strstr(err.text, "40000x40000"));
}
END_TEST

/* Deflate packs 1032 bytes into one at best, and each chunk of 16 rows has an offset of eight bytes: windows of as many
 * pixels and rows as could fit are read, until that fails. The floats of the pixels may take all memory. */
START_TEST(windows_reach_the_limits_of_the_file)
{
    const uint32_t size = 1000;
    ck_assert(allocates(1032 / 2, size, size, LIMIT, HATCH_BAD_INPUT));
    ck_assert(!allocates(1032 / 2, size + 1, size, LIMIT, HATCH_BAD_INPUT));
    ck_assert(allocates(1, 16 * size / 8, size, LIMIT, HATCH_BAD_INPUT));
    ck_assert(!allocates(1, 16 * size / 8 + 1, size, LIMIT, HATCH_BAD_INPUT));
    ck_assert(allocates(100, 100, size, 100 * 100 * sizeof(float), HATCH_LIMIT));
    ck_assert(!allocates(100, 100, size, 100 * 100 * sizeof(float) - 1, HATCH_LIMIT));
}
END_TEST

START_TEST(as_many_channels_are_read_as_an_image_may_have)
{
    struct hatch_mipmap part, *got = NULL;
    uint32_t count = 0;
    make_part(&kinds[1], 0, &part);
    HATCH_TEST_OK(hatch_image_make(&keep, 1, 1, "ABCDEFGH", &part.levels[0], &err), &err);
    ck_assert_uint_eq(part.levels[0].channel_count, HATCH_IMAGE_CHANNELS_MAX);
    struct hatch_buffer file = write_all(&part, 1, 1);
    HATCH_TEST_OK(hatch_exr_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &got, &count, &err),
                  &err);
    ck_assert_uint_eq(got[0].levels[0].channel_count, HATCH_IMAGE_CHANNELS_MAX);
}
END_TEST

/* Inserts bytes into the header of a file with one chunk. */
static struct hatch_bytes insert(const struct hatch_buffer *file, size_t at, struct hatch_bytes added)
{
    uint8_t *longer = HATCH_NEW(&keep, uint8_t, file->size + added.size, &err);
    memcpy(longer, file->data, at);
    memcpy(longer + at, added.data, added.size);
    memcpy(longer + at + added.size, file->data + at, file->size - at);
    for (size_t i = at; i + 8 < file->size + added.size; i++) { /* the chunk follows the table of its offset */
        uint64_t offset;
        memcpy(&offset, longer + i, sizeof offset);
        if (offset == i + 8 - added.size) {
            offset += added.size;
            memcpy(longer + i, &offset, sizeof offset);
        }
    }
    return (struct hatch_bytes){longer, file->size + added.size};
}

/* Makes a name of a file with one chunk longer by one letter.
 *   attribute  its name and type, which the size follows
 *   name       the name, which stands in the attribute */
static struct hatch_bytes lengthen(const struct hatch_buffer *file, const char *attribute, size_t length,
                                   const char *name)
{
    size_t at = 0, letter;
    while (memcmp(file->data + at, attribute, length) != 0)
        at++;
    for (letter = at + length; memcmp(file->data + letter, name, strlen(name)) != 0;)
        letter++;
    file->data[at + length]++;
    struct hatch_bytes longer = insert(file, letter, (struct hatch_bytes){(const uint8_t *)name, 1});
    file->data[at + length]--;
    return longer;
}

/* Attributes of other programs do not take the room of those of hatch, wherever they stand. */
START_TEST(attributes_of_other_programs_are_left_out)
{
    struct hatch_mipmap part, *got = NULL;
    uint32_t count = 0;
    uint8_t added[1000];
    size_t size = 0;
    for (uint32_t i = 0; i < 40; i++, size += 16) { /* a00 int, of 4 bytes */
        memcpy(added + size, "a00\0int\0\4\0\0\0\1\0\0\0", 16);
        added[size + 1] = (uint8_t)('0' + i / 10);
        added[size + 2] = (uint8_t)('0' + i % 10);
    }
    make_part(&kinds[1], 3, &part);
    struct hatch_buffer file = write_all(&part, 1, 1);
    HATCH_TEST_OK(
        hatch_exr_read(insert(&file, 8, (struct hatch_bytes){added, size}), NULL, &keep, &scratch, &got, &count, &err),
        &err);
    same_part(&got[0], &part);
}
END_TEST

START_TEST(names_may_be_as_long_as_there_is_room)
{
    static const char part_type[] = "name\0string", channel_type[] = "channels\0chlist";
    struct hatch_mipmap part, *got = NULL;
    uint32_t count = 0;
    char name[HATCH_NAME_MAX] = "";
    memset(name, 'n', HATCH_NAME_MAX - 1);
    make_part(&kinds[1], 0, &part);
    memcpy(part.name, name, sizeof name);
    memset(name, 'c', HATCH_NAME_MAX - 1);
    memcpy(part.levels[0].channels[0].name, name, sizeof name);
    struct hatch_buffer file = write_all(&part, 1, 1);
    HATCH_TEST_OK(hatch_exr_read((struct hatch_bytes){file.data, file.size}, NULL, &keep, &scratch, &got, &count, &err),
                  &err);
    ck_assert_str_eq(got[0].levels[0].channels[0].name, name);
    struct hatch_bytes longer = lengthen(&file, channel_type, sizeof channel_type, name);
    ck_assert_int_eq(hatch_exr_read(longer, NULL, &keep, &scratch, &got, &count, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "channel name of 64 bytes, want 1 to 63"));
    longer = lengthen(&file, part_type, sizeof part_type, part.name);
    ck_assert_int_eq(hatch_exr_read(longer, NULL, &keep, &scratch, &got, &count, &err), HATCH_BAD_INPUT);
    ck_assert_ptr_nonnull(strstr(err.text, "its name is longer than 63 bytes"));
}
END_TEST

START_TEST(a_writer_stops_at_its_limit)
{
    struct hatch_mipmap part;
    struct hatch_exr_writer *writer = NULL;
    struct hatch_arena small;
    make_part(&kinds[6], 0, &part);
    hatch_arena_init(&small, 200000);
    HATCH_TEST_OK(hatch_exr_begin(&part, 2, &small, &writer, &err), &err);
    ck_assert_int_eq(hatch_exr_add_part(writer, 0, &part, &err), HATCH_LIMIT);
    hatch_exr_abandon(writer);
    hatch_exr_abandon(NULL);
    hatch_arena_free(&small);
}
END_TEST

/* Parts in as much memory as all of them take when packed, beside what the writer itself takes, and in one byte less.
 */
START_TEST(packed_parts_may_take_all_memory)
{
    enum { MANY = 12 };
    struct hatch_mipmap *parts = HATCH_NEW(&keep, struct hatch_mipmap, MANY, &err);
    struct hatch_exr_writer *writer = NULL;
    struct hatch_bytes pieces[MANY];
    struct hatch_buffer head = {.arena = &keep};
    size_t packed = 0, taken = 0;
    for (uint32_t i = 0; i < MANY; i++)
        make_part(&kinds[5], i, &parts[i]);
    for (size_t round = 0; round < 3; round++) { /* the first round finds what the parts and the writer take */
        struct hatch_arena arena;
        hatch_arena_init(&arena, round ? taken + packed - (round - 1) : LIMIT);
        HATCH_TEST_OK(hatch_exr_begin(&parts[0], MANY, &arena, &writer, &err), &err);
        taken = arena.used_bytes;
        for (uint32_t i = 0; i < MANY; i++)
            ck_assert_msg(hatch_exr_add_part(writer, i, &parts[i], &err) ==
                              (round == 2 && i == MANY - 1 ? HATCH_LIMIT : HATCH_OK),
                          "round %zu, part %u: %s", round, i, err.text);
        if (round == 0)
            HATCH_TEST_OK(hatch_exr_pieces(writer, &head, pieces, &err), &err);
        for (uint32_t i = 0; round == 0 && i < MANY; i++)
            packed += pieces[i].size;
        hatch_exr_abandon(writer);
        hatch_arena_free(&arena);
    }
    ck_assert_ptr_nonnull(strstr(err.text, "compressed images exceed the memory limit"));
}
END_TEST

/* The pieces are valid until the writer is freed. */
START_TEST(pieces_joined_are_the_file)
{
    struct hatch_mipmap parts[PARTS];
    for (uint32_t i = 0; i < PARTS; i++)
        make_part(&kinds[_i], i, &parts[i]);
    uint32_t count = _i % 2 ? 1 : PARTS;
    struct hatch_buffer file = write_all(parts, count, 1), head = {.arena = &keep};
    struct hatch_exr_writer *writer;
    struct hatch_bytes pieces[PARTS];
    HATCH_TEST_OK(hatch_exr_begin(&parts[0], count, &keep, &writer, &err), &err);
    for (uint32_t i = 0; i < count; i++)
        HATCH_TEST_OK(hatch_exr_add_part(writer, i, &parts[i], &err), &err);
    HATCH_TEST_OK(hatch_exr_pieces(writer, &head, pieces, &err), &err);
    for (uint32_t i = 0; i < count; i++)
        HATCH_TEST_OK(hatch_buffer_add(&head, pieces[i].data, pieces[i].size, &err), &err);
    hatch_exr_abandon(writer);
    ck_assert_uint_eq(head.size, file.size);
    ck_assert_mem_eq(head.data, file.data, file.size);
}
END_TEST

struct reading {
    struct hatch_bytes file;
    struct hatch_mipmap *parts;
};

static enum hatch_status read_file(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                   struct hatch_err *error)
{
    struct reading *reading = context;
    uint32_t count = 0;
    return hatch_exr_read(reading->file, NULL, arena, temporary, &reading->parts, &count, error);
}

static enum hatch_status write_file(void *context, struct hatch_arena *arena, struct hatch_arena *temporary,
                                    struct hatch_err *error)
{
    const struct hatch_mipmap *part = context;
    struct hatch_exr_writer *writer = NULL;
    struct hatch_buffer file = {.arena = arena};
    (void)temporary;
    HATCH_TRY(hatch_exr_begin(part, 1, arena, &writer, error));
    HATCH_TRY(hatch_exr_add_part(writer, 0, part, error));
    enum hatch_status status = hatch_exr_end(writer, &file, error);
    ck_assert(status == HATCH_OK || file.size == 0);
    return status;
}

START_TEST(each_allocation_may_fail)
{
    struct hatch_mipmap part;
    make_part(&kinds[0], 0, &part);
    struct hatch_buffer file = write_all(&part, 1, 1);
    struct reading reading = {.file = {file.data, file.size}};
    hatch_test_fail_alloc(read_file, &reading, &reading.parts, sizeof reading.parts);
    hatch_test_fail_alloc(write_file, &part, NULL, 0);
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("io exr");
    TCase *tests = tcase_create("exr");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_loop_test(tests, files_survive_a_round_trip, 0, sizeof kinds / sizeof *kinds);
    tcase_add_loop_test(tests, pieces_joined_are_the_file, 0, sizeof kinds / sizeof *kinds);
    tcase_add_test(tests, writing_does_not_depend_on_threads);
    tcase_add_test(tests, reading_does_not_depend_on_threads);
    tcase_add_test(tests, a_truncated_file_is_refused);
    tcase_add_test(tests, files_of_other_formats_are_refused);
    tcase_add_test(tests, a_file_larger_than_the_arena_is_refused_before_any_allocation);
    tcase_add_test(tests, a_wrong_window_is_refused_before_any_allocation);
    tcase_add_test(tests, as_many_channels_are_read_as_an_image_may_have);
    tcase_add_test(tests, attributes_of_other_programs_are_left_out);
    tcase_add_test(tests, names_may_be_as_long_as_there_is_room);
    tcase_add_test(tests, windows_reach_the_limits_of_the_file);
    tcase_add_test(tests, packed_parts_may_take_all_memory);
    tcase_add_test(tests, a_writer_stops_at_its_limit);
    tcase_add_test(tests, each_allocation_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
