#include "render-gl/mode/options.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/color.h"
#include "render-gl/mode/needs/technique.h"
#include "render-gl/mode/parse_args.h"
#include "render-gl/mode/rules.h"
#include "render-gl/mode/show.h"

#define ROWS_MAX 96 /* rows of the option table, with one that ends it */

static struct options chosen = {
    .hatch_scale = 1,
    .tone_range = {0, 1},
    .tone_gamma = 1,
    .light_deg = {-40, 40},
    .line_px = 2,
    .from_deg = {30, 20},
    .fov_deg = 30,
    .zoom = 1,
    .specular = {0, 32},
    .anisotropy = 1,
    .crease_deg = 40,
    .rate = 24,
    .page = {.margin_mm = 10},
    .tolerance = 0.01,
};

/* Values of options in the form in which they are parsed; options_read converts them for struct options. */
static int technique, up = HATCH_UP_Y, hidden, sort, show = -1; /* -1: --show is not given */
static const char *paper = "white", *ink = "black", *line_color, *lines, *camera, *uv_scale = "auto";
static const char *page, *margin, *pen;
static double size[2] = {1280, 720};
static int64_t samples = 4, frames = 1, animation, timed_frames, draws = 3;
static bool samples_given, time_given, fov_given, frames_given, from_given, specular_given;

/* Words that options accept among others, for completions. */
static const char *const axes[] = {"x", "y", "z", NULL};                     /* in the order of enum hatch_up */
static const char *const hidden_choices[] = {"remove", "dash", NULL};        /* in the order of enum option_hidden */
static const char *const sort_choices[] = {"best", "nearest", "none", NULL}; /* in the order of enum option_sort */
static const char *const automatic[] = {"auto", NULL}, *const framed[] = {"frame", NULL};

/* Rows before and after the techniques' own options. */
static const struct cmd_option first[] = {
    {'t', "technique", CMD_CHOICE, 0, 0, "NAME", "drawing technique; the manual describes them (default tam)",
     &technique, NULL, NULL},
    {'T', "tam", CMD_TEXT, 0, 0, "FILE", "tonal art map, made by tamgen; or a texture of tamvol or tamthresh",
     &chosen.map_path, NULL, NULL},
    {0},
};

static const struct cmd_option rest[] = {
    {0, "size", CMD_WHOLES, 1, 65536, "WxH", "width and height of the picture in pixels (default 1280x720)", size, NULL,
     NULL},
    {0, "samples", CMD_INT, 1, 64, "N",
     "samples per pixel, a square number (default 4; more if the technique needs them)", &samples, NULL,
     &samples_given},
    {0, "hatch-turn", CMD_REAL, -360, 360, "DEGREES", "+turn the strokes on the surface, counter-clockwise (default 0)",
     &chosen.hatch_turn_deg, NULL, NULL},
    {0, "hatch-scale", CMD_REAL, 0.01, 100, "X", "+factor for the size of the strokes' pattern (default 1)",
     &chosen.hatch_scale, NULL, NULL},
    {0, "tone-range", CMD_PAIR, 0, 1, "LO:HI",
     "tones of lit and unlit parts, 0 paper to 1 ink (default 0:1, or up to the map's darkest)", chosen.tone_range,
     NULL, &chosen.tone_range_given},
    {0, "tone-gamma", CMD_REAL, 0.05, 20, "G", "+exponent of tone; over 1 lightens middle tones (default 1)",
     &chosen.tone_gamma, NULL, NULL},
    {0, "paper", CMD_TEXT, 0, 0, "COLOUR", "colour of the paper, a name or #rrggbb (default white)", &paper,
     hatch_color_names, NULL},
    {0, "ink", CMD_TEXT, 0, 0, "COLOUR[,COLOUR]",
     "colour of the strokes; a second one draws the lit parts (default black)", &ink, hatch_color_names, NULL},
    {0, "show", CMD_CHOICE, 0, 0, "WHAT", "draw patches or field (directions) instead of strokes", &show, NULL, NULL},
    {0, "light", CMD_PAIR, -180, 180, "AZ:EL",
     "replace the scene's lights with one, degrees from the camera (default if the scene has none: -40:40)",
     chosen.light_deg, NULL, &chosen.light_given},
    {0, "specular", CMD_PAIR, 0, 1000, "S:E", "+strength and exponent of highlights (default 0:32: none)",
     chosen.specular, NULL, &specular_given},
    {0, "shadows", CMD_REAL, 0.001, 0.5, "WIDTH",
     "+cast shadows; width of their soft edges in scene radii (default: none)", &chosen.shadow_edge, NULL,
     &chosen.shadows},
    {0, "ground", CMD_REAL, 0.1, 100, "R", "+add a ground plane; half its side in scene radii (default: none)",
     &chosen.ground, NULL, NULL},
    {0, "exposure", CMD_REAL, 0, 1e30, "E", "+factor for the scene's lights (default 0: automatic)", &chosen.exposure,
     NULL, NULL},
    {0, "texture-tone", CMD_FLAG, 0, 0, NULL, "let colours and textures of materials darken the tone",
     &chosen.base_tone, NULL, NULL},
    {0, "modulate", CMD_TEXT, 0, 0, "IMAGE", "+let an image over the texture coordinates darken the tone",
     &chosen.modulate_path, NULL, NULL},
    {0, "pixel-light", CMD_FLAG, 0, 0, NULL, "+compute light per pixel, not per vertex", &chosen.pixel_light, NULL,
     NULL},
    {0, "lines", CMD_TEXT, 0, 0, "WHAT",
     "feature lines: none, all, or some of silhouettes,creases,boundaries (default all)", &lines, line_kind_names,
     &chosen.lines_given},
    {0, "haloes", CMD_REAL, 0.5, 32, "PX", "+width of bare paper around nearer surfaces (default: none)",
     &chosen.halo_px, NULL, NULL},
    {0, "line-width", CMD_REAL, 0.1, 64, "PX", "+width of feature lines in pixels (default 2)", &chosen.line_px, NULL,
     NULL},
    {0, "line-color", CMD_TEXT, 0, 0, "COLOUR", "+colour of feature lines (default: that of the ink)", &line_color,
     hatch_color_names, NULL},
    {0, "crease", CMD_REAL, 0, 180, "DEGREES", "+edges where the surface turns by more are creases (default 40)",
     &chosen.crease_deg, NULL, NULL},
    {0, "uv-scale", CMD_TEXT, 0, 0, "N|auto", "+repeats of the map per unit of texture coordinates (default auto)",
     &uv_scale, automatic, NULL},
    {0, "up", CMD_CHOICE, 0, 0, "AXIS", "+axis of the scene's coordinates that points up: x, y or z (default y)", &up,
     axes, NULL},
    {0, "anisotropy", CMD_REAL, 1, 16, "N", "+anisotropic texture filtering by the driver (default 1: none)",
     &chosen.anisotropy, NULL, NULL},
    {0, "camera", CMD_TEXT, 0, 0, "WHICH",
     "a scene camera's number, 'frame' (fit the scene), or POSITION[:TARGET] as X,Y,Z", &camera, framed, NULL},
    {0, "from", CMD_PAIR, -360, 360, "AZ:EL", "frame the scene from this azimuth and elevation (default 30:20)",
     chosen.from_deg, NULL, &from_given},
    {0, "fov", CMD_REAL, 1, 170, "DEGREES", "+vertical field of view; the scene's cameras keep theirs (default 30)",
     &chosen.fov_deg, NULL, &fov_given},
    {0, "zoom", CMD_REAL, 1e-3, 0x1p40, "X", "+move X times nearer to the middle of the picture (default 1)",
     &chosen.zoom, NULL, NULL},
    {'n', "frames", CMD_INT, 1, 4096, "N", "draw N pictures, named like -o name%03d.png (default 1)", &frames, NULL,
     &frames_given},
    {0, "turntable", CMD_FLAG, 0, 0, NULL, "move the camera once around the scene over all frames", &chosen.turntable,
     NULL, NULL},
    {0, "animate", CMD_TEXTS, 0, 0, "PARAM=A..B", "change option --PARAM from A to B over the frames; repeatable",
     &chosen.animate, NULL, NULL},
    {0, "animation", CMD_INT, 0, 65535, "N", "+play animation N of the scene (default 0)", &animation, NULL,
     &chosen.animation_given},
    {0, "time-s", CMD_REAL, 0, 1e6, "SECONDS", "+time of the animation at the first frame (default 0)", &chosen.time_s,
     NULL, &time_given},
    {0, "rate", CMD_REAL, 0.001, 1000, "FPS", "+frames per second of the animation (default 24)", &chosen.rate, NULL,
     NULL},
    {0, "page", CMD_TEXT, 0, 0, "SIZE",
     "+page of an SVG drawing: a4, letter or WxH in mm (default: the picture's size)", &page, hatch_page_names, NULL},
    {0, "margin", CMD_TEXT, 0, 0, "LENGTH", "+margin of that page, in mm (default 10mm)", &margin, NULL, NULL},
    {0, "pen", CMD_TEXT, 0, 0, "LENGTH", "+width of the pen on the page, in mm (default: --line-width)", &pen, NULL,
     NULL},
    {0, "hidden", CMD_CHOICE, 0, 0, "HOW", "+remove hidden parts of lines, or dash them (default remove)", &hidden,
     hidden_choices, NULL},
    {0, "sort", CMD_CHOICE, 0, 0, "HOW", "+order of the drawing's paths: best, nearest or none (default best)", &sort,
     sort_choices, NULL},
    {0, "time", CMD_INT, 1, 10000, "N", "+print how long N frames take, instead of a picture", &timed_frames, NULL,
     NULL},
    {0, "times", CMD_TEXT, 0, 0, "FILE", "+also write how long each picture takes: the shortest of some draws (TSV)",
     &chosen.times_path, NULL, NULL},
    {0, "draws", CMD_INT, 1, 1000, "N", "+how often --times draws each picture again (default 3)", &draws, NULL, NULL},
    {0, "probe", CMD_FLAG, 0, 0, NULL, "+print which tones and mip levels the picture uses, not the picture",
     &chosen.probe, NULL, NULL},
    {0, "needs", CMD_FLAG, 0, 0, NULL, "+write what the views need of maps and strokes, not pictures", &chosen.needs,
     NULL, NULL},
    {0, "tolerance", CMD_REAL, 0.0001, 0.5, "TONE", "+mean difference of tone that --needs allows (default 0.01)",
     &chosen.tolerance, NULL, NULL},
    {'w', "window", CMD_FLAG, 0, 0, NULL, "show the scene in a window; press ? there for a list of its keys",
     &chosen.window, NULL, NULL},
    {0, "shader-dir", CMD_TEXT, 0, 0, "DIR", "+read the shaders from this folder (default: the built-in ones)",
     &chosen.shader_folder, NULL, NULL},
    {0},
};

static struct cmd_option table[ROWS_MAX];

static const char *const examples[] = {
    "meshgen teapot | render-gl - --tam ink.tam.exr -o teapot.png",
    "render-gl scene.glb -T ink.tam.exr --frames 48 --turntable -o turn%03d.png",
    NULL,
};

static struct cmd_program program = {
    .name = "render-gl",
    .operands = "[SCENE ...]",
    .summary = "draw a 3D scene with strokes",
    .examples = examples,
    .options = table,
    .operands_max = -1,
    .reports = true,
    .binary = true,
};

const struct cmd_option *options_find(const char *name)
{
    const struct cmd_option *option = table;
    while (strcmp(option->name, name) != 0)
        option++;
    return option;
}

bool options_is_given(const char *name)
{
    return *options_find(name)->given;
}

/* Appends rows to the table and returns their new number. A row without a `given` gets one. */
static size_t add_rows(const struct cmd_option *rows, size_t count)
{
    static bool given[ROWS_MAX];
    for (; rows && rows->name; rows++, count++) {
        assert(count + 1 < ROWS_MAX);
        table[count] = *rows;
        if (!rows->given)
            table[count].given = &given[count];
    }
    return count;
}

/* Joins the rows of the command and of all techniques into one table. */
static void make_table(void)
{
    static const char *names[TECHNIQUE_COUNT + 1], *shown[8];
    size_t count = add_rows(first, 0);
    for (size_t i = 0; techniques[i]; i++) {
        names[i] = techniques[i]->name;
        count = add_rows(techniques[i]->options, count);
    }
    count = add_rows(look_option_table, count);
    add_rows(rest, count);
    for (size_t i = 0; show_techniques[i]; i++)
        shown[i] = show_techniques[i]->name;
    ((struct cmd_option *)options_find("technique"))->choices = names;
    ((struct cmd_option *)options_find("show"))->choices = shown;
}

void options_read_view(struct options *options)
{
    struct hatch_view_choice *view = &options->view;
    bool frame = camera && strcmp(camera, "frame") == 0;
    *view = (struct hatch_view_choice){.kind = HATCH_VIEW_FIRST_CAMERA, .turntable = options->turntable};
    if (camera && !frame && !parse_whole(camera, 65535, &view->index) && !parse_camera_place(camera, view))
        cmd_usage("--camera %s: want a number, frame, or X,Y,Z[:X,Y,Z]", camera);
    if (camera && !frame && from_given)
        cmd_usage("--from cannot be combined with --camera %s, only with --camera frame", camera);
    if (view->kind == HATCH_VIEW_FIRST_CAMERA && camera && !frame && fov_given)
        cmd_usage("--fov cannot be combined with --camera %s: the scene's cameras have a field of view", camera);
    if (frame || from_given || (fov_given && !camera))
        view->kind = HATCH_VIEW_FRAMED;
    else if (camera && view->kind != HATCH_VIEW_EYE)
        view->kind = HATCH_VIEW_CAMERA;
}

static void read_colors(void)
{
    struct frame_inks *inks = &chosen.inks;
    size_t length = strcspn(ink, ",");
    const struct hatch_text ink_text = {ink, length};
    inks->two = ink[length] == ',';
    parse_color("paper", (struct hatch_text){paper, strlen(paper)}, inks->paper);
    parse_color("ink", ink_text, inks->ink);
    if (inks->two)
        parse_color("ink", (struct hatch_text){ink + length + 1, strlen(ink + length + 1)}, inks->light_ink);
    if (!inks->two && memcmp(inks->paper, inks->ink, sizeof inks->ink) == 0)
        cmd_warn(NULL, "ink and paper have the same colour: strokes are invisible");
    if (specular_given && chosen.specular[0] > 10)
        cmd_usage("--specular %g:%g: want a strength from 0 to 10", chosen.specular[0], chosen.specular[1]);
    chosen.line_kinds = parse_line_kinds(lines ? lines : "all");
    if (line_color)
        parse_color("line-color", (struct hatch_text){line_color, strlen(line_color)}, chosen.line_color);
    else
        parse_color("ink", ink_text, chosen.line_color);
}

static double read_uv_scale(void)
{
    double value;
    if (strcmp(uv_scale, "auto") == 0)
        return 0;
    if (!hatch_text_number((struct hatch_text){uv_scale, strlen(uv_scale)}, &value) || !(value > 0 && value <= 65536))
        cmd_usage("--uv-scale %s: want auto or a number over 0 and up to 65536", uv_scale);
    return value;
}

bool options_paint(const struct options *options)
{
    return look_options.kind == LOOK_WATERCOLOR && (options->window || technique_is_painted(options->technique));
}

bool options_draw_lines(const struct options *options, const struct technique *drawn)
{
    return options->line_kinds != HATCH_LINES_NONE &&
           (rules_have_lines(drawn) || options->lines_given || options->vectors);
}

/* Refuses options of techniques other than the chosen one, except with a window, which may switch to them; and those
 * of all techniques for a drawing without strokes. */
static void check_owners(void)
{
    for (size_t i = 0; techniques[i] && !chosen.window; i++)
        for (const struct cmd_option *row = techniques[i]->options; row && row->name; row++)
            if (options_is_given(row->name) && chosen.vectors && !chosen.technique->curves)
                cmd_usage("--%s cannot be combined with --output *.%s: a drawing has lines alone", row->name,
                          chosen.script ? "tsv" : "svg");
            else if (options_is_given(row->name) && !technique_has_option(chosen.technique, row->name))
                cmd_usage("--%s goes with --technique %s, not with %s", row->name, techniques[i]->name,
                          chosen.technique->name);
            else if (options_is_given(row->name) && chosen.vectors &&
                     technique_has_pen_for(chosen.technique, row->name))
                cmd_usage("--%s cannot be combined with --output *.%s: a drawing has the width of its --pen", row->name,
                          chosen.script ? "tsv" : "svg");
}

/* Writes the names of the techniques that have a feature, as in "a, b and c". */
static void list_features(uint32_t feature, char *text, size_t bytes)
{
    size_t left = 0, used = 0;
    for (size_t i = 0; techniques[i]; i++)
        left += (techniques[i]->features & feature) != 0;
    for (size_t i = 0; techniques[i]; i++)
        if (techniques[i]->features & feature && used < bytes) {
            left--;
            used += (size_t)snprintf(text + used, bytes - used, "%s%s", techniques[i]->name,
                                     left > 1    ? ", "
                                     : left == 1 ? " and "
                                                 : "");
        }
}

static void check_technique(void)
{
    const char *name = chosen.technique->name;
    char able[256];
    if (!chosen.vectors && !chosen.map_path && chosen.technique->asset)
        cmd_usage("technique %s needs %s: --tam FILE", name, chosen.technique->asset->name);
    if (chosen.pixel_light && !(chosen.technique->features & TECHNIQUE_PIXEL_LIGHT)) {
        list_features(TECHNIQUE_PIXEL_LIGHT, able, sizeof able);
        cmd_usage("--pixel-light goes with %s, not with %s", able, name);
    }
    if (!(chosen.technique->features & TECHNIQUE_LOOKS) && !chosen.window && look_options.kind != LOOK_PLAIN &&
        look_options.kind != LOOK_WATERCOLOR) {
        list_features(TECHNIQUE_LOOKS, able, sizeof able);
        cmd_usage("--look %s goes with %s; with %s, the look is plain or watercolor",
                  options_find("look")->choices[look_options.kind], able, name);
    }
    check_owners();
}

static void check_frames(const struct cmd_args *args)
{
    bool report = timed_frames || chosen.probe || chosen.needs;
    if (frames_given && !chosen.window && !report && !parse_has_frame(args->output))
        cmd_usage("--frames needs -o with one field for the frame number, like -o name%%03d.png; any other %% is "
                  "written twice");
    if (chosen.animate.count && frames < 2 && !chosen.window)
        cmd_usage("--animate needs --frames 2 or more, or --window");
}

static void read_size(void)
{
    if (!samples_given && chosen.technique->samples)
        samples = chosen.technique->samples;
    chosen.side = (uint32_t)lround(sqrt((double)samples));
    if ((int64_t)chosen.side * chosen.side != samples)
        cmd_usage("--samples %d: want 1, 4, 9, 16, 25, 36, 49 or 64", (int)samples);
    chosen.width = (uint32_t)size[0];
    chosen.height = (uint32_t)size[1];
}

static void read_page(void)
{
    struct hatch_page *made = &chosen.page;
    if (page && !hatch_page_find(page, size[0] / size[1], made))
        cmd_usage("--page %s: want a0 to a6, letter, legal, tabloid, or WxH in mm from %gx%g to %gx%g", page,
                  HATCH_PAGE_LEAST_MM, HATCH_PAGE_LEAST_MM, HATCH_PAGE_MOST_MM, HATCH_PAGE_MOST_MM);
    if (margin)
        made->margin_mm = parse_length("margin", margin, 0, HATCH_PAGE_MOST_MM);
    if (!page)
        made->margin_mm = 0;
    if (page && !(2 * made->margin_mm < fmin(made->width_mm, made->height_mm)))
        cmd_usage("--margin %gmm leaves nothing of a page of %g by %g mm", made->margin_mm, made->width_mm,
                  made->height_mm);
    if (pen)
        chosen.pen_mm = parse_length("pen", pen, 0.01, 100);
    chosen.hidden = (enum option_hidden)hidden;
    chosen.sort = (enum option_sort)sort;
}

struct options *options_read(int argc, char **argv, struct cmd_args *args)
{
    make_table();
    program.rules = rules_make();
    cmd_begin(&program, argc, argv, args);
    chosen.technique = chosen.needs ? &needs_technique : show >= 0 ? show_techniques[show] : techniques[technique];
    read_size();
    chosen.script = parse_has_ending(args->output, "tsv") && !timed_frames && !chosen.probe && !chosen.needs;
    chosen.vectors = chosen.script || parse_has_ending(args->output, "svg");
    read_page();
    check_technique();
    check_frames(args);
    chosen.scene_path = args->operand_count ? args->operands[0] : NULL;
    chosen.repeat = read_uv_scale();
    chosen.up = (enum hatch_up)up;
    chosen.frames = (uint32_t)frames;
    chosen.timed_frames = (uint32_t)timed_frames;
    chosen.draws = (uint32_t)draws;
    chosen.animation = (uint32_t)animation;
    chosen.animated = chosen.animation_given || time_given || (frames_given && !chosen.turntable) || chosen.window;
    read_colors();
    chosen.textures = (chosen.base_tone && !chosen.modulate_path) || look_options.colors;
    chosen.base_tone = chosen.base_tone || chosen.modulate_path;
    return &chosen;
}
