#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "shared/private.h"

#define WORDS_MAX 384

/* One alternative of a condition. */
struct atom {
    struct hatch_text name; /* of an option, or of the operand that chooses what the command does, in capitals */
    struct hatch_text list; /* values, separated by commas; length 0: the condition is that the option is given */
    bool negated;
};

static struct hatch_text cut(struct hatch_text *rest, char separator)
{
    const char *end = memchr(rest->at, separator, rest->length);
    struct hatch_text part = {rest->at, end ? (size_t)(end - rest->at) : rest->length};
    size_t used = part.length + (end ? 1 : 0);
    *rest = (struct hatch_text){rest->at + used, rest->length - used};
    return part;
}

static struct atom atom_of(struct hatch_text text)
{
    struct atom atom = {.negated = text.at[0] == '!'};
    atom.list = (struct hatch_text){text.at + atom.negated, text.length - atom.negated};
    atom.name = cut(&atom.list, '=');
    if (atom.name.at[atom.name.length - 1] == '!') {
        atom.name.length--;
        atom.negated = true;
    }
    return atom;
}

static bool is_operand(const struct atom *atom)
{
    return isupper((unsigned char)atom->name.at[0]);
}

/* Returns the value of an option or operand as text; "" for one that has none. */
static const char *value_of(const struct atom *atom, const struct cmd_line *line)
{
    if (is_operand(atom))
        return line->operand ? line->operand : "";
    for (size_t i = 0; i < line->count; i++) {
        const struct cmd_option *option = &line->options[i];
        if (!hatch_text_is(atom->name, option->name))
            continue;
        if (option->type == CMD_CHOICE)
            return *(int *)option->value < 0 ? "" : option->choices[*(int *)option->value];
        if (option->type == CMD_TEXT)
            return *(const char **)option->value ? *(const char **)option->value : "";
    }
    return "";
}

static bool is_given(struct hatch_text name, const struct cmd_line *line)
{
    for (size_t i = 0; i < line->count; i++)
        if (line->given[i] && hatch_text_is(name, line->options[i].name))
            return true;
    return false;
}

/* Returns whether a value is a word of a condition, or ends as one that begins with '*' does. */
static bool matches(struct hatch_text word, const char *value)
{
    size_t length = strlen(value);
    if (!word.length || *word.at != '*')
        return hatch_text_is(word, value);
    if (length < --word.length)
        return false;
    for (size_t i = 0; i < word.length; i++)
        if (tolower((unsigned char)value[length - word.length + i]) != word.at[i + 1])
            return false;
    return true;
}

static bool holds(const struct atom *atom, const struct cmd_line *line)
{
    if (!atom->list.length)
        return is_given(atom->name, line) != atom->negated;
    struct hatch_text rest = atom->list;
    bool listed = false;
    while (rest.length)
        listed = matches(cut(&rest, ','), value_of(atom, line)) || listed;
    return listed != atom->negated;
}

/* Appends a list of values in words, as in "a, b and c".
 *   last  the last joint: " or " or " and " */
static void add_list(char *words, struct hatch_text list, const char *last)
{
    while (list.length) {
        size_t used = strlen(words);
        struct hatch_text one = cut(&list, ',');
        const char *joint = !list.length ? "" : memchr(list.at, ',', list.length) ? ", " : last;
        snprintf(words + used, WORDS_MAX - used, "%.*s%s", (int)one.length, one.at, joint);
    }
}

/* Appends an alternative in words, as in "--layout rgb or array". */
static void add_atom(char *words, const struct atom *atom, const char *joint)
{
    size_t used = strlen(words);
    snprintf(words + used, WORDS_MAX - used, "%s--%.*s%s", used ? joint : "", (int)atom->name.length, atom->name.at,
             atom->list.length ? " " : "");
    add_list(words, atom->list, " or ");
}

/* Returns the mark between a refusal and its reason, which may be a sentence or a clause on the option named last. */
static const char *before_reason(const char *reason)
{
    static const char *const pronouns[] = {"which ", "whose ", "that "};
    for (size_t i = 0; reason && i < sizeof pronouns / sizeof *pronouns; i++)
        if (strncmp(reason, pronouns[i], strlen(pronouns[i])) == 0)
            return ", ";
    return reason ? ": " : "";
}

/* Refuses an option because of a condition that does not hold. */
static noreturn void refuse(const struct hatch_text *option, struct hatch_text condition, const char *reason,
                            const struct cmd_line *line)
{
    char needed[WORDS_MAX] = "", opposed[WORDS_MAX] = "";
    const char *before = before_reason(reason), *why = reason ? reason : "";
    int length = (int)option->length;
    while (condition.length) {
        const struct atom atom = atom_of(cut(&condition, '|'));
        if (is_operand(&atom) && condition.length)
            continue; /* the other alternatives are what an option can do about it */
        if (is_operand(&atom)) {
            add_list(needed, atom.list, " and ");
            cmd_usage("%s: --%.*s is for %s", line->operand, length, option->at, needed);
        }
        add_atom(atom.negated ? opposed : needed, &atom, " or ");
    }
    if (opposed[0])
        cmd_usage("--%.*s cannot be combined with %s%s%s%s%s", length, option->at, opposed,
                  needed[0] ? " without " : "", needed, before, why);
    cmd_usage("--%.*s needs %s%s%s", length, option->at, needed, before, why);
}

static void check(struct hatch_text option, const struct cmd_rule *rule, const struct cmd_line *line)
{
    struct hatch_text conditions = {rule->needs, strlen(rule->needs)};
    while (conditions.length && is_given(option, line)) {
        struct hatch_text condition = cut(&conditions, ' '), alternatives = condition;
        bool any = false;
        while (alternatives.length) {
            const struct atom atom = atom_of(cut(&alternatives, '|'));
            any = holds(&atom, line) || any;
        }
        if (!any)
            refuse(&option, condition, rule->reason, line);
    }
}

/* The line and the rules that have been checked last. */
static struct cmd_line checked;
static const struct cmd_rule *checked_rules;

void cmd_check_rules(const struct cmd_rule *rules, const struct cmd_line *line)
{
    checked = *line;
    checked_rules = rules;
    for (; rules && rules->options; rules++) {
        struct hatch_text options = {rules->options, strlen(rules->options)};
        while (options.length)
            check(cut(&options, ' '), rules, line);
    }
}

void cmd_imply_option(const struct cmd_option *option)
{
    const struct cmd_line line = checked;
    for (size_t i = 0; i < line.count; i++)
        line.given[i] = line.given[i] || strcmp(line.options[i].name, option->name) == 0;
    cmd_check_rules(checked_rules, &line);
}

void cmd_print_needs(const struct cmd_rule *rules, const char *name)
{
    const char *gap = "";
    for (; rules && rules->options; rules++) {
        struct hatch_text options = {rules->options, strlen(rules->options)};
        while (options.length)
            if (hatch_text_is(cut(&options, ' '), name)) {
                printf("%s%s", gap, rules->needs);
                gap = " ";
            }
    }
}
