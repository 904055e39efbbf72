#include "placement/style.h"

#include <string.h>

#include "base/settings.h"
#include "image/color.h"

#define RADIANS_PER_DEGREE 0.017453292519943295
#define MARK_MIN 0.5 /* least length of a mark, in pixels */
#define ZIGZAG_MAX 20.0
#define WAVE_MIN 0.5 /* of a zigzag, in widths */
#define WAVE_MAX 1000.0
#define PROFILE_LEAST 0.1

void hatch_style_default(struct hatch_style *style)
{
    *style = (struct hatch_style){
        .name = "ink",
        .brush = HATCH_BRUSH_INK,
        .width_px = 1.8f,
        .length_min = 0.3f,
        .length_max = 1.0f,
        .jitter_rad = 0.01570796327f, /* 0.9 degrees */
        .ink = 1,
        .overlap = HATCH_OVERLAP_DARKENS,
        .tone_max = 0.9f,
        .tone_gamma = 1,
        .direction_count = 3,
        .directions = {{0, 0, 0.5f}, {1.570796327f, 0.5f, 1}, {0, 0.8f, 1}},
        .pen = {.thin = 0.6f,
                .join = 0.38f,
                .response = {0.1206f, 0.2388f, 0.3563f, 0.4745f, 0.5923f, 0.7047f, 0.8040f, 0.8822f},
                .taper_px = 16,
                .vary = 0.3f,
                .wobble_px = 0.3f},
        .candidates_light = 1000,
        .candidates_dark = 100,
    };
}

void hatch_style_targets(const struct hatch_style *style, uint32_t tones, float *target)
{
    for (uint32_t i = 0; i < tones; i++) {
        double share = (double)(i + 1) / (double)tones;
        target[i] = (float)((double)style->tone_max * pow(share, (double)style->tone_gamma));
    }
}

/* State of the parser. */
struct reading {
    struct hatch_style style;
    bool directions_given; /* the first "direction" line replaces the default directions */
    bool colors_given;     /* the first "color" line replaces the default colours */
};

/* A key whose values are plain numbers. */
struct number_key {
    const char *name;
    uint32_t count;
    double low, high;
    double scale;     /* factor from the unit of the file to that of the struct */
    size_t offset[2]; /* in struct hatch_style */
};

#define AT(field) offsetof(struct hatch_style, field)
static const struct number_key number_keys[] = {
    {"width", 1, 0.5, 64, 1, {AT(width_px), 0}},
    {"length", 2, 0, 4, 1, {AT(length_min), AT(length_max)}},
    {"bend",
     2,
     0,
     HATCH_STROKE_BEND_MAX / RADIANS_PER_DEGREE,
     RADIANS_PER_DEGREE,
     {AT(bend_min_rad), AT(bend_max_rad)}},
    {"jitter", 1, 0, 90, RADIANS_PER_DEGREE, {AT(jitter_rad), 0}},
    {"ink", 1, 0.01, 1, 1, {AT(ink), 0}},
    {"darkest", 1, 0.01, 1, 1, {AT(tone_max), 0}},
    {"gamma", 1, 0.1, 10, 1, {AT(tone_gamma), 0}},
    {"thin", 1, 0.05, 1, 1, {AT(pen.thin), 0}},
    {"join", 1, 0, 1, 1, {AT(pen.join), 0}},
    {"taper", 1, 0, 1000, 1, {AT(pen.taper_px), 0}},
    {"vary", 1, 0, 1, 1, {AT(pen.vary), 0}},
    {"pressure", 1, 0, 1, 1, {AT(pen.pressure), 0}},
    {"grain", 1, 0, 1, 1, {AT(pen.grain), 0}},
    {"wobble", 1, 0, 20, 1, {AT(pen.wobble_px), 0}},
    {"turn", 1, 0, 30, RADIANS_PER_DEGREE, {AT(pen.turn_rad), 0}},
    {"scatter", 1, 0, 1, 1, {AT(pen.scatter), 0}},
    {"line-taper", 1, 0, 30, 1, {AT(line_brush.taper_px), 0}},
    {"line-vary", 1, 0, 1, 1, {AT(line_brush.vary), 0}},
    {"line-wobble", 1, 0, 1, 1, {AT(line_brush.wobble_px), 0}},
    {"line-depth", 1, 0, 1, 1, {AT(line_brush.depth), 0}},
    {"line-tone", 1, 0, 1, 1, {AT(line_brush.tone), 0}},
};

static enum hatch_status read_direction(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double angle, from, to;
    HATCH_TRY(hatch_settings_next(rest, "direction", -360, 360, &angle, err));
    HATCH_TRY(hatch_settings_next(rest, "direction", 0, 1, &from, err));
    HATCH_TRY(hatch_settings_next(rest, "direction", 0, 1, &to, err));
    if (from > to)
        return hatch_fail(err, HATCH_BAD_INPUT, "direction: the range from tone %g to tone %g is empty", from, to);
    if (!r->directions_given)
        r->style.direction_count = 0;
    r->directions_given = true;
    if (r->style.direction_count == HATCH_STYLE_DIRECTIONS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "more than %u direction lines", HATCH_STYLE_DIRECTIONS_MAX);
    r->style.directions[r->style.direction_count++] =
        (struct hatch_style_direction){(float)(angle * RADIANS_PER_DEGREE), (float)from, (float)to};
    return HATCH_OK;
}

static enum hatch_status read_color(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    if (!r->colors_given)
        r->style.color_count = 0;
    r->colors_given = true;
    return hatch_ramp_read(rest, "tone", r->style.colors, &r->style.color_count, err);
}

static struct hatch_text trimmed(struct hatch_text text)
{
    while (text.length && (*text.at == ' ' || *text.at == '\t')) {
        text.at++;
        text.length--;
    }
    while (text.length && (text.at[text.length - 1] == ' ' || text.at[text.length - 1] == '\t'))
        text.length--;
    return text;
}

static enum hatch_status read_brush(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    struct hatch_text word, rest_of_line;
    if (!hatch_text_word(rest, &word))
        return hatch_fail(err, HATCH_BAD_INPUT, "brush: a value is missing");
    for (int kind = 0; kind < HATCH_BRUSH_IMAGE; kind++)
        if (hatch_text_is(word, hatch_brush_name((enum hatch_brush_kind)kind))) {
            r->style.brush = (enum hatch_brush_kind)kind;
            return HATCH_OK;
        }
    if (!hatch_text_is(word, "image"))
        return hatch_fail(err, HATCH_BAD_INPUT,
                          "brush: '%.*s', want ink, pencil, crayon, charcoal, stipple, round or image FILE",
                          hatch_settings_shown(word), word.at);
    rest_of_line = trimmed(*rest); /* file names may contain spaces */
    if (rest_of_line.length == 0 || rest_of_line.length >= sizeof r->style.brush_file)
        return hatch_fail(err, HATCH_BAD_INPUT, "brush: image needs a file name of up to %zu bytes",
                          sizeof r->style.brush_file - 1);
    r->style.brush = HATCH_BRUSH_IMAGE;
    memset(r->style.brush_file, 0, sizeof r->style.brush_file);
    memcpy(r->style.brush_file, rest_of_line.at, rest_of_line.length);
    rest->length = 0;
    return HATCH_OK;
}

static enum hatch_status read_overlap(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    static const char *const names[] = {"darkens", "flat", "covers"};
    struct hatch_text word = {NULL, 0};
    bool any = hatch_text_word(rest, &word);
    for (unsigned i = 0; any && i < 3; i++)
        if (hatch_text_is(word, names[i])) {
            r->style.overlap = (enum hatch_overlap)i;
            return HATCH_OK;
        }
    return hatch_fail(err, HATCH_BAD_INPUT, "overlap: want darkens, flat or covers");
}

static enum hatch_status read_candidates(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double light, dark;
    HATCH_TRY(hatch_settings_next(rest, "candidates", 1, 1e6, &light, err));
    HATCH_TRY(hatch_settings_next(rest, "candidates", 1, 1e6, &dark, err));
    if (light != floor(light) || dark != floor(dark))
        return hatch_fail(err, HATCH_BAD_INPUT, "candidates: %.10g %.10g, want whole numbers", light, dark);
    r->style.candidates_light = (uint32_t)light;
    r->style.candidates_dark = (uint32_t)dark;
    return HATCH_OK;
}

static enum hatch_status read_response(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double value, before = 0;
    for (uint32_t i = 0; i < HATCH_STROKE_RESPONSES; i++, before = value) {
        HATCH_TRY(hatch_settings_next(rest, "response", 0, 1, &value, err));
        if (!(value > before))
            return hatch_fail(err, HATCH_BAD_INPUT, "response: %g does not exceed %g", value, before);
        r->style.pen.response[i] = (float)value;
    }
    return HATCH_OK;
}

static enum hatch_status read_marks(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double length, gap;
    HATCH_TRY(hatch_settings_next(rest, "marks", 0, 1000, &length, err));
    if (length > 0 && length < MARK_MIN)
        return hatch_fail(err, HATCH_BAD_INPUT, "marks: %g, want 0 or %g to 1000", length, MARK_MIN);
    HATCH_TRY(hatch_settings_next(rest, "marks", -0.5 * length, 1000, &gap, err));
    r->style.pen.mark_px = (float)length;
    r->style.pen.gap_px = (float)gap;
    return HATCH_OK;
}

static enum hatch_status read_zigzag(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double amplitude, length;
    HATCH_TRY(hatch_settings_next(rest, "zigzag", 0, ZIGZAG_MAX, &amplitude, err));
    HATCH_TRY(hatch_settings_next(rest, "zigzag", 0, WAVE_MAX, &length, err));
    if (amplitude > 0 && length < WAVE_MIN)
        return hatch_fail(err, HATCH_BAD_INPUT, "zigzag: a wave of %g widths, want %g to %g", length, WAVE_MIN,
                          WAVE_MAX);
    r->style.pen.look.zigzag = (float)amplitude;
    r->style.pen.look.zigzag_length = (float)length;
    return HATCH_OK;
}

static bool has_words(struct hatch_text line)
{
    struct hatch_text word;
    return hatch_text_word(&line, &word);
}

/* Reads a profile.
 *   least  of its largest value */
static enum hatch_status read_profile(struct hatch_text *rest, const char *key, double least,
                                      struct hatch_profile *profile, struct hatch_err *err)
{
    struct hatch_profile read = {.count = 0};
    double value, most = 0;
    do {
        HATCH_TRY(hatch_settings_next(rest, key, 0, 1, &value, err));
        read.values[read.count++] = (float)value;
        most = fmax(most, value);
    } while (read.count < HATCH_PROFILE_MAX && has_words(*rest));
    if (read.count < 2)
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: one value, want 2 to %u along the stroke", key, HATCH_PROFILE_MAX);
    if (most < least)
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: no value of %g or more", key, least);
    *profile = read;
    return HATCH_OK;
}

static enum hatch_status read_width_profile(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    return read_profile(rest, "width-profile", PROFILE_LEAST, &r->style.pen.look.width, err);
}

static enum hatch_status read_pressure_profile(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    return read_profile(rest, "pressure-profile", PROFILE_LEAST, &r->style.pen.look.pressure, err);
}

static enum hatch_status read_stroke_colors(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    static const char *const kinds[] = {"list", "range"};
    struct hatch_stroke_look *look = &r->style.pen.look;
    struct hatch_text word;
    uint32_t count = 0, kind = 0;
    bool any = hatch_text_word(rest, &word);
    while (any && kind < 2 && !hatch_text_is(word, kinds[kind]))
        kind++;
    if (!any || kind == 2)
        return hatch_fail(err, HATCH_BAD_INPUT, "stroke-colors: want list or range, and colours");
    for (; hatch_text_word(rest, &word); count++) {
        if (count == HATCH_STROKE_COLORS_MAX)
            return hatch_fail(err, HATCH_BAD_INPUT, "stroke-colors: more than %u colours", HATCH_STROKE_COLORS_MAX);
        if (!hatch_color_from_hex(word, look->colors[count]))
            return hatch_fail(err, HATCH_BAD_INPUT, "stroke-colors: '%.*s', want three or six hexadecimal digits",
                              hatch_settings_shown(word), word.at);
    }
    if (count < 1 + kind)
        return hatch_fail(err, HATCH_BAD_INPUT, "stroke-colors: %u colours, want at least %u", count, 1 + kind);
    look->color_count = count;
    look->mixes = kind == 1;
    return HATCH_OK;
}

static enum hatch_status read_name(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    struct hatch_text word;
    if (!hatch_text_word(rest, &word) || word.length >= sizeof r->style.name)
        return hatch_fail(err, HATCH_BAD_INPUT, "name: want one word of up to %zu bytes", sizeof r->style.name - 1);
    memset(r->style.name, 0, sizeof r->style.name);
    memcpy(r->style.name, word.at, word.length);
    return HATCH_OK;
}

static enum hatch_status read_numbers(const struct number_key *key, struct hatch_text *rest, struct reading *r,
                                      struct hatch_err *err)
{
    for (uint32_t i = 0; i < key->count; i++) {
        double value;
        HATCH_TRY(hatch_settings_next(rest, key->name, key->low, key->high, &value, err));
        float stored = (float)(value * key->scale);
        memcpy((char *)&r->style + key->offset[i], &stored, sizeof stored);
    }
    return HATCH_OK;
}

static const struct {
    const char *name;
    enum hatch_status (*read)(struct hatch_text *, struct reading *, struct hatch_err *);
} keys[] = {{"name", read_name},
            {"brush", read_brush},
            {"direction", read_direction},
            {"overlap", read_overlap},
            {"color", read_color},
            {"candidates", read_candidates},
            {"response", read_response},
            {"marks", read_marks},
            {"zigzag", read_zigzag},
            {"width-profile", read_width_profile},
            {"pressure-profile", read_pressure_profile},
            {"stroke-colors", read_stroke_colors}};

static enum hatch_status fail_unknown(struct hatch_text key, struct hatch_err *err)
{
    const char *near = NULL;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        near = hatch_text_is_near(key, keys[i].name) ? keys[i].name : near;
    for (size_t i = 0; i < sizeof number_keys / sizeof *number_keys; i++)
        near = hatch_text_is_near(key, number_keys[i].name) ? number_keys[i].name : near;
    int shown = hatch_settings_shown(key);
    if (near)
        return hatch_fail(err, HATCH_BAD_INPUT, "no such key '%.*s', perhaps %s", shown, key.at, near);
    return hatch_fail(err, HATCH_BAD_INPUT, "no such key '%.*s'; hatch-style(5) lists them", shown, key.at);
}

static enum hatch_status read_line(struct hatch_text line, struct reading *r, struct hatch_err *err)
{
    struct hatch_text key, extra;
    if (!hatch_text_word(&line, &key))
        return HATCH_OK;
    bool known = false;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (hatch_text_is(key, keys[i].name)) {
            known = true;
            HATCH_TRY(keys[i].read(&line, r, err));
        }
    for (size_t i = 0; i < sizeof number_keys / sizeof *number_keys; i++)
        if (hatch_text_is(key, number_keys[i].name)) {
            known = true;
            HATCH_TRY(read_numbers(&number_keys[i], &line, r, err));
            r->style.tone_max_given |= number_keys[i].offset[0] == AT(tone_max);
        }
    if (!known)
        return fail_unknown(key, err);
    if (hatch_text_word(&line, &extra))
        return hatch_fail(err, HATCH_BAD_INPUT, "%.*s: too many values", (int)key.length, key.at);
    return HATCH_OK;
}

static enum hatch_status check_ranges(const struct hatch_style *style, struct hatch_err *err)
{
    if (style->length_min > style->length_max)
        return hatch_fail(err, HATCH_BAD_INPUT, "length: the minimum %g exceeds the maximum %g",
                          (double)style->length_min, (double)style->length_max);
    if (style->bend_min_rad > style->bend_max_rad)
        return hatch_fail(err, HATCH_BAD_INPUT, "bend: the minimum %g exceeds the maximum %g",
                          (double)style->bend_min_rad / RADIANS_PER_DEGREE,
                          (double)style->bend_max_rad / RADIANS_PER_DEGREE);
    return HATCH_OK;
}

enum hatch_status hatch_style_parse(struct hatch_bytes text, struct hatch_style *style, struct hatch_err *err)
{
    struct reading r = {.style = *style};
    struct hatch_text rest = hatch_text_of(text), line;
    bool empty = true;
    for (uint32_t number = 1; hatch_settings_line(&rest, &line); number++) {
        if (read_line(line, &r, err) != HATCH_OK)
            return hatch_fail_at(err, "line %u: ", number);
        empty = empty && !has_words(line);
        if (check_ranges(&r.style, err) != HATCH_OK)
            return hatch_fail_at(err, "line %u: ", number);
    }
    if (empty)
        return hatch_fail(err, HATCH_BAD_INPUT, "empty: want at least one line with a key, such as 'width 2'");
    *style = r.style;
    return HATCH_OK;
}
