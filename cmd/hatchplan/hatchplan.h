/* Private to hatchplan: what its files share. */
#ifndef HATCHPLAN_HATCHPLAN_H
#define HATCHPLAN_HATCHPLAN_H

#include "shared/child/child.h"
#include "plan/plan.h"

#define PLAN_SAMPLES_MAX 8
#define PLAN_SMALL 0.5 /* scale of small pictures */
#define PLAN_AXES 3    /* two parameters of a technique, and the samples per pixel */

/* Values of the options. */
struct plan_options {
    double size_px[2], from_deg[2], zoom, ground, tone_range[2], width_px, rate;
    bool from_given;
    int64_t frames, rounds;
    bool frames_given, turntable;
    const char *lines, *style, *draw, *techniques;
    uint32_t samples[PLAN_SAMPLES_MAX];
    uint32_t sample_count;
    bool exhaustive;
};

/* Files that candidates read, by the command that makes them. */
enum plan_kind {
    PLAN_NOTHING,
    PLAN_MAP,
    PLAN_VOLUME,
    PLAN_THRESHOLDS,
    PLAN_SOLID,
    PLAN_FIELD,
    PLAN_PATCHES,
    PLAN_STROKES
};

/* A file that the candidates share, made when the first of them needs it. */
struct plan_asset {
    enum plan_kind kind;
    double values[2]; /* parameters of the kind: see assets.c */
    uint32_t file;    /* index of the scene's file, for kinds that are made of one; else 0 */
    const char *path; /* absolute */
    uint64_t bytes;   /* of the file */
    double seconds;   /* processor time to make it and all that it is made of */
    enum plan_made { PLAN_UNMADE, PLAN_MADE, PLAN_FAILED } made;
};

/* One of the scene's files. */
struct plan_file {
    const char *path;
    uint64_t bytes;  /* with those of the files that it names, such as the buffers of a glTF */
    bool has_places; /* all of its meshes have texture coordinates */
};

/* A technique with its parameters, from few bytes and little work to much. */
struct plan_technique {
    const char *name;
    const char *after; /* name of the technique that suggests this one, if it is good itself; NULL: tried anyhow */
    enum plan_kind kind;
    bool needs_places; /* texture coordinates, of the scene or of patches */
    struct plan_axis {
        const char *name;      /* NULL: the technique has no such parameter */
        uint32_t count, first; /* of the values; index of the one that is tried first */
        double values[4];
    } axes[2];
};

#define PLAN_ROUNDS_MAX 16

struct plan_candidate {
    const struct plan_technique *technique;
    uint32_t at[PLAN_AXES];        /* indices of the values of its parameters */
    struct plan_candidate *parent; /* the neighbour from which it was reached; NULL: tried first */
    enum plan_state {
        PLAN_UNTRIED,
        PLAN_OUT,     /* it cannot be made or drawn */
        PLAN_OVER,    /* its files exceed a limit: bytes and setup_s are known, the other figures 0 */
        PLAN_LOOKED,  /* drawn in small pictures */
        PLAN_MEASURED /* drawn in pictures of the size that was asked for */
    } state;
    struct hatch_plan_figures figures;
    double grey;                      /* share of grey strokes */
    double round_ms[PLAN_ROUNDS_MAX]; /* times of the rounds in full size; figures.ms is their median */
    uint32_t round_count;
};

struct plan {
    struct cmd_args *args;
    const struct plan_options *options;
    struct hatch_plan_figures limits;
    struct hatch_arena kept;            /* what is known of the files, while args->keep is rewound */
    struct hatch_buffer inputs, stamps; /* words of shell and make, in kept: see plan_note_input */
    struct plan_file *files;            /* one per operand */
    uint32_t file_count;
    struct plan_asset *assets; /* asset_count entries, of ASSETS_MAX */
    uint32_t asset_count;
    struct plan_candidate *candidates;
    uint32_t candidate_count;
    uint32_t views;      /* pictures that each candidate is measured in */
    bool has_small;      /* whether small pictures are drawn first */
    double plain_ms;     /* time of a plain frame, without strokes, as in figures.ms */
    double scale[2];     /* factors from a time of render-gl to figures.ms: of pictures of full size, of small ones */
    const char *failure; /* last message of a command that failed; NULL: none */
    enum hatch_status failed; /* status of that command: HATCH_LIMIT, or HATCH_BAD_INPUT for all others */
};

/* Makes the list of all candidates. Dies with HATCH_USAGE for a name in --techniques that is none. */
void plan_list_candidates(struct plan *plan);

/* Returns whether a candidate is only tried if another technique, which is among the candidates, suggests it. */
bool plan_is_suggested(const struct plan *plan, const struct plan_candidate *candidate);

/* Returns whether a candidate is the first one of its technique that is tried. */
bool plan_is_first(const struct plan_candidate *candidate);

/* Returns the value of a parameter of a candidate. */
double plan_value(const struct plan *plan, const struct plan_candidate *candidate, uint32_t axis);

/* Returns the neighbour of a candidate whose parameter is the next one or the one before; NULL: there is none.
 *   step  1 or -1 */
struct plan_candidate *plan_neighbour(const struct plan *plan, const struct plan_candidate *candidate, uint32_t axis,
                                      int step);

/* Writes the parameters of a candidate as in "size 256, tones 6, 4 samples". */
void plan_describe(const struct plan *plan, const struct plan_candidate *candidate, char *text, size_t bytes);

/* Adds the options of render-gl for a candidate: the technique, its parameters and the samples. */
void plan_add_technique(const struct plan *plan, const struct plan_candidate *candidate, struct cmd_child_words *words);

/* Adds the options of render-gl that are the same for all candidates.
 *   views  number of pictures
 *   scale  of the size of the pictures, 1 or less */
void plan_add_view(const struct plan *plan, uint32_t views, double scale, struct cmd_child_words *words);

/* Returns whether a candidate reads patches in place of the scene's files. */
bool plan_needs_patches(const struct plan *plan, const struct plan_candidate *candidate);

/* Returns the asset of a kind and parameters, which need not be made yet. */
struct plan_asset *plan_find_asset(struct plan *plan, enum plan_kind kind, double first, double second, uint32_t file);

/* Returns the asset of which another one is made; NULL: it is made of a file of the scene, or of nothing. */
struct plan_asset *plan_source(struct plan *plan, const struct plan_asset *asset);

/* Adds the options of the command that makes an asset, without its input and output. */
void plan_add_recipe(const struct plan *plan, const struct plan_asset *asset, struct cmd_child_words *words);

/* Adds the options that all commands take. */
void plan_add_common(const struct plan *plan, struct cmd_child_words *words);

/* Returns whether the search goes on after a command has ended so: it has succeeded, the scene does not suit it, or it
 * has reached a limit of time, memory or size. */
bool plan_may_fail(const struct cmd_child_end *end);

/* Notes why a command has failed. */
void plan_note_failure(struct plan *plan, const char *command, const struct cmd_child_end *end);

/* Returns the name of the command that makes a kind of asset. */
const char *plan_command(enum plan_kind kind);

/* Makes the files of a candidate as far as they do not exist, and sets its bytes and set-up time. Returns false, and
 * marks the candidate, if a command cannot make one of them, or if a limit is exceeded. */
bool plan_make_files(struct plan *plan, struct plan_candidate *candidate);

/* Returns the asset that the candidate reads with --tam or --solid; NULL: none. */
struct plan_asset *plan_own_asset(struct plan *plan, const struct plan_candidate *candidate);

/* Returns the asset that the candidate draws in place of a file of the scene; NULL: that file itself. */
struct plan_asset *plan_scene_asset(struct plan *plan, const struct plan_candidate *candidate, uint32_t file);

/* Adds all options of render-gl for the pictures of a candidate, without the scene.
 *   candidate  NULL: the plain scene
 *   small, draws  as for plan_measure */
void plan_add_drawing(struct plan *plan, const struct plan_candidate *candidate, bool small, uint32_t draws,
                      struct cmd_child_words *words);

/* Dies with HATCH_USAGE for words of --draw that are no options, and for options of render-gl that plan_add_drawing
 * adds for one of the candidates: the table would tell of others than were drawn. */
void plan_check_draw(const struct plan *plan);

/* Draws the plain scene, without strokes: the reference of tones and times. Decides whether small pictures are drawn.
 * Dies on failure. */
void plan_measure_plain(struct plan *plan);

/* Draws the pictures of a candidate, whose files are made. The first pictures of each size determine its error; each
 * round of pictures of full size determines its time better. Marks the candidate as out if it cannot be drawn.
 *   small  whether small pictures are drawn; only if plan->has_small
 *   draws  how often each picture is timed */
void plan_measure(struct plan *plan, struct plan_candidate *candidate, bool small, uint32_t draws);

/* Measures candidates until the best within the limits is known; without limits, until the useful ones are. */
void plan_search(struct plan *plan);

/* Measures all candidates in full. */
void plan_search_all(struct plan *plan);

/* Returns, per candidate and in args->scratch, whether it is one of the useful ones of a state or a later one. */
bool *plan_mark_useful(const struct plan *plan, enum plan_state state);

/* Returns the best candidate within the limits; NULL: none. */
struct plan_candidate *plan_choice(const struct plan *plan);

/* Returns the candidate that comes nearest to the limits; NULL: none has been measured. */
struct plan_candidate *plan_nearest(const struct plan *plan);

/* Writes the table of the useful candidates, or of all that were measured.
 *   chosen  may be NULL */
void plan_report(const struct plan *plan, const struct plan_candidate *chosen, bool all, struct cmd_output *output);

/* Notes a file on which the plan depends, with its state: when it was changed, and its size. Names of what is no plain
 * file are passed over. */
void plan_note_input(struct plan *plan, const char *path);

/* Notes the files that are named by options: the style with its brush, and words of --draw. */
void plan_note_options(struct plan *plan);

/* Adds a word to a text, after a space, quoted for the shell and for make. */
void plan_add_word(struct hatch_buffer *text, const char *word);

/* Writes the choice as variables of make. */
void plan_write_make(struct plan *plan, const struct plan_candidate *chosen, struct cmd_output *output);

#endif
