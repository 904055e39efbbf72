/* hatchstat: measures the files that the other commands make. */
#include <string.h>

#include "subject.h"

static struct stat_options values = {
    .max_difference = -1, .throws = 8, .share = 1, .samples = 100000, .size_px = {1280, 720}};

static const struct cmd_option options[] = {
    {'m', "max-difference", CMD_REAL, 0, 1e9, "X",
     "diff: exit 1 when the largest difference exceeds X, 0 .. 1e9 (default: no limit)", &values.max_difference, NULL,
     NULL},
    {0, "srgb", CMD_FLAG, 0, 0, NULL, "diff, frames, ink: measure sRGB values instead of linear light", &values.srgb,
     NULL, NULL},
    {'r', "strokes", CMD_TEXT, 0, 0, "FILE", "tam: the map's strokes, as tamgen --strokes wrote them", &values.strokes,
     NULL, NULL},
    {'S', "style", CMD_TEXT, 0, 0, "STYLE", "tam: style of the strokes (default: the one that the map names)",
     &values.style, NULL, NULL},
    {'e', "set", CMD_TEXTS, 0, 0, "LINES", "tam: the --set with which tamgen made the map", &values.settings, NULL,
     NULL},
    {'b', "brush", CMD_TEXT, 0, 0, "IMAGE", "tam: the --brush with which tamgen made the map", &values.brush, NULL,
     NULL},
    {0, "throws", CMD_INT, 1, 1000, "N", "tam, seeds: random placements to compare with, 1 .. 1000 (default 8)",
     &values.throws, NULL, NULL},
    {'c', "check", CMD_FLAG, 0, 0, NULL,
     "tam, lapped, seeds: exit 1 when a figure is outside its limit; see the manual", &values.check, NULL, NULL},
    {'R', "reference", CMD_TEXT, 0, 0, "FILE",
     "field: mesh with the true field; ink: picture to compare with; solid: picture whose look FILE should have; "
     "tones: the map from which FILE was made",
     &values.reference, NULL, NULL},
    {0, "patches", CMD_TEXT, 0, 0, "FILE", "ink: picture of the patches, whose borders strokes should cross",
     &values.patches, NULL, NULL},
    {0, "share", CMD_REAL, 0.001, 1, "X",
     "field: share of the points compared, most confident first, 0.001 .. 1 (default 1)", &values.share, NULL, NULL},
    {0, "samples", CMD_INT, 1, 1000000000, "N",
     "lapped, tones: number of samples (tones: per level), 1 .. 1e9 (default 100000)", &values.samples, NULL, NULL},
    {0, "size", CMD_WHOLES, 1, 8192, "WxH", "coarse: width and height of the pictures in pixels (default 1280x720)",
     values.size_px, NULL, NULL},
    {0},
};

static const struct cmd_rule rules[] = {
    {"max-difference", "SUBJECT=diff", NULL},
    {"srgb", "SUBJECT=diff,frames,ink", NULL},
    {"strokes", "SUBJECT=tam", NULL},
    {"style set brush", "SUBJECT=tam strokes", "they describe its strokes"},
    {"throws", "SUBJECT=tam,seeds SUBJECT=seeds|strokes", NULL},
    {"check", "SUBJECT=tam,lapped,seeds", NULL},
    {"reference", "SUBJECT=field,ink,solid,tones", NULL},
    {"patches", "SUBJECT=ink", NULL},
    {"share", "SUBJECT=field reference", NULL},
    {"samples", "SUBJECT=lapped,tones", NULL},
    {"size", "SUBJECT=coarse", NULL},
    {NULL, NULL, NULL},
};

static const char *const names[] = {"coarse", "diff",  "field", "frames", "ink",   "lapped",
                                    "mesh",   "seeds", "solid", "tam",    "tones", NULL};

/* In the order of names. */
static const struct subject {
    int files_min, files_max; /* files_max -1: any number */
    const char *want;         /* files_min and files_max in words, for messages */
    stat_measure measure;
} subjects[] = {
    {2, -1, "2 or more", stat_coarse}, {2, 2, "2", stat_diff},          {0, -1, "any number", stat_field},
    {2, -1, "2 or more", stat_frames}, {1, -1, "1 or more", stat_ink},  {0, 1, "1 at most", stat_lapped},
    {0, -1, "any number", stat_mesh},  {0, 1, "1 at most", stat_seeds}, {0, 1, "1 at most", stat_solid},
    {0, 1, "1 at most", stat_tam},     {0, 1, "1 at most", stat_tones},
};

static const char *const examples[] = {
    "hatchstat diff a.png b.png --max-difference 0.004",
    "hatchstat frames turn.*.png --json",
    "meshgen torus | hatchstat mesh",
    "dirfield model.glb | hatchstat field",
    "tamgen --strokes s.tsv -o ink.exr && hatchstat tam ink.exr -r s.tsv --check",
    NULL,
};

static const struct cmd_program program = {
    .name = "hatchstat",
    .operands = "SUBJECT [FILE ...]",
    .summary = "measure files; SUBJECT and its files are one of:\n"
               "  diff A B, frames A B ..., ink FILE ...      pictures\n"
               "  mesh FILE ..., field FILE ...               meshes and their direction fields\n"
               "  coarse FULL COARSE ...                      coarse meshes beside full ones\n"
               "  lapped FILE                                 lapped textures\n"
               "  tam FILE, tones FILE                        tam: tonal art maps; tones: volumes, threshold textures\n"
               "  seeds FILE                                  seed sets\n"
               "  solid FILE                                  solid textures",
    .examples = examples,
    .options = options,
    .rules = rules,
    .names = names,
    .operands_min = 1,
    .operands_max = -1,
    .reports = true,
};

int main(int argc, char **argv)
{
    struct cmd_args args;
    cmd_begin(&program, argc, argv, &args);
    const char *name = names[args.name];
    const struct subject *subject = &subjects[args.name];
    int files = args.operand_count - 1;
    if (files < subject->files_min || (subject->files_max >= 0 && files > subject->files_max))
        cmd_usage("%s: %d %s, want %s", name, files, cmd_plural((uint64_t)files, "file", "files"), subject->want);
    struct cmd_output *output = cmd_open_report(&args, args.output);
    return cmd_end(&args, subject->measure(&args, &values, output));
}
