#include "arenas.h"

#include <string.h>

#include "base/json.h"

#define REPLACED "\xef\xbf\xbd"

START_TEST(strings_are_valid_json_and_utf8_for_any_bytes)
{
    static const char *const cases[][2] = {
        {"", "\"\""},
        {"a/b.glb", "\"a/b.glb\""},
        {"\"\\", "\"\\\"\\\\\""},
        {"a\n\t\x7f", "\"a\\u000a\\u0009\\u007f\""},
        {"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80", "\"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80\""},
        {"a\xff.glb", "\"a" REPLACED ".glb\""},
        {"\xc0\xaf", "\"" REPLACED REPLACED "\""},                           /* overlong */
        {"\xe0\x9f\xbf", "\"" REPLACED REPLACED REPLACED "\""},              /* overlong */
        {"\xed\xa0\x80", "\"" REPLACED REPLACED REPLACED "\""},              /* a surrogate */
        {"\xf4\x90\x80\x80", "\"" REPLACED REPLACED REPLACED REPLACED "\""}, /* over 0x10ffff */
        {"\xf4\x8f\xbf\xbf", "\"\xf4\x8f\xbf\xbf\""},
        {"\xe2\x82", "\"" REPLACED REPLACED "\""}, /* cut off */
        {"\x80z", "\"" REPLACED "z\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct hatch_buffer buffer = {.arena = &keep};
        HATCH_TEST_OK(hatch_json_add_string(&buffer, cases[i][0], &err), &err);
        ck_assert_msg(buffer.size == strlen(cases[i][1]) && memcmp(buffer.data, cases[i][1], buffer.size) == 0,
                      "case %zu: %.*s", i, (int)buffer.size, (const char *)buffer.data);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("base json");
    TCase *tests = tcase_create("json");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, strings_are_valid_json_and_utf8_for_any_bytes);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
