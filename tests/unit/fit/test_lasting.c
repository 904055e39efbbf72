#include "run.h"

#include "fit/lasting.h"

enum { FRAMES = 40, MIDDLE = HATCH_LASTING_AHEAD, PATTERNS = 1 << HATCH_LASTING_SPAN, ALWAYS = 100 };

/* Lists the strokes of which bit k of the id is set, and those that are always in sight. Returns their number. */
static size_t list_bit(uint32_t k, uint64_t ids[PATTERNS + ALWAYS])
{
    size_t count = 0;
    for (uint64_t id = 0; id < PATTERNS + ALWAYS; id++)
        if (id >= PATTERNS || id >> k & 1)
            ids[count++] = id;
    return count;
}

/* Every way of being in sight in five frames: in three in a row, with the middle one among them, or not. */
START_TEST(strokes_last_that_are_in_sight_three_times_in_a_row)
{
    static uint64_t ids[HATCH_LASTING_SPAN][PATTERNS + ALWAYS];
    struct hatch_seen frames[HATCH_LASTING_SPAN];
    bool lasts[PATTERNS + ALWAYS];
    for (uint32_t k = 0; k < HATCH_LASTING_SPAN; k++)
        frames[k] = (struct hatch_seen){true, list_bit(k, ids[k]), ids[k]};
    hatch_lasting_find(frames, lasts);
    for (size_t i = 0; i < frames[MIDDLE].count; i++) {
        uint64_t id = ids[MIDDLE][i];
        bool wanted = id >= PATTERNS || (id & 7) == 7 || (id & 14) == 14 || (id & 28) == 28;
        ck_assert_msg(lasts[i] == wanted, "pattern %u", (unsigned)id);
    }
}
END_TEST

START_TEST(unknown_frames_count_as_if_strokes_were_in_sight)
{
    static const uint64_t ids[] = {3, 9};
    struct hatch_seen frames[HATCH_LASTING_SPAN] = {{.known = false}};
    bool lasts[2] = {false, false};
    frames[MIDDLE] = (struct hatch_seen){true, 2, ids};
    hatch_lasting_find(frames, lasts);
    ck_assert(lasts[0] && lasts[1]);
    frames[MIDDLE - 1] = (struct hatch_seen){true, 1, ids};
    frames[MIDDLE + 1] = (struct hatch_seen){true, 1, ids};
    hatch_lasting_find(frames, lasts);
    ck_assert(lasts[0] && !lasts[1]);
}
END_TEST

/* Returns whether a stroke of a film is in sight: stroke n first in frame n, for n % 6 + 1 frames, again and again. */
static bool in_sight(int frame, uint64_t id)
{
    return id >= 60 || (frame + 60 - (int)id) % 11 <= (int)id % 6;
}

/* In a film, what is drawn has no run of fewer than three frames, and longer runs are drawn whole. */
START_TEST(runs_of_a_film_are_drawn_whole_or_not_at_all)
{
    static uint64_t ids[HATCH_LASTING_SPAN][60 + ALWAYS];
    for (int frame = 0; frame < FRAMES; frame++) {
        struct hatch_seen frames[HATCH_LASTING_SPAN];
        bool lasts[60 + ALWAYS];
        for (int k = 0; k < (int)HATCH_LASTING_SPAN; k++) {
            const int at = frame + k - MIDDLE;
            frames[k] = (struct hatch_seen){at >= 0 && at < FRAMES, 0, ids[k]};
            for (uint64_t id = 0; frames[k].known && id < 60 + ALWAYS; id++)
                if (in_sight(at, id))
                    ids[k][frames[k].count++] = id;
        }
        hatch_lasting_find(frames, lasts);
        for (size_t i = 0; i < frames[MIDDLE].count; i++) {
            const uint64_t id = ids[MIDDLE][i];
            const int first = frame - (frame + 60 - (int)id) % 11, last = first + (int)id % 6;
            const bool cut = first <= 0 || last >= FRAMES - 1; /* by the film's ends */
            ck_assert_msg(lasts[i] == (id >= 60 || cut || id % 6 >= 2), "frame %d, stroke %u", frame, (unsigned)id);
        }
    }
}
END_TEST

/* Beyond a jump of the view, after which no more than half of the strokes are the same, nothing is known. */
START_TEST(all_strokes_of_a_picture_between_others_last)
{
    static const uint64_t before[] = {1, 2, 3, 4}, ids[] = {3, 4, 5, 6}, nearly[] = {4, 5, 6, 7};
    struct hatch_seen frames[HATCH_LASTING_SPAN];
    bool lasts[4];
    for (int k = 0; k < (int)HATCH_LASTING_SPAN; k++)
        frames[k] = (struct hatch_seen){true, 4, k == MIDDLE ? ids : before};
    hatch_lasting_find(frames, lasts);
    ck_assert(lasts[0] && lasts[1] && lasts[2] && lasts[3]);
    frames[MIDDLE - 1].ids = frames[MIDDLE + 1].ids = nearly;
    hatch_lasting_find(frames, lasts);
    ck_assert(!lasts[0] && lasts[1] && lasts[2] && lasts[3]);
    frames[MIDDLE - 1] = frames[MIDDLE + 1] = (struct hatch_seen){true, 0, NULL};
    hatch_lasting_find(frames, lasts);
    ck_assert(lasts[0] && lasts[1] && lasts[2] && lasts[3]);
}
END_TEST

static Suite *suite(void)
{
    Suite *made = suite_create("fit");
    TCase *tests = tcase_create("lasting");
    tcase_add_test(tests, strokes_last_that_are_in_sight_three_times_in_a_row);
    tcase_add_test(tests, unknown_frames_count_as_if_strokes_were_in_sight);
    tcase_add_test(tests, all_strokes_of_a_picture_between_others_last);
    tcase_add_test(tests, runs_of_a_film_are_drawn_whole_or_not_at_all);
    suite_add_tcase(made, tests);
    return made;
}

HATCH_TEST_MAIN(suite)
