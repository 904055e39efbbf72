#include <stdio.h>
#include <stdlib.h>

#include "base/json.h"
#include "io/glb/parts.h"

enum hatch_status hatch_glb_comma(struct hatch_glb *glb)
{
    uint8_t last = glb->json.size ? glb->json.data[glb->json.size - 1] : '{';
    if (last == '{' || last == '[')
        return HATCH_OK;
    return hatch_buffer_add(&glb->json, ",", 1, glb->err);
}

enum hatch_status hatch_glb_key(struct hatch_glb *glb, const char *key)
{
    HATCH_TRY(hatch_glb_comma(glb));
    return hatch_buffer_print(&glb->json, glb->err, "\"%s\":", key);
}

enum hatch_status hatch_glb_put(struct hatch_glb *glb, const char *json)
{
    return hatch_buffer_print(&glb->json, glb->err, "%s", json);
}

enum hatch_status hatch_glb_open_array(struct hatch_glb *glb, const char *key)
{
    HATCH_TRY(hatch_glb_key(glb, key));
    return hatch_glb_put(glb, "[");
}

enum hatch_status hatch_glb_escaped_key(struct hatch_glb *glb, const char *key)
{
    HATCH_TRY(hatch_glb_comma(glb));
    HATCH_TRY(hatch_json_add_string(&glb->json, key, glb->err));
    return hatch_glb_put(glb, ":");
}

enum hatch_status hatch_glb_string(struct hatch_glb *glb, const char *key, const char *value)
{
    HATCH_TRY(hatch_glb_key(glb, key));
    return hatch_json_add_string(&glb->json, value, glb->err);
}

/* Returns value, but 0 for -0. JSON readers read -0 as the integer 0, so a file with -0 would change when it is read
 * and written again. */
static double without_minus_zero(double value)
{
    return value == 0 ? 0 : value;
}

/* Prints a number with the fewest of these digits that identify it. */
static enum hatch_status print_double(struct hatch_glb *glb, double value)
{
    static const int digits[] = {9, 15, 16, 17};
    char text[32];
    for (size_t i = 0; i < sizeof digits / sizeof *digits; i++) {
        snprintf(text, sizeof text, "%.*g", digits[i], without_minus_zero(value));
        if (strtod(text, NULL) == value)
            break;
    }
    return hatch_buffer_print(&glb->json, glb->err, "%s", text);
}

enum hatch_status hatch_glb_number(struct hatch_glb *glb, const char *key, float value)
{
    HATCH_TRY(hatch_glb_key(glb, key));
    return hatch_buffer_print(&glb->json, glb->err, "%.9g", without_minus_zero((double)value));
}

enum hatch_status hatch_glb_integer(struct hatch_glb *glb, const char *key, uint32_t value)
{
    HATCH_TRY(hatch_glb_key(glb, key));
    return hatch_buffer_print(&glb->json, glb->err, "%u", value);
}

enum hatch_status hatch_glb_numbers(struct hatch_glb *glb, const char *key, const float *values, uint32_t count)
{
    HATCH_TRY(hatch_glb_key(glb, key));
    for (uint32_t i = 0; i < count; i++)
        HATCH_TRY(
            hatch_buffer_print(&glb->json, glb->err, "%c%.9g", i ? ',' : '[', without_minus_zero((double)values[i])));
    return hatch_glb_put(glb, "]");
}

enum hatch_status hatch_glb_doubles(struct hatch_glb *glb, const char *key, const double *values, uint32_t count)
{
    HATCH_TRY(hatch_glb_open_array(glb, key));
    for (uint32_t i = 0; i < count; i++) {
        HATCH_TRY(hatch_glb_comma(glb));
        HATCH_TRY(print_double(glb, values[i]));
    }
    return hatch_glb_put(glb, "]");
}

enum hatch_status hatch_glb_open_named(struct hatch_glb *glb, const struct hatch_kept *kept)
{
    HATCH_TRY(hatch_glb_comma(glb));
    HATCH_TRY(hatch_glb_put(glb, "{"));
    return kept->name ? hatch_glb_string(glb, "name", kept->name) : HATCH_OK;
}

enum hatch_status hatch_glb_close_extras(struct hatch_glb *glb, const struct hatch_kept *kept)
{
    if (!kept->extras || kept->extras[0] != '{')
        return hatch_glb_put(glb, "}");
    HATCH_TRY(hatch_glb_comma(glb));
    return hatch_glb_put(glb, kept->extras + 1);
}

enum hatch_status hatch_glb_print_extras(struct hatch_glb *glb, const struct hatch_kept *kept)
{
    if (!kept->extras)
        return HATCH_OK;
    HATCH_TRY(hatch_glb_key(glb, "extras"));
    return hatch_glb_put(glb, kept->extras);
}

enum hatch_status hatch_glb_close_kept(struct hatch_glb *glb, const struct hatch_kept *kept)
{
    HATCH_TRY(hatch_glb_print_extras(glb, kept));
    return hatch_glb_put(glb, "}");
}
