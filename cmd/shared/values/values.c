/* The values of options: parses the text on the command line, and refuses what is out of range. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "shared/private.h"

static noreturn void refuse(const struct cmd_option *option, const char *text, const char *want)
{
    cmd_usage("--%s: '%s' is not %s", option->name, text, want);
}

/* Tells the values that an option takes, such as "a whole number from 1 to 256". */
static noreturn void refuse_range(const struct cmd_option *option, const char *text)
{
    char want[128];
    const char *kind = option->type == CMD_INT    ? "a whole number"
                       : option->type == CMD_REAL ? "a number"
                       : option->type == CMD_SIZE ? "a size in bytes"
                       : option->type == CMD_PAIR ? "two numbers "
                                                  : "two whole numbers ";
    bool is_pair = option->type == CMD_PAIR || option->type == CMD_WHOLES;
    snprintf(want, sizeof want, "%s%s from %.16g to %.16g", kind, is_pair ? option->metavariable : "", option->minimum,
             option->maximum);
    refuse(option, text, want);
}

static bool parse_whole(const char *text, size_t length, int64_t *value)
{
    char copy[32];
    if (length == 0 || length >= sizeof copy || strspn(text, "0123456789+-") < length)
        return false;
    memcpy(copy, text, length);
    copy[length] = 0;
    char *end;
    errno = 0;
    *value = strtoll(copy, &end, 10);
    return *end == 0 && errno == 0;
}

bool cmd_in_range(const struct cmd_option *option, double value)
{
    bool whole = option->type != CMD_WHOLES || value == floor(value);
    return value >= option->minimum && value <= option->maximum && whole;
}

/* Doubles do not hold all whole numbers over 2^53: one more may be rounded to a limit. */
static bool whole_in_range(const struct cmd_option *option, int64_t value)
{
    bool limited = option->maximum < 0x1p63;
    return cmd_in_range(option, (double)value) && (!limited || value <= (int64_t)option->maximum);
}

static bool parse_size(const char *text, int64_t *value)
{
    size_t length = strlen(text);
    const char *suffixes = "KMG";
    const char *suffix = length ? strchr(suffixes, text[length - 1]) : NULL;
    int shift = suffix ? 10 * (int)(suffix - suffixes + 1) : 0;
    if (!parse_whole(text, length - (suffix ? 1 : 0), value) || *value < 0 || *value > INT64_MAX >> shift)
        return false;
    *value <<= shift;
    return true;
}

static bool parse_pair(const struct cmd_option *option, const char *text)
{
    const char separator[] = {strchr(option->metavariable, ':') ? ':' : 'x', '\0'};
    size_t first_length = strcspn(text, separator);
    if (!text[first_length])
        return false;
    const char *second = text + first_length + 1;
    double pair[2];
    if (!hatch_text_number((struct hatch_text){text, first_length}, &pair[0]) ||
        !hatch_text_number((struct hatch_text){second, strlen(second)}, &pair[1]) || !cmd_in_range(option, pair[0]) ||
        !cmd_in_range(option, pair[1]))
        return false;
    memcpy(option->value, pair, sizeof pair);
    return true;
}

static void add_text(const struct cmd_option *option, const char *text)
{
    struct cmd_texts *texts = option->value;
    if (texts->count == CMD_TEXTS_MAX)
        cmd_usage("--%s: given more than %d times", option->name, CMD_TEXTS_MAX);
    texts->at[texts->count++] = text;
}

static void parse_choice(const struct cmd_option *option, const char *text)
{
    char name[64];
    int found = cmd_find_name(option->choices, text);
    snprintf(name, sizeof name, "--%s", option->name);
    if (found < 0)
        cmd_refuse_name(name, text, option->choices, NULL);
    *(int *)option->value = found;
}

void cmd_set_option(const struct cmd_option *option, const char *text)
{
    int64_t whole = 0;
    double real = 0;
    switch (option->type) {
    case CMD_FLAG:
        *(bool *)option->value = true;
        break;
    case CMD_INT:
        if (!parse_whole(text, strlen(text), &whole) || !whole_in_range(option, whole))
            refuse_range(option, text);
        *(int64_t *)option->value = whole;
        break;
    case CMD_REAL:
        if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &real) || !cmd_in_range(option, real))
            refuse_range(option, text);
        *(double *)option->value = real;
        break;
    case CMD_SIZE:
        if (!parse_size(text, &whole) || !whole_in_range(option, whole))
            refuse_range(option, text);
        *(uint64_t *)option->value = (uint64_t)whole;
        break;
    case CMD_TEXT:
        if (!*text)
            refuse(option, text, "a name: it is empty");
        *(const char **)option->value = text;
        break;
    case CMD_TEXTS:
        add_text(option, text);
        break;
    case CMD_CHOICE:
        parse_choice(option, text);
        break;
    case CMD_PAIR:
    case CMD_WHOLES:
        if (!parse_pair(option, text))
            refuse_range(option, text);
        break;
    }
    if (option->given)
        *option->given = true;
}
