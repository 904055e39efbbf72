#include "render-gl/options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "render-gl/words.h"

#define RADIANS (3.14159265358979324 / 180)
#define LAYER_TURN 25 /* degrees between layers of strokes that have one direction */
#define AMBIENT 0.05  /* light from everywhere, so that shadows hold some form */

/* What the table fills; options_read turns it into struct options. */
static int technique, show = -1; /* nothing */
static const char *map_path, *paper = "white", *ink = "black";
static const char *camera, *uv_scale = "auto", *shader_folder, *modulate;
static double range[2] = {0, 1}, gamma_exponent = 1, specular[2] = {0, 32};
static double exposure, light[2] = {-40, 40}, from[2] = {30, 20}, fov = 30, anisotropy = 1;
static double hatch_turn, hatch_scale = 1;
static double size[2] = {1280, 720}, time_s, rate = 24;
static int64_t samples = 4, frames = 1, animation, timed_frames;
static double shadow_edge, halo, ground;
static bool shadows_given, range_given, light_given, specular_given, base_tone, pixel_light, turntable, probe, window;
static const char *seeds, *layers_path, *drawing = "ink";
static double stroke[2] = {0, 0}, stroke_ink, stroke_turn, seed_tile, overlap = 0.3;
static double zoom = 1;
static int64_t seed_layers = HATCH_RPTAM_LAYERS_MAX;
static int fade, fade_by, seed_loop;
static struct cmd_texts changes;
static const char *lines, *line_color;
static double line_width = 2, crease = 40;
static bool show_given, technique_given, samples_given, time_given, animation_given, fov_given;
static bool frames_given, from_given, of_seeds;

static const char *const shown[] = {"patches", "field", NULL}; /* TECHNIQUE_PATCHES and the next */

static const char *const fades[] = {"even", "paper", "weighted", NULL}; /* enum hatch_fade_law */
static const char *const fades_by[] = {"opacity", "size", NULL};
static const char *const seed_loops[] = {"coverage", "brute", NULL};

static struct cmd_option table[] = {
    {'t', "technique", CMD_CHOICE, 0, 0, "NAME", "how tone becomes strokes (default tam)", &technique, NULL,
     &technique_given},
    {'T', "tam", CMD_TEXT, 0, 0, "FILE", "the tonal art map of tamgen, or what tamvol or tamthresh made of it",
     &map_path, NULL, NULL},
    {0, "seeds", CMD_TEXT, 0, 0, "FILE", "rptam: seed sets, as seedgen writes them (default: 4 of 64)", &seeds, NULL,
     &of_seeds},
    {0, "layers", CMD_TEXT, 0, 0, "FILE", "+rptam: strokes and tones of each layer, a line each", &layers_path, NULL,
     &of_seeds},
    {0, "style", CMD_TEXT, 0, 0, "STYLE", "rptam: the drawing style of the strokes (default ink)", &drawing, NULL,
     &of_seeds},
    {0, "stroke", CMD_PAIR, 0.5, 4096, "LxW", "+rptam: length and width in pixels (default: the style's)", stroke, NULL,
     &of_seeds},
    {0, "stroke-ink", CMD_REAL, 0.01, 1, "X", "+rptam: how dark a stroke is (default: the style's)", &stroke_ink, NULL,
     &of_seeds},
    {0, "stroke-turn", CMD_REAL, -360, 360, "DEGREES", "+rptam: turn the strokes about their middles (default 0)",
     &stroke_turn, NULL, &of_seeds},
    {0, "seed-tile", CMD_REAL, 8, 8192, "PX", "+rptam: side of a set's tile (default: to suit the strokes)", &seed_tile,
     NULL, &of_seeds},
    {0, "seed-layers", CMD_INT, 0, HATCH_RPTAM_LAYERS_MAX, "N", "+rptam: draw no more than the first N sets",
     &seed_layers, NULL, &of_seeds},
    {0, "fade", CMD_CHOICE, 0, 0, "LAW", "+rptam: even (default) or weighted, which keep the tone, or paper", &fade,
     fades, &of_seeds},
    {0, "fade-by", CMD_CHOICE, 0, 0, "WHAT", "+rptam: opacity (default) or size", &fade_by, fades_by, &of_seeds},
    {0, "overlap", CMD_REAL, 0, 1, "X", "+rptam: strokes fade together, 1, or one by one, 0 (default 0.3)", &overlap,
     NULL, &of_seeds},
    {0, "seed-loop", CMD_CHOICE, 0, 0, "HOW", "+rptam: coverage (default), or brute: every seed everywhere", &seed_loop,
     seed_loops, &of_seeds},
    {0, "size", CMD_PAIR, 1, 65536, "WxH", "the picture's size in pixels (default 1280x720)", size, NULL, NULL},
    {0, "samples", CMD_INT, 1, 64, "N", "shaded samples a pixel, a square number (default 4; tam-threshold 16)",
     &samples, NULL, &samples_given},
    {0, "tone-range", CMD_PAIR, 0, 1, "LO:HI",
     "darkness of the lit and of the unlit (default 0:1, or the map's darkest)", range, NULL, &range_given},
    {0, "tone-gamma", CMD_REAL, 0.05, 20, "G", "+exponent of the darkness (default 1)", &gamma_exponent, NULL, NULL},
    {0, "paper", CMD_TEXT, 0, 0, "COLOUR", "a name or #rrggbb (default white)", &paper, NULL, NULL},
    {0, "ink", CMD_TEXT, 0, 0, "COLOUR[,COLOUR]",
     "default black; lighter than the paper: for what is lit; two: for both", &ink, NULL, NULL},
    {0, "show", CMD_CHOICE, 0, 0, "WHAT", "instead of strokes: patches, or the direction field", &show, shown,
     &show_given},
    {0, "lines", CMD_TEXT, 0, 0, "WHAT", "none, all, or of silhouettes,creases,boundaries (default all; gouraud none)",
     &lines, NULL, NULL},
    {0, "haloes", CMD_REAL, 0.5, 32, "PX", "+paper beside what passes before something farther", &halo, NULL, NULL},
    {0, "line-width", CMD_REAL, 0.1, 64, "PX", "+of lines (default 2)", &line_width, NULL, NULL},
    {0, "line-color", CMD_TEXT, 0, 0, "COLOUR", "+of lines (default the ink's)", &line_color, NULL, NULL},
    {0, "crease", CMD_REAL, 0, 180, "DEGREES", "+edges that turn by more are creases (default 40)", &crease, NULL,
     NULL},
    {0, "light", CMD_PAIR, -180, 180, "AZ:EL", "one light, degrees from the camera, for the scene's (default -40:40)",
     light, NULL, &light_given},
    {0, "specular", CMD_PAIR, 0, 1000, "S:E", "+highlight: strength, exponent (default none)", specular, NULL,
     &specular_given},
    {0, "shadows", CMD_REAL, 0.001, 0.5, "WIDTH", "+cast shadows; their edges' width in the scene's radius",
     &shadow_edge, NULL, &shadows_given},
    {0, "ground", CMD_REAL, 0.1, 100, "R", "+a plane under the scene, R of its radii to each side", &ground, NULL,
     NULL},
    {0, "exposure", CMD_REAL, 0, 1e30, "E", "+factor for the scene's lights (default 0: chosen)", &exposure, NULL,
     NULL},
    {0, "texture-tone", CMD_FLAG, 0, 0, NULL, "the materials' colours and textures count as tone", &base_tone, NULL,
     NULL},
    {0, "modulate", CMD_TEXT, 0, 0, "IMAGE", "+the same of an image over the texture coordinates", &modulate, NULL,
     NULL},
    {0, "pixel-light", CMD_FLAG, 0, 0, NULL, "+light every pixel, not every vertex", &pixel_light, NULL, NULL},
    {0, "uv-scale", CMD_TEXT, 0, 0, "N|auto", "map tiles a unit of u and v (default auto)", &uv_scale, NULL, NULL},
    {0, "hatch-turn", CMD_REAL, -360, 360, "DEGREES", "turn the strokes on their surface (default 0)", &hatch_turn,
     NULL, NULL},
    {0, "hatch-scale", CMD_REAL, 0.01, 100, "X", "+size of the strokes' pattern (default 1)", &hatch_scale, NULL, NULL},
    {0, "anisotropy", CMD_REAL, 1, 16, "N", "+hardware anisotropic filtering (default 1: none)", &anisotropy, NULL,
     NULL},
    {0, "camera", CMD_TEXT, 0, 0, "WHICH", "the scene's camera N, frame, or X,Y,Z[:X,Y,Z]: from where, at what",
     &camera, NULL, NULL},
    {0, "from", CMD_PAIR, -360, 360, "AZ:EL", "framed: direction to the camera (default 30:20)", from, NULL,
     &from_given},
    {0, "fov", CMD_REAL, 1, 170, "DEGREES", "vertical field of view, but for the scene's cameras (default 30)", &fov,
     NULL, &fov_given},
    {0, "zoom", CMD_REAL, 1e-3, 0x1p40, "X", "+X times nearer to what the picture's middle shows", &zoom, NULL, NULL},
    {'n', "frames", CMD_INT, 1, 4096, "N", "pictures: -o name%03d.png", &frames, NULL, &frames_given},
    {0, "turntable", CMD_FLAG, 0, 0, NULL, "the frames go once around the scene", &turntable, NULL, NULL},
    {0, "animate", CMD_TEXTS, 0, 0, "PARAM=A..B", "an option's number changes over the frames; repeatable", &changes,
     NULL, NULL},
    {0, "animation", CMD_INT, 0, 65535, "N", "+play animation N (default 0 with --frames)", &animation, NULL,
     &animation_given},
    {0, "time-s", CMD_REAL, 0, 1e6, "SECONDS", "+the animation's time at the first frame", &time_s, NULL, &time_given},
    {0, "rate", CMD_REAL, 0.001, 1000, "FPS", "+frames a second (default 24)", &rate, NULL, NULL},
    {0, "time", CMD_INT, 1, 10000, "N", "draw N frames and print their times", &timed_frames, NULL, NULL},
    {0, "probe", CMD_FLAG, 0, 0, NULL, "print what the picture uses of map and scene", &probe, NULL, NULL},
    {'w', "window", CMD_FLAG, 0, 0, NULL, "show it in a window; ? there lists the keys", &window, NULL, NULL},
    {0, "shader-dir", CMD_TEXT, 0, 0, "DIR", "+read the shaders from there", &shader_folder, NULL, NULL},
    {0},
};

static const char *const examples[] = {
    "meshgen teapot | render-gl - --tam ink.tam.exr -o teapot.png",
    "render-gl scene.glb -T ink.tam.exr --frames 48 --turntable -o turn%03d.png",
    NULL,
};

static const struct cmd_program program = {
    .name = "render-gl",
    .operands = "[SCENE ...]",
    .summary = "draw a 3D scene with strokes",
    .examples = examples,
    .options = table,
    .operands_max = -1,
    .reports = true,
    .binary = true,
};

const struct cmd_option *options_table(void)
{
    return table;
}

static void read_view(struct hatch_view_choice *view)
{
    *view = (struct hatch_view_choice){.kind = HATCH_VIEW_FIRST_CAMERA,
                                       .azimuth_rad = from[0] * RADIANS,
                                       .elevation_rad = from[1] * RADIANS,
                                       .fov_rad = fov * RADIANS,
                                       .turns = turntable};
    bool frame = camera && strcmp(camera, "frame") == 0;
    if (camera && !frame && (from_given || !(words_whole(camera, 65535, &view->index) || words_place(camera, view))))
        cmd_usage("--camera %s: want a number, frame, or X,Y,Z[:X,Y,Z], the last three without --from", camera);
    if (frame || from_given || (fov_given && !camera))
        view->kind = HATCH_VIEW_FRAMED;
    else if (camera && view->kind != HATCH_VIEW_EYE)
        view->kind = HATCH_VIEW_CAMERA;
}

static void read_style(struct style *style)
{
    *style = (struct style){
        .inks = {.two = strchr(ink, ',') != NULL},
        .curve = {.low = range[0],
                  .high = range[1],
                  .gamma = gamma_exponent,
                  .ambient = AMBIENT,
                  .specular = specular[0],
                  .shininess = specular[1],
                  .exposure = exposure},
        .light = {.wanted = light_given, .azimuth_rad = light[0] * RADIANS, .elevation_rad = light[1] * RADIANS},
        .anisotropy = (float)anisotropy,
        .hatch_turn_rad = hatch_turn * RADIANS,
        .hatch_scale = hatch_scale,
        .base_tone = base_tone || modulate,
        .pixel_light = pixel_light,
        .shadows = shadows_given,
        .shadow_edge = shadow_edge,
        .halo_px = halo};
    size_t first = strcspn(ink, ",");
    words_color("paper", (struct hatch_text){paper, strlen(paper)}, style->inks.paper);
    words_color("ink", (struct hatch_text){ink, first}, style->inks.ink);
    if (style->inks.two)
        words_color("ink", (struct hatch_text){ink + first + 1, strlen(ink + first + 1)}, style->inks.light_ink);
    if (!style->inks.two && memcmp(style->inks.paper, style->inks.ink, sizeof style->inks.ink) == 0)
        cmd_warn(NULL, "ink and paper have the same colour: strokes will not be seen");
    if (specular_given && specular[0] > 10)
        cmd_usage("--specular %g:%g: strength outside 0 to 10", specular[0], specular[1]);
}

static void read_seed_choice(struct seed_choice *choice)
{
    *choice = (struct seed_choice){.path = seeds,
                                   .layers_path = layers_path,
                                   .drawing = drawing,
                                   .style = {.tile_px = seed_tile,
                                             .length_px = stroke[0],
                                             .width_px = stroke[1],
                                             .law = (enum hatch_fade_law)fade,
                                             .fade_size = fade_by == 1,
                                             .ink = stroke_ink,
                                             .overlap = overlap},
                                   .tile_given = seed_tile > 0,
                                   .turn_rad = LAYER_TURN * RADIANS,
                                   .stroke_turn_rad = stroke_turn * RADIANS,
                                   .layers = (double)seed_layers,
                                   .all = seed_loop == 1};
}

static void read_lines(struct line_style *style)
{
    *style = (struct line_style){.kinds = words_line_kinds(lines ? lines : "all"),
                                 .haloes = halo > 0,
                                 .asked = lines != NULL,
                                 .width_px = line_width,
                                 .crease_rad = crease * RADIANS};
    if (line_color)
        words_color("line-color", (struct hatch_text){line_color, strlen(line_color)}, style->color);
    else
        words_color("ink", (struct hatch_text){ink, strcspn(ink, ",")}, style->color);
}

static double read_uv_scale(void)
{
    if (strcmp(uv_scale, "auto") == 0)
        return 0;
    double value;
    if (!hatch_text_number((struct hatch_text){uv_scale, strlen(uv_scale)}, &value) || !(value > 0 && value <= 65536))
        cmd_usage("--uv-scale %s: want auto or a number over 0 and up to 65536", uv_scale);
    return value;
}

/* Techniques that draw no strokes draw lines only when they are asked to. */
static bool draws_lines(void)
{
    bool strokes = technique_draws_strokes(techniques[technique]);
    return words_line_kinds(lines ? lines : "all") != HATCH_LINES_NONE && (strokes || lines);
}

static void check_pixel_light(void)
{
    char names[256] = "";
    size_t used = 0;
    if (!pixel_light || techniques[technique]->pixel_light)
        return;
    for (uint32_t i = 0; i < TECHNIQUE_CHOICES && used < sizeof names; i++)
        if (techniques[i]->pixel_light)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s, ", techniques[i]->name);
    cmd_usage("--pixel-light goes with %snot with %s", names, techniques[technique]->name);
}

static void check_frames(const struct cmd_args *args)
{
    if (turntable && !frames_given)
        cmd_usage("--turntable needs --frames");
    if (frames_given && !window && !timed_frames && !probe && !words_have_place(args->output))
        cmd_usage("--frames needs -o with one place for the number, like -o name%%03d.png");
    if (changes.count && (timed_frames || probe || (frames < 2 && !window)))
        cmd_usage("--animate needs --frames 2 or more, or --window");
    if (args->json && !timed_frames && !probe)
        cmd_usage("--json is for --time and --probe");
    if ((timed_frames > 0) + probe + window > 1)
        cmd_usage("--time, --probe and --window exclude each other");
}

void options_read(int argc, char **argv, struct cmd_args *args, struct options *options)
{
    table[0].choices = technique_names();
    cmd_begin(&program, argc, argv, args);
    if (show_given && (technique_given || probe))
        cmd_usage("--show goes with neither --technique nor --probe");
    if (show_given)
        technique = (int)TECHNIQUE_PATCHES + show;
    if (!samples_given && techniques[technique]->samples)
        samples = techniques[technique]->samples;
    uint32_t side = (uint32_t)lround(sqrt((double)samples));
    if ((int64_t)side * side != samples)
        cmd_usage("--samples %d: want 1, 4, 9, 16, 25, 36, 49 or 64", (int)samples);
    if (size[0] != floor(size[0]) || size[1] != floor(size[1]))
        cmd_usage("--size %gx%g: want whole numbers", size[0], size[1]);
    if (!map_path && techniques[technique]->columns != COLUMNS_NONE)
        cmd_usage("technique %s needs %s: --tam FILE", techniques[technique]->name,
                  columns_name(techniques[technique]->columns));
    check_pixel_light();
    if (of_seeds && !techniques[technique]->seeds && !window)
        cmd_usage("--seeds, --style, --stroke and what else is for strokes at seeds go with --technique rptam, "
                  "not with %s",
                  techniques[technique]->name);
    if (modulate && base_tone)
        cmd_usage("--modulate takes the place of --texture-tone");
    if (probe && !map_path)
        cmd_usage("--probe needs a tonal art map: --tam FILE");
    check_frames(args);
    struct param_change moves[PARAMS_MAX];
    uint32_t move_count = params_read(&changes, techniques[technique], draws_lines(), moves);
    *options = (struct options){.technique = technique,
                                .map_path = map_path,
                                .scene_path = args->operand_count ? args->operands[0] : NULL,
                                .shader_folder = shader_folder,
                                .modulate_path = modulate,
                                .high_given = range_given,
                                .repeat = read_uv_scale(),
                                .width = (uint32_t)size[0],
                                .height = (uint32_t)size[1],
                                .side = side,
                                .frames = (uint32_t)frames,
                                .turntable = turntable,
                                .time_s = time_s,
                                .rate = rate,
                                .animated = animation_given || time_given || (frames_given && !turntable) || window,
                                .animation = (uint32_t)animation,
                                .animation_given = animation_given,
                                .timed_frames = (uint32_t)timed_frames,
                                .probe = probe,
                                .window = window,
                                .ground = ground,
                                .zoom = zoom,
                                .change_count = move_count};
    memcpy(options->changes, moves, sizeof moves);
    read_style(&options->style);
    read_seed_choice(&options->seeds);
    read_lines(&options->lines);
    read_view(&options->view);
}
