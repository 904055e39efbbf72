/* The check of --draw, whose options render-gl gets beside those of hatchplan. */
#include "hatchplan/hatchplan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"

/* An option of render-gl, as --options-table lists it. */
struct known {
    char letter; /* '\0': none */
    struct hatch_text name;
    bool is_flag;
};

#define KNOWN_MAX 128

/* Options of render-gl. */
struct table {
    struct known at[KNOWN_MAX];
    uint32_t count;
};

static void read_table(const struct plan *plan, struct table *table)
{
    struct cmd_child_words words;
    struct cmd_child_end end;
    struct hatch_bytes file;
    struct hatch_err err;
    struct hatch_text line, letter, name, type;
    cmd_child_begin(&words, plan->args, "render-gl");
    cmd_child_add(&words, "--options-table");
    words.output = cmd_child_path(plan->args, "options.tsv");
    cmd_child_run(&words, INFINITY, &end);
    if (end.status != 0)
        cmd_child_die("render-gl", &end);
    cmd_check(cmd_try_read(&plan->args->keep, words.output, &file, &err), words.output, &err);
    struct hatch_text rest = hatch_text_of(file);
    hatch_text_line(&rest, &line); /* names of the columns */
    while (table->count < KNOWN_MAX && hatch_text_line(&rest, &line) && hatch_text_field(&line, &letter) &&
           hatch_text_field(&line, &name) && hatch_text_field(&line, &type))
        table->at[table->count++] =
            (struct known){letter.length ? letter.at[0] : '\0', name, hatch_text_is(type, "flag")};
}

static const struct known *find(const struct table *table, char letter, struct hatch_text name)
{
    for (uint32_t i = 0; i < table->count; i++) {
        const struct known *known = &table->at[i];
        if ((letter && known->letter == letter) ||
            (name.length && name.length == known->name.length && memcmp(name.at, known->name.at, name.length) == 0))
            return known;
    }
    return NULL;
}

/* Refuses an option that is among the words which render-gl gets anyway, or that makes it draw nothing. */
static void refuse_own(const struct known *option, const struct cmd_child_words *own)
{
    static const char *const idle[] = {"help", "version", "options-table"};
    char name[64], letter[3] = {'-', option->letter, '\0'};
    snprintf(name, sizeof name, "--%.*s", (int)option->name.length, option->name.at);
    for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
        if (hatch_text_is(option->name, idle[i]))
            cmd_usage("--draw: render-gl draws nothing with %s", name);
    for (uint32_t i = 1; i < own->count; i++)
        if (strcmp(own->at[i], name) == 0 || (option->letter && strcmp(own->at[i], letter) == 0))
            cmd_usage("--draw: hatchplan itself sets the option %s of render-gl", name);
}

/* Checks one word of options; returns the number of words that they take, with a value. An unknown option is left to
 * render-gl, which refuses it. */
static uint32_t check_word(const struct table *table, const char *word, const struct cmd_child_words *own)
{
    const struct hatch_text none = {word, 0};
    if (strcmp(word, "--") == 0)
        cmd_usage("--draw: -- ends the options of render-gl, after which scenes follow: want options alone");
    if (word[0] != '-' || !word[1])
        cmd_usage("--draw: '%s' is no option of render-gl: scenes are operands of hatchplan", word);
    if (word[1] == '-') {
        const struct known *option = find(table, '\0', (struct hatch_text){word + 2, strcspn(word + 2, "=")});
        if (option)
            refuse_own(option, own);
        return option && !option->is_flag && !strchr(word, '=') ? 2 : 1;
    }
    for (const char *letter = word + 1; *letter; letter++) {
        const struct known *option = find(table, *letter, none);
        if (option)
            refuse_own(option, own);
        if (option && !option->is_flag) /* its value is the rest of the word, or the next one */
            return letter[1] ? 1 : 2;
    }
    return 1;
}

void plan_check_draw(const struct plan *plan)
{
    struct plan_options options = *plan->options;
    struct plan copy = *plan; /* whose files are not made */
    struct cmd_child_words words, own;
    struct table table = {.count = 0};
    const struct hatch_arena_mark before = hatch_arena_mark(&plan->args->keep);
    cmd_child_begin(&words, plan->args, "render-gl");
    cmd_child_add_all(&words, "draw", options.draw);
    read_table(plan, &table);
    options.draw = NULL;
    copy.options = &options;
    const struct hatch_arena_mark mark = hatch_arena_mark(&plan->args->keep);
    for (uint32_t i = 0; i < plan->candidate_count; i++) {
        cmd_child_begin(&own, plan->args, "render-gl");
        plan_add_drawing(&copy, &plan->candidates[i], false, 1, &own);
        for (uint32_t at = 1; at < words.count;)
            at += check_word(&table, words.at[at], &own);
        copy.assets = NULL;
        copy.asset_count = 0;
        hatch_arena_rewind(&plan->args->keep, mark);
    }
    hatch_arena_rewind(&plan->args->keep, before);
}
