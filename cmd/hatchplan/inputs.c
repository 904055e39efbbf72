/* The files on which a plan depends: pipelines/plan.mk makes it anew when one of them has changed. */
#include "hatchplan/hatchplan.h"

#include <string.h>
#include <sys/stat.h>

#include "shared/style.h"

void plan_add_word(struct hatch_buffer *text, const char *word)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.,:/+=";
    struct hatch_err err;
    bool quoted = word[strspn(word, plain)] != '\0' || !*word;
    enum hatch_status status = hatch_buffer_print(text, &err, quoted ? " '" : " ");
    for (; status == HATCH_OK && *word; word++)
        status = *word == '\''  ? hatch_buffer_print(text, &err, "'\\''")
                 : *word == '$' ? hatch_buffer_print(text, &err, "$$")
                 : *word == '#' ? hatch_buffer_print(text, &err, "\\#")
                                : hatch_buffer_add(text, word, 1, &err);
    if (status == HATCH_OK && quoted)
        status = hatch_buffer_print(text, &err, "'");
    cmd_check(status, NULL, &err);
}

void plan_note_input(struct plan *plan, const char *path)
{
    struct stat info;
    struct hatch_err err;
    if (stat(path, &info) != 0 || !S_ISREG(info.st_mode))
        return;
    plan_add_word(&plan->inputs, path);
    cmd_check(hatch_buffer_print(&plan->stamps, &err, " %lld.%09ld:%lld", (long long)info.st_mtim.tv_sec,
                                 info.st_mtim.tv_nsec, (long long)info.st_size),
              NULL, &err);
}

/* Notes the file of a style, and its brush if that is a picture. An installed style does not change. */
static void note_style(struct plan *plan, const char *path)
{
    struct cmd_args *args = plan->args;
    struct hatch_bytes text;
    struct hatch_style style;
    struct hatch_err err;
    const struct hatch_arena_mark mark = hatch_arena_mark(&args->keep);
    hatch_style_default(&style);
    if (strcmp(path, "-") == 0 || cmd_has_style(args, path))
        return;
    plan_note_input(plan, path);
    if (cmd_try_read(&args->keep, path, &text, &err) == HATCH_OK && hatch_style_parse(text, &style, &err) == HATCH_OK &&
        style.brush == HATCH_BRUSH_IMAGE)
        plan_note_input(plan, cmd_path_beside(args, path, style.brush_file));
    hatch_arena_rewind(&args->keep, mark);
}

void plan_note_options(struct plan *plan)
{
    struct cmd_child_words words;
    cmd_child_begin(&words, plan->args, "render-gl");
    if (plan->options->draw)
        cmd_child_add_all(&words, "draw", plan->options->draw);
    for (uint32_t i = 1; i < words.count; i++) {
        const char *value = strchr(words.at[i], '='); /* of --modulate=earth.jpg */
        plan_note_input(plan, words.at[i][0] == '-' && value ? value + 1 : words.at[i]);
    }
    note_style(plan, plan->options->style);
}
