#include "render-gl/mode/rules.h"

#include <assert.h>
#include <stdio.h>

static bool draws_strokes(const struct technique *drawn)
{
    return drawn->features & TECHNIQUE_STROKES;
}

static bool has_curves(const struct technique *drawn)
{
    return drawn->curves != NULL;
}

static bool has_pattern(const struct technique *drawn)
{
    return draws_strokes(drawn) && has_curves(drawn);
}

bool rules_have_lines(const struct technique *drawn)
{
    return drawn->features & (TECHNIQUE_STROKES | TECHNIQUE_LINES);
}

static bool reads_asset(const struct technique *drawn)
{
    return technique_asset(drawn) != NULL;
}

static bool draws_looks(const struct technique *drawn)
{
    return drawn->features & TECHNIQUE_LOOKS;
}

/* Whether textures are filtered. */
static bool filters_asset(const struct technique *drawn)
{
    return drawn->asset != NULL;
}

static bool reads_six_columns(const struct technique *drawn)
{
    return drawn->asset == &asset_six_columns;
}

#define PAINT_OPTIONS "solid inks texture-color solid-turn"
#define LOOK_OPTIONS "look blend grain bands wobble dry wet edge-darkening paper-grain border " PAINT_OPTIONS
#define PICTURE_OPTIONS "tam samples show haloes uv-scale anisotropy window solid-size " LOOK_OPTIONS
#define PATTERN_OPTIONS "hatch-turn hatch-scale"
#define TONE_OPTIONS                                                                                                   \
    "tone-range tone-gamma light specular shadows exposure texture-tone modulate pixel-light shader-dir"

#define SEED_OPTIONS "seeds layers stroke stroke-ink stroke-turn seed-tile seed-layers fade fade-by overlap seed-loop"

/* Conditions "technique=A,B" for the techniques of each kind, written by make_rules. A window may change to any of
 * them, and --show draws without one. With --time and --probe, a name that ends in .tsv is that of a report. */
static char strokes[256], assets[256], filtered[256], six_columns[256], lined[320], timed[320], inked[320],
    scripted[320], patterned[320], patterned_script[320], textured[64], painted[64], painted_or_needs[64];

static const struct cmd_rule rules[] = {
    {"show", "!technique", NULL},
    {"tam uv-scale", assets, NULL},
    {"anisotropy", filtered, NULL},
    {"uv-scale", "tam|window", NULL},
    {SEED_OPTIONS, "!tam|window", "whose strokes are drawn instead"},
    {"tam hatch-turn hatch-scale anisotropy uv-scale", "!show|window", "that draws no strokes"},
    {"hatch-turn hatch-scale", strokes, NULL},
    {"solid-size " LOOK_OPTIONS, "!show", "which draws neither tone nor texture"},
    {"solid-size " LOOK_OPTIONS, "!probe", "which counts tones, and draws nothing"},
    {"blend border", textured, NULL},
    {PAINT_OPTIONS, painted, NULL},
    {"solid-size", painted_or_needs, NULL},
    {"bands wobble", "look=watercolor,collage", NULL},
    {"dry wet edge-darkening paper-grain", "look=watercolor", NULL},
    {"border", "look=collage", NULL},
    {"blend", "look=plain,binary,collage", NULL},
    {"grain texture-color", "look=plain,watercolor,collage", NULL},
    {"grain", painted, NULL},
    {"texture-color", "!inks", "give one of them"},
    {"texture-color", "!texture-tone", "which would darken the colours twice"},
    {"texture-color", "!modulate", "which would darken the colours twice"},
    {"probe", "!show tam", NULL},
    {"probe", six_columns, NULL},
    {"paper lines line-width line-color crease haloes pixel-light", "!probe", "which counts tones, and draws nothing"},
    {"line-width line-color crease", "lines!=none", NULL},
    {"line-width line-color crease", "lines|!show|window", "whose pictures have no lines"},
    {"line-width line-color crease", lined, NULL},
    {"line-width line-color crease", timed, NULL},
    {"exposure", "!light", "which replaces the scene's lights"},
    {"modulate", "!texture-tone", "give one of them"},
    {"turntable", "frames", NULL},
    {"animate", "!time !probe", NULL},
    {"needs", "!technique !tam !show !time !probe !window", NULL},
    {"samples lines line-width line-color crease haloes hatch-turn hatch-scale " LOOK_OPTIONS, "!needs",
     "which draws nothing"},
    {"tolerance", "needs", NULL},
    {"rate", "frames|window !turntable|animation|time-s", NULL},
    {"times", "!time !probe !needs !window output!=*.svg,*.tsv", NULL},
    {"draws", "times", NULL},
    {"json", "time|times|probe|needs", NULL},
    {"time", "!probe !window", NULL},
    {"probe", "!window", NULL},
    {"page margin pen hidden sort", "output=*.svg,*.tsv !time !probe !needs", "it shapes a drawing"},
    {"time probe needs " PICTURE_OPTIONS, "output!=*.svg", "a drawing consists of lines"},
    {PICTURE_OPTIONS, "output!=*.tsv|time|probe", "a drawing consists of lines"},
    {PATTERN_OPTIONS, patterned, "a drawing consists of lines"},
    {PATTERN_OPTIONS, patterned_script, "a drawing consists of lines"},
    {TONE_OPTIONS, inked, "a drawing without strokes has no tone"},
    {"paper " TONE_OPTIONS, scripted, "a stroke script of lines alone has neither paper nor tone"},
    {"hidden", "lines!=none", "it dashes feature lines"},
    {"margin", "page", "the page without it is as large as the picture"},
    {"pen", "!line-width", "give one of them"},
    {NULL, NULL, NULL},
};

/* Writes the condition that the technique is one of a kind.
 *   others  other conditions that suffice, each after a '|' */
static void make_condition(bool (*is_kind)(const struct technique *), const char *others, char *text, size_t bytes)
{
    size_t used = (size_t)snprintf(text, bytes, "technique=");
    const char *comma = "";
    for (size_t i = 0; techniques[i]; i++)
        if (is_kind(techniques[i]) && used < bytes) {
            used += (size_t)snprintf(text + used, bytes - used, "%s%s", comma, techniques[i]->name);
            comma = ",";
        }
    assert(used < bytes);
    snprintf(text + used, bytes - used, "%s", others);
}

const struct cmd_rule *rules_make(void)
{
    make_condition(draws_strokes, "|window", strokes, sizeof strokes);
    make_condition(reads_asset, "|window", assets, sizeof assets);
    make_condition(filters_asset, "|window", filtered, sizeof filtered);
    make_condition(reads_six_columns, "", six_columns, sizeof six_columns);
    make_condition(rules_have_lines, "|lines|window|output=*.svg,*.tsv", lined, sizeof lined);
    make_condition(rules_have_lines, "|lines|window|!time", timed, sizeof timed);
    make_condition(draws_looks, "|window", textured, sizeof textured);
    make_condition(draws_looks, "|look=watercolor|window", painted, sizeof painted);
    make_condition(draws_looks, "|look=watercolor|window|needs", painted_or_needs, sizeof painted_or_needs);
    make_condition(has_curves, "|output!=*.svg", inked, sizeof inked);
    make_condition(has_curves, "|output!=*.tsv|time|probe|needs", scripted, sizeof scripted);
    make_condition(has_pattern, "|output!=*.svg", patterned, sizeof patterned);
    make_condition(has_pattern, "|output!=*.tsv|time|probe", patterned_script, sizeof patterned_script);
    return rules;
}
