#include "solid/style.h"

#include <math.h>
#include <string.h>

#include "base/settings.h"

#define ISOTROPIC_JITTER 0.5f /* least jitter of cells that hides the lattice of their points */

#define BIT(kind) (1u << HATCH_SOLID_##kind)
#define NOISE (BIT(PERLIN) | BIT(TURBULENCE) | BIT(MARBLE) | BIT(PAPER))
#define ALL ((1u << HATCH_SOLID_KINDS) - 2)

static const struct kind {
    const char *name;
    struct hatch_solid_style defaults; /* values of keys that its styles leave out */
} kinds[HATCH_SOLID_KINDS] = {
    [HATCH_SOLID_NO_KIND] = {.name = "none"},
    [HATCH_SOLID_PERLIN] = {.name = "perlin", .defaults = {.scale = 8, .octaves = 1, .gain = 0.5f}},
    [HATCH_SOLID_TURBULENCE] = {.name = "turbulence", .defaults = {.scale = 4, .octaves = 5, .gain = 0.5f}},
    [HATCH_SOLID_WOOD] = {.name = "wood",
                          .defaults = {.scale = 2, .rings = 12, .warp = 1.5f, .grain = 0.4f, .fibers = 48, .axis = 1}},
    [HATCH_SOLID_MARBLE] =
        {.name = "marble",
         .defaults = {.scale = 3, .octaves = 5, .gain = 0.5f, .veins = {2, 1, 0}, .warp = 1, .sharpness = 1}},
    [HATCH_SOLID_WORLEY] = {.name = "worley", .defaults = {.scale = 8, .jitter = 1}},
    [HATCH_SOLID_STIPPLE] = {.name = "stipple", .defaults = {.dots = 12, .vary = 0.2f}},
    [HATCH_SOLID_STROKES] = {.name = "strokes",
                             .defaults = {.length = 0.35f, .width = 0.03f, .density = 4, .grow = 0.1f, .jitter = 8}},
    [HATCH_SOLID_PAPER] = {.name = "paper", .defaults = {.scale = 24, .octaves = 2, .gain = 0.6f, .grain = 0.5f}},
    [HATCH_SOLID_CANVAS] = {.name = "canvas", .defaults = {.threads = 16, .vary = 0.2f}},
};

const char *hatch_solid_kind_name(enum hatch_solid_kind kind)
{
    return kinds[kind].name;
}

bool hatch_solid_equalizes(const struct hatch_solid_style *style)
{
    return style->equalize == HATCH_SOLID_EQUALIZE ||
           (style->equalize == HATCH_SOLID_EQUALIZE_GREY && style->color_count == 0);
}

bool hatch_solid_is_isotropic(const struct hatch_solid_style *style)
{
    return style->kind == HATCH_SOLID_PERLIN || style->kind == HATCH_SOLID_TURBULENCE ||
           (style->kind == HATCH_SOLID_WORLEY && style->jitter >= ISOTROPIC_JITTER) ||
           style->kind == HATCH_SOLID_STIPPLE || style->kind == HATCH_SOLID_PAPER ||
           (style->kind == HATCH_SOLID_STROKES && style->direction_count == 0);
}

/* State of the parser. */
struct reading {
    struct hatch_solid_style style;
    bool any;              /* a key has been read */
    bool colors_given;     /* the first "color" line replaces the colours */
    bool directions_given; /* the first "direction" line replaces the directions */
};

/* A key whose values are numbers. */
struct number_key {
    const char *name;
    uint32_t kinds; /* bits of the kinds that use it */
    uint32_t count; /* of values, which follow each other in the struct */
    double low, high;
    double multiple; /* values are multiples of this; 0: any number */
    size_t offset;   /* in struct hatch_solid_style */
    uint32_t texels; /* values count things along a side, each of which takes at least this many; 0: any value */
};

#define AT(field) offsetof(struct hatch_solid_style, field)
static const struct number_key number_keys[] = {
    {"contrast", ALL, 1, 0.1, 10, 0, AT(contrast), 0},
    {"scale", NOISE | BIT(WOOD) | BIT(WORLEY), 1, 1, 128, 1, AT(scale), 2},
    {"octaves", NOISE, 1, 1, 8, 1, AT(octaves), 0},
    {"gain", NOISE, 1, 0.1, 1, 0, AT(gain), 0},
    {"rings", BIT(WOOD), 1, 1, 64, 1, AT(rings), 2},
    {"veins", BIT(MARBLE), 3, -32, 32, 1, AT(veins), 4},
    {"warp", BIT(WOOD) | BIT(MARBLE), 1, 0, 16, 0, AT(warp), 0},
    {"grain", BIT(WOOD) | BIT(PAPER), 1, 0, 1, 0, AT(grain), 0},
    {"fibers", BIT(WOOD), 1, 4, 128, 1, AT(fibers), 1},
    {"sharpness", BIT(MARBLE), 1, 1, 16, 0, AT(sharpness), 0},
    {"jitter", BIT(WORLEY), 1, 0, 1, 0, AT(jitter), 0},
    {"jitter", BIT(STROKES), 1, 0, 90, 0, AT(jitter), 0},
    {"dots", BIT(STIPPLE), 1, 2, 64, 1, AT(dots), 2},
    {"vary", BIT(STIPPLE) | BIT(CANVAS), 1, 0, 1, 0, AT(vary), 0},
    {"length", BIT(STROKES), 1, 0.01, 0.75, 0, AT(length), 0},
    {"width", BIT(STROKES), 1, 0.005, 0.1, 0, AT(width), 0},
    {"density", BIT(STROKES), 1, 2, 16, 0, AT(density), 0},
    {"grow", BIT(STROKES), 1, 0.01, 1, 0, AT(grow), 0},
    {"threads", BIT(CANVAS), 1, 2, 128, 2, AT(threads), 4},
};
enum { NUMBER_KEYS = sizeof number_keys / sizeof *number_keys };

static enum hatch_status read_numbers(const struct number_key *key, struct hatch_text *rest, struct reading *r,
                                      struct hatch_err *err)
{
    for (uint32_t i = 0; i < key->count; i++) {
        double value;
        HATCH_TRY(hatch_settings_next(rest, key->name, key->low, key->high, &value, err));
        if (key->multiple > 0 && value != key->multiple * floor(value / key->multiple))
            return hatch_fail(err, HATCH_BAD_INPUT, "%s: %g, want %s", key->name, value,
                              key->multiple == 1 ? "a whole number" : "an even number");
        float stored = (float)value;
        memcpy((char *)&r->style + key->offset + i * sizeof stored, &stored, sizeof stored);
    }
    return HATCH_OK;
}

/* Finds the next word among names, which end with NULL.
 *   want  lists them in the message */
static enum hatch_status read_choice(struct hatch_text *rest, const char *key, const char *const *names,
                                     const char *want, uint32_t *choice, struct hatch_err *err)
{
    struct hatch_text word;
    if (!hatch_text_word(rest, &word))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s: a value is missing", key);
    for (uint32_t i = 0; names[i]; i++)
        if (hatch_text_is(word, names[i])) {
            *choice = i;
            return HATCH_OK;
        }
    return hatch_fail(err, HATCH_BAD_INPUT, "%s: '%.*s', want %s", key, hatch_settings_shown(word), word.at, want);
}

static enum hatch_status read_kind(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    const char *names[HATCH_SOLID_KINDS] = {NULL};
    uint32_t kind = 0;
    for (uint32_t i = 1; i < HATCH_SOLID_KINDS; i++)
        names[i - 1] = kinds[i].name;
    if (r->any)
        return hatch_fail(err, HATCH_BAD_INPUT, "kind: want it before all other keys, once");
    HATCH_TRY(read_choice(rest, "kind", names,
                          "perlin, turbulence, wood, marble, worley, stipple, strokes, paper or canvas", &kind, err));
    struct hatch_solid_style before = r->style;
    r->style = kinds[kind + 1].defaults;
    r->style.kind = (enum hatch_solid_kind)(kind + 1);
    r->style.contrast = 1;
    memcpy(r->style.name, before.name, sizeof before.name);
    return HATCH_OK;
}

static enum hatch_status read_equalize(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    static const char *const names[] = {"yes", "no", NULL};
    uint32_t choice = 0;
    HATCH_TRY(read_choice(rest, "equalize", names, "yes or no", &choice, err));
    r->style.equalize = choice == 0 ? HATCH_SOLID_EQUALIZE : HATCH_SOLID_EQUALIZE_NOT;
    return HATCH_OK;
}

static enum hatch_status read_axis(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    static const char *const names[] = {"x", "y", "z", NULL};
    return read_choice(rest, "axis", names, "x, y or z", &r->style.axis, err);
}

static enum hatch_status read_distance(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    static const char *const names[] = {"f1", "f2", "f2-f1", NULL};
    return read_choice(rest, "distance", names, "f1, f2 or f2-f1", &r->style.distance, err);
}

static enum hatch_status read_color(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    if (!r->colors_given)
        r->style.color_count = 0;
    r->colors_given = true;
    return hatch_ramp_read(rest, "value", r->style.colors, &r->style.color_count, err);
}

/* Parses "X Y Z [FROM TO]". */
static enum hatch_status read_direction(struct hatch_text *rest, struct reading *r, struct hatch_err *err)
{
    double numbers[5] = {0, 0, 0, 0, 1};
    struct hatch_text word;
    for (int i = 0; i < 3; i++)
        HATCH_TRY(hatch_settings_next(rest, "direction", -1, 1, &numbers[i], err));
    if (numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "direction: 0 0 0 has no direction");
    struct hatch_text ahead = *rest;
    for (int i = 3, end = hatch_text_word(&ahead, &word) ? 5 : 3; i < end; i++)
        HATCH_TRY(hatch_settings_next(rest, "direction", 0, 1, &numbers[i], err));
    if (!(numbers[3] < numbers[4]))
        return hatch_fail(err, HATCH_BAD_INPUT, "direction: the range from tone %g to tone %g is empty", numbers[3],
                          numbers[4]);
    if (!r->directions_given)
        r->style.direction_count = 0;
    r->directions_given = true;
    if (r->style.direction_count == HATCH_SOLID_DIRECTIONS_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "more than %u direction lines", HATCH_SOLID_DIRECTIONS_MAX);
    struct hatch_solid_direction *direction = &r->style.directions[r->style.direction_count++];
    for (int i = 0; i < 3; i++)
        direction->vector[i] = (float)numbers[i];
    direction->from = (float)numbers[3];
    direction->to = (float)numbers[4];
    return HATCH_OK;
}

/* Keys whose values are not just numbers. */
static const struct word_key {
    const char *name;
    uint32_t kinds;
    enum hatch_status (*read)(struct hatch_text *, struct reading *, struct hatch_err *);
} word_keys[] = {
    {"kind", ALL | 1, read_kind},
    {"equalize", ALL, read_equalize},
    {"color", ALL, read_color},
    {"axis", BIT(WOOD), read_axis},
    {"distance", BIT(WORLEY), read_distance},
    {"direction", BIT(STROKES), read_direction},
};
enum { WORD_KEYS = sizeof word_keys / sizeof *word_keys };

const char *hatch_solid_style_fit(struct hatch_solid_style *style, uint32_t size)
{
    const char *lowered = NULL;
    for (const struct number_key *key = number_keys; key < number_keys + NUMBER_KEYS; key++) {
        if (!key->texels || !(key->kinds & 1u << style->kind))
            continue;
        float *values = (float *)((char *)style + key->offset), most = (float)(size / key->texels);
        for (uint32_t i = 0; i < key->count; i++) {
            if (fabsf(values[i]) <= most)
                continue;
            values[i] = copysignf(most, values[i]);
            lowered = lowered ? lowered : key->name;
        }
    }
    return lowered;
}

static enum hatch_status fail_key(struct hatch_text key, const struct reading *r, struct hatch_err *err)
{
    const char *near = NULL;
    bool known = false;
    for (size_t i = 0; i < NUMBER_KEYS + WORD_KEYS; i++) {
        const char *name = i < NUMBER_KEYS ? number_keys[i].name : word_keys[i - NUMBER_KEYS].name;
        known |= hatch_text_is(key, name);
        near = hatch_text_is_near(key, name) ? name : near;
    }
    int shown = hatch_settings_shown(key);
    if (r->style.kind == HATCH_SOLID_NO_KIND)
        return hatch_fail(err, HATCH_BAD_INPUT, "'%.*s', want the kind first, such as 'kind wood'", shown, key.at);
    if (known)
        return hatch_fail(err, HATCH_BAD_INPUT, "%.*s: kind %s does not use it", shown, key.at,
                          kinds[r->style.kind].name);
    if (near)
        return hatch_fail(err, HATCH_BAD_INPUT, "no such key '%.*s', perhaps %s", shown, key.at, near);
    return hatch_fail(err, HATCH_BAD_INPUT, "no such key '%.*s'; solid(5) lists them", shown, key.at);
}

static enum hatch_status read_line(struct hatch_text line, struct reading *r, struct hatch_err *err)
{
    struct hatch_text key, extra;
    if (!hatch_text_word(&line, &key))
        return HATCH_OK;
    uint32_t kind = 1u << r->style.kind;
    const struct number_key *number = number_keys, *numbers_end = number_keys + NUMBER_KEYS;
    const struct word_key *word = word_keys, *words_end = word_keys + WORD_KEYS;
    while (number < numbers_end && !(hatch_text_is(key, number->name) && (number->kinds & kind)))
        number++;
    while (word < words_end && !(hatch_text_is(key, word->name) && (word->kinds & kind)))
        word++;
    if (number == numbers_end && word == words_end)
        return fail_key(key, r, err);
    if (number < numbers_end)
        HATCH_TRY(read_numbers(number, &line, r, err));
    else
        HATCH_TRY(word->read(&line, r, err));
    if (hatch_text_word(&line, &extra))
        return hatch_fail(err, HATCH_BAD_INPUT, "%.*s: too many values", (int)key.length, key.at);
    r->any = true;
    return HATCH_OK;
}

static enum hatch_status check(const struct reading *r, struct hatch_err *err)
{
    const float *veins = r->style.veins;
    if (!r->any)
        return hatch_fail(err, HATCH_BAD_INPUT, "empty: want at least one line with a key, such as 'kind wood'");
    if (r->style.contrast != 1 && hatch_solid_equalizes(&r->style))
        return hatch_fail(err, HATCH_BAD_INPUT, "contrast: equalized values do not use it, want 'equalize no'");
    if (r->style.kind == HATCH_SOLID_MARBLE && veins[0] == 0 && veins[1] == 0 && veins[2] == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "veins: 0 0 0 has no veins");
    return HATCH_OK;
}

enum hatch_status hatch_solid_style_parse(struct hatch_bytes text, struct hatch_solid_style *style,
                                          struct hatch_err *err)
{
    struct reading r = {.style = *style};
    struct hatch_text rest = hatch_text_of(text), line;
    for (uint32_t number = 1; hatch_settings_line(&rest, &line); number++)
        if (read_line(line, &r, err) != HATCH_OK)
            return hatch_fail_at(err, "line %u: ", number);
    HATCH_TRY(check(&r, err));
    *style = r.style;
    return HATCH_OK;
}
