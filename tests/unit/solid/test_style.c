#include "made.h"

static struct hatch_solid_style style;

static void begin_empty(void)
{
    begin();
    style = (struct hatch_solid_style){0};
}

START_TEST(every_kind_is_read_with_its_defaults)
{
    static const char *const texts[] = {"kind perlin",  "kind turbulence", "kind wood",  "kind marble", "kind worley",
                                        "kind stipple", "kind strokes",    "kind paper", "kind canvas"};
    for (int i = 0; i < HATCH_SOLID_KINDS - 1; i++) {
        style = (struct hatch_solid_style){0};
        HATCH_TEST_OK(parse_style(texts[i], &style), &err);
        ck_assert_int_eq(style.kind, i + 1);
        ck_assert_str_eq(hatch_solid_kind_name(style.kind), texts[i] + 5);
        ck_assert_float_eq(style.contrast, 1);
        ck_assert(hatch_solid_equalizes(&style));
    }
    ck_assert_float_eq(style.threads, 16);
    ck_assert_float_eq(style.scale, 0); /* canvas does not use it */
}
END_TEST

START_TEST(every_key_sets_its_member)
{
    HATCH_TEST_OK(parse_style("# wood\nkind wood # oak\nscale 3\nrings 9\nwarp .5\naxis z\ngrain 0.25\nfibers 17\n"
                              "equalize no\ncontrast 2\ncolor 0 000\ncolor 0.5 ff8000\n",
                              &style),
                  &err);
    ck_assert_float_eq(style.scale, 3);
    ck_assert_float_eq(style.rings, 9);
    ck_assert_float_eq(style.warp, 0.5f);
    ck_assert_uint_eq(style.axis, 2);
    ck_assert_float_eq(style.grain, 0.25f);
    ck_assert_float_eq(style.fibers, 17);
    ck_assert_float_eq(style.contrast, 2);
    ck_assert_uint_eq(style.color_count, 2);
    ck_assert_float_eq(style.colors[1].at, 0.5f);
    ck_assert_float_eq(style.colors[1].rgb[0], 1);
    ck_assert(!hatch_solid_equalizes(&style));
    HATCH_TEST_OK(parse_style("kind marble\nveins -1 0 3\noctaves 4\ngain 0.75\nsharpness 2.5\ncolor 1 fff", &style),
                  &err);
    ck_assert_float_eq(style.veins[0], -1);
    ck_assert_float_eq(style.veins[2], 3);
    ck_assert_float_eq(style.octaves, 4);
    ck_assert_float_eq(style.gain, 0.75f);
    ck_assert_float_eq(style.sharpness, 2.5f);
    ck_assert_uint_eq(style.color_count, 1); /* another kind begins anew */
    ck_assert(!hatch_solid_equalizes(&style));
    HATCH_TEST_OK(parse_style("equalize yes", &style), &err);
    ck_assert(hatch_solid_equalizes(&style));
    HATCH_TEST_OK(parse_style("kind worley\ndistance f2-f1\njitter .5", &style), &err);
    ck_assert_uint_eq(style.distance, HATCH_SOLID_F2_F1);
    ck_assert_float_eq(style.jitter, 0.5f);
    HATCH_TEST_OK(parse_style("kind stipple\ndots 20\nvary 1", &style), &err);
    ck_assert_float_eq(style.dots, 20);
    ck_assert_float_eq(style.vary, 1);
    HATCH_TEST_OK(parse_style("kind canvas\nthreads 2", &style), &err);
    ck_assert_float_eq(style.threads, 2);
}
END_TEST

START_TEST(directions_of_a_text_replace_those_before)
{
    HATCH_TEST_OK(parse_style("kind strokes\nlength .5\nwidth .01\ndensity 2\ngrow 1\njitter 90\n"
                              "direction 1 0 -1\ndirection 0 1 0 0.25 0.5\n",
                              &style),
                  &err);
    ck_assert_float_eq(style.length, 0.5f);
    ck_assert_float_eq(style.width, 0.01f);
    ck_assert_float_eq(style.density, 2);
    ck_assert_float_eq(style.grow, 1);
    ck_assert_float_eq(style.jitter, 90);
    ck_assert_uint_eq(style.direction_count, 2);
    ck_assert_float_eq(style.directions[0].vector[2], -1);
    ck_assert_float_eq(style.directions[0].to, 1);
    ck_assert_float_eq(style.directions[1].from, 0.25f);
    ck_assert_float_eq(style.directions[1].to, 0.5f);
    HATCH_TEST_OK(parse_style("direction 0 0 1", &style), &err);
    ck_assert_uint_eq(style.direction_count, 1);
    ck_assert_float_eq(style.length, 0.5f);
}
END_TEST

static const char *const refusals[][2] = {
    {"", "empty: want at least one line with a key, such as 'kind wood'"},
    {"# nothing\n", "empty"},
    {"scale 3", "line 1: 'scale', want the kind first, such as 'kind wood'"},
    {"\nkind oak",
     "line 2: kind: 'oak', want perlin, turbulence, wood, marble, worley, stipple, strokes, paper or canvas"},
    {"kind none", "line 1: kind: 'none', want perlin"},
    {"kind", "line 1: kind: a value is missing"},
    {"kind wood oak", "line 1: kind: too many values"},
    {"kind wood\nkind wood", "line 2: kind: want it before all other keys, once"},
    {"kind wood\ndots 3", "line 2: dots: kind wood does not use it"},
    {"kind stipple\naxis x", "line 2: axis: kind stipple does not use it"},
    {"kind wood\nring 3", "line 2: no such key 'ring', perhaps rings"},
    {"kind wood\nknots 3", "line 2: no such key 'knots'; solid(5) lists them"},
    {"kind wood\nrings 3.5", "line 2: rings: 3.5, want a whole number"},
    {"kind wood\nrings 65", "line 2: rings: 65, want 1 to 64"},
    {"kind wood\nrings many", "line 2: rings: 'many' is not a number"},
    {"kind wood\nrings", "line 2: rings: a value is missing"},
    {"kind wood\nrings 3 4", "line 2: rings: too many values"},
    {"kind wood\naxis w", "line 2: axis: 'w', want x, y or z"},
    {"kind canvas\nthreads 7", "line 2: threads: 7, want an even number"},
    {"kind worley\njitter 2", "line 2: jitter: 2, want 0 to 1"},
    {"kind worley\ndistance f3", "line 2: distance: 'f3', want f1, f2 or f2-f1"},
    {"kind strokes\njitter 91", "line 2: jitter: 91, want 0 to 90"},
    {"kind strokes\ndirection 0 0 0", "line 2: direction: 0 0 0 has no direction"},
    {"kind strokes\ndirection 1 0", "line 2: direction: a value is missing"},
    {"kind strokes\ndirection 1 0 0 0.5", "line 2: direction: a value is missing"},
    {"kind strokes\ndirection 1 0 0 0.5 0.5", "line 2: direction: the range from tone 0.5 to tone 0.5 is empty"},
    {"kind strokes\ndirection 2 0 0", "line 2: direction: 2, want -1 to 1"},
    {"kind marble\nveins 0 0 0", "veins: 0 0 0 has no veins"},
    {"kind perlin\ncontrast 2", "contrast: equalized values do not use it, want 'equalize no'"},
    {"kind perlin\nequalize maybe", "line 2: equalize: 'maybe', want yes or no"},
    {"kind perlin\ncolor 0.5 12", "line 2: color: want a value and three or six hexadecimal digits"},
    {"kind perlin\ncolor 0.5 000\ncolor 0.5 fff",
     "line 3: color: value 0.5 does not exceed that of the color line before"},
};

START_TEST(wrong_styles_are_refused_and_change_nothing)
{
    struct hatch_solid_style before = style;
    ck_assert_int_eq(parse_style(refusals[_i][0], &style), HATCH_BAD_INPUT);
    ck_assert_msg(strncmp(err.text, refusals[_i][1], strlen(refusals[_i][1])) == 0, "%s\nwant: %s", err.text,
                  refusals[_i][1]);
    ck_assert_mem_eq(&before, &style, sizeof style);
}
END_TEST

/* Each key with twice as many features as 32 texels can show, and with just as many. */
START_TEST(numbers_are_lowered_to_those_that_texels_show)
{
    static const struct {
        const char *text, *key;
        size_t offset;
        float most;
    } cases[] = {
        {"kind perlin\nscale 32", "scale", offsetof(struct hatch_solid_style, scale), 16},
        {"kind wood\nfibers 4\nrings 32", "rings", offsetof(struct hatch_solid_style, rings), 16},
        {"kind wood\nfibers 64", "fibers", offsetof(struct hatch_solid_style, fibers), 32},
        {"kind stipple\ndots 32", "dots", offsetof(struct hatch_solid_style, dots), 16},
        {"kind canvas\nthreads 16", "threads", offsetof(struct hatch_solid_style, threads), 8},
        {"kind marble\nveins 16 0 0", "veins", offsetof(struct hatch_solid_style, veins), 8},
        {"kind marble\nveins 0 -8 -16", "veins", offsetof(struct hatch_solid_style, veins) + 2 * sizeof(float), -8},
    };
    float value;
    HATCH_TEST_OK(parse_style(cases[_i].text, &style), &err);
    ck_assert_str_eq(hatch_solid_style_fit(&style, 32), cases[_i].key);
    memcpy(&value, (char *)&style + cases[_i].offset, sizeof value);
    ck_assert_float_eq(value, cases[_i].most);
    ck_assert_ptr_null(hatch_solid_style_fit(&style, 32));
}
END_TEST

START_TEST(a_ninth_direction_is_refused)
{
    char text[512] = "kind strokes\n";
    for (int i = 0; i < 8; i++)
        strcat(text, "direction 1 0 0\n");
    HATCH_TEST_OK(parse_style(text, &style), &err);
    strcat(text, "direction 1 0 0\n");
    ck_assert_int_eq(parse_style(text, &style), HATCH_BAD_INPUT);
    ck_assert_str_eq(err.text, "line 10: more than 8 direction lines");
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("solid style");
    TCase *tests = tcase_create("style");
    tcase_add_checked_fixture(tests, begin_empty, end);
    tcase_add_test(tests, every_kind_is_read_with_its_defaults);
    tcase_add_test(tests, every_key_sets_its_member);
    tcase_add_test(tests, directions_of_a_text_replace_those_before);
    tcase_add_loop_test(tests, wrong_styles_are_refused_and_change_nothing, 0, sizeof refusals / sizeof *refusals);
    tcase_add_loop_test(tests, numbers_are_lowered_to_those_that_texels_show, 0, 7);
    tcase_add_test(tests, a_ninth_direction_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
