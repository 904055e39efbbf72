#define _GNU_SOURCE
#include "base/text.h"
#include "shared/private.h"

#include <getopt.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define OPTIONS_MAX 96
#define THREADS_MAX 256

/* Code that getopt_long returns for entry i of the table; larger than every letter. */
#define CODE_OF(i) (1000 + (int)(i))

struct table {
    struct cmd_option options[OPTIONS_MAX];
    bool given[OPTIONS_MAX]; /* per option: whether it is on the command line */
    size_t own, count;       /* the first own entries are the command's options, the others are the common options */
};

/* Values of the common options, copied to struct cmd_args after parsing. */
static struct {
    bool help, version, options_table, verbose, quiet, json;
    const char *output;
    int64_t threads; /* 0: one for each processor */
    int64_t seed;
    uint64_t max_memory;
} common;

static void add(struct table *table, struct cmd_option option)
{
    if (table->count == OPTIONS_MAX)
        abort();
    table->options[table->count++] = option;
}

static void make_table(const struct cmd_program *program, struct table *table)
{
    for (const struct cmd_option *own = program->options; own && own->name; own++)
        add(table, *own);
    table->own = table->count;
    add(table, (struct cmd_option){'o', "output", CMD_TEXT, 0, 0, "FILE", "output file (default: standard output)",
                                   &common.output, NULL, NULL});
    if (program->seeded)
        add(table, (struct cmd_option){'s', "seed", CMD_INT, 0, 0x1p53, "N", "random seed (default 1)", &common.seed,
                                       NULL, NULL});
    if (program->reports)
        add(table, (struct cmd_option){0, "json", CMD_FLAG, 0, 0, NULL, "report as JSON", &common.json, NULL, NULL});
    add(table, (struct cmd_option){'j', "threads", CMD_INT, 1, THREADS_MAX, "N",
                                   "number of threads (default: one for each processor)", &common.threads, NULL, NULL});
    add(table, (struct cmd_option){0, "max-memory", CMD_SIZE, 1 << 20, 0x1p53, "BYTES",
                                   "memory limit; K, M or G may follow the number (default 4G)", &common.max_memory,
                                   NULL, NULL});
    add(table, (struct cmd_option){'q', "quiet", CMD_FLAG, 0, 0, NULL, "print no warnings and no progress",
                                   &common.quiet, NULL, NULL});
    add(table, (struct cmd_option){'v', "verbose", CMD_FLAG, 0, 0, NULL, "print details on standard error",
                                   &common.verbose, NULL, NULL});
    add(table,
        (struct cmd_option){'h', "help", CMD_FLAG, 0, 0, NULL, "print the help and exit", &common.help, NULL, NULL});
    add(table, (struct cmd_option){'V', "version", CMD_FLAG, 0, 0, NULL, "print the version and exit", &common.version,
                                   NULL, NULL});
    /* This option is for scripts; --help, which is for people, does not list it. */
    add(table,
        (struct cmd_option){0, "options-table", CMD_FLAG, 0, 0, NULL,
                            "print all options as tab-separated values and exit", &common.options_table, NULL, NULL});
}

/* Writes the names of an option, such as "-o, --output FILE". */
static void print_names(const struct cmd_option *option, char *text, size_t size)
{
    char letter[8] = "    ";
    if (option->letter)
        snprintf(letter, sizeof letter, "-%c, ", option->letter);
    snprintf(text, size, "%s--%s%s%s", letter, option->name, option->metavariable ? " " : "",
             option->metavariable ? option->metavariable : "");
}

static void print_usage(const struct cmd_program *program)
{
    const char *form = program->operands;
    const char *lead = "usage:";
    do {
        int length = (int)strcspn(form, "\n");
        printf("%s %s [OPTION ...]%s%.*s\n", lead, program->name, length ? " " : "", length, form);
        form += length;
        lead = "      ";
    } while (*form++);
}

#define NAMES_COLUMNS 104 /* width of lines that list several options */

struct names_line {
    size_t used; /* columns */
};

static void print_in_line(struct names_line *line, const struct cmd_option *option)
{
    char names[64];
    print_names(option, names, sizeof names);
    const char *text = names + (option->letter ? 0 : 4);
    const char *gap = line->used == 0 ? "  " : line->used + 3 + strlen(text) > NAMES_COLUMNS ? "\n  " : "   ";
    line->used = (gap[0] == '\n' ? 0 : line->used) + strlen(gap) + strlen(text);
    printf("%s%s", gap, text);
}

/* Lists the options whose help begins with +, without that help. */
static void print_secondary(const struct table *table)
{
    struct names_line line = {0};
    for (size_t i = 0; i < table->own; i++) {
        if (table->options[i].help[0] != '+')
            continue;
        if (!line.used)
            printf("more options, see the manual:\n");
        print_in_line(&line, &table->options[i]);
    }
    if (line.used)
        printf("\n");
}

/* Lists the common options other than -o and -s, without their help, so that the whole help fits a screen; hatch(7)
 * describes them.
 *   flags  true: those that take no value; false: those that take one */
static void print_shared(const struct table *table, bool flags)
{
    struct names_line line = {0};
    for (size_t i = table->own; i < table->count; i++) {
        const struct cmd_option *option = &table->options[i];
        if (option->value == &common.output || option->value == &common.seed ||
            option->value == &common.options_table || (option->type == CMD_FLAG) != flags)
            continue;
        print_in_line(&line, option);
    }
    printf("\n");
}

static void print_options(const struct table *table)
{
    for (size_t i = 0; i < table->count; i++) {
        const struct cmd_option *option = &table->options[i];
        char names[64];
        print_names(option, names, sizeof names);
        bool own = i < table->own && option->help[0] != '+';
        if (own || option->value == &common.output || option->value == &common.seed)
            printf("  %-28s %s\n", names, option->help);
    }
    print_secondary(table);
    print_shared(table, false);
    print_shared(table, true);
}

static noreturn void print_help(const struct cmd_program *program, const struct table *table)
{
    print_usage(program);
    printf("%s\n\n", program->summary);
    print_options(table);
    printf("\nexamples:\n");
    for (const char *const *example = program->examples; example && *example; example++)
        printf("  %s\n", *example);
    cmd_close_stdout();
    exit(HATCH_OK);
}

/* Prints the default of an option. Prints nothing for flags, for repeatable options, and for values that mean "not
 * given": NULL, a choice below 0, or a number outside the range. */
static void print_default(const struct cmd_option *option)
{
    const double *pair = option->value;
    switch (option->type) {
    case CMD_FLAG:
    case CMD_TEXTS:
        break;
    case CMD_INT:
        if (cmd_in_range(option, (double)*(int64_t *)option->value))
            printf("%" PRId64, *(int64_t *)option->value);
        break;
    case CMD_REAL:
        if (cmd_in_range(option, *(double *)option->value))
            printf("%.17g", *(double *)option->value);
        break;
    case CMD_SIZE:
        printf("%" PRIu64, *(uint64_t *)option->value);
        break;
    case CMD_TEXT:
        printf("%s", *(const char **)option->value ? *(const char **)option->value : "");
        break;
    case CMD_CHOICE:
        printf("%s", *(int *)option->value < 0 ? "" : option->choices[*(int *)option->value]);
        break;
    case CMD_PAIR:
    case CMD_WHOLES:
        if (cmd_in_range(option, pair[0]) && cmd_in_range(option, pair[1]))
            printf("%.17g%c%.17g", pair[0], strchr(option->metavariable, ':') ? ':' : 'x', pair[1]);
        break;
    }
}

/* The first operand's name in messages and the table, such as "SHAPE". */
static void name_operand(const struct cmd_program *program, char name[32])
{
    snprintf(name, 32, "%.*s", (int)strcspn(program->operands, " "), program->operands);
}

/* Prints names, separated by commas. */
static void print_names_of(const char *const *names)
{
    for (int i = 0; names && names[i]; i++)
        printf("%s%s", i ? "," : "", names[i]);
}

static noreturn void print_table(const struct cmd_program *program, const struct table *table)
{
    char operand[32];
    static const char *const types[] = {"flag", "int", "real", "size", "text", "texts", "choice", "pair", "pair"};
    printf("letter\tname\ttype\tminimum\tmaximum\tmetavariable\tchoices\tscope\thelp\tdefault\tneeds\n");
    for (size_t i = 0; i < table->count; i++) {
        const struct cmd_option *option = &table->options[i];
        char letter[2] = {option->letter, 0};
        printf("%s\t%s\t%s\t%.17g\t%.17g\t%s\t", letter, option->name, types[option->type], option->minimum,
               option->maximum, option->metavariable ? option->metavariable : "");
        print_names_of(option->choices);
        printf("\t%s\t%s\t", i < table->own ? "own" : "common", option->help + (option->help[0] == '+'));
        print_default(option);
        printf("\t");
        cmd_print_needs(program->rules, option->name);
        printf("\n");
    }
    if (program->names) {
        name_operand(program, operand);
        printf("\t\toperand\t0\t0\t%s\t", operand);
        print_names_of(program->names);
        printf("\toperand\t\t\t\n");
    }
    cmd_close_stdout();
    exit(HATCH_OK);
}

static noreturn void print_version(const struct cmd_program *program)
{
    printf("%s (hatch) %s\n", program->name, HATCH_VERSION);
    cmd_close_stdout();
    exit(HATCH_OK);
}

/* Fills the tables of getopt_long. A leading '-' in letters makes it return operands in order and ignore
 * POSIXLY_CORRECT; ':' suppresses its messages. */
static void make_getopt_tables(const struct table *table, struct option *longs, char *letters)
{
    *letters++ = '-';
    *letters++ = ':';
    for (size_t i = 0; i < table->count; i++) {
        const struct cmd_option *option = &table->options[i];
        int argument = option->type == CMD_FLAG ? no_argument : required_argument;
        longs[i] = (struct option){option->name, argument, NULL, CODE_OF(i)};
        if (option->letter) {
            *letters++ = option->letter;
            if (argument == required_argument)
                *letters++ = ':';
        }
    }
    longs[table->count] = (struct option){0};
    *letters = 0;
}

static const struct cmd_option *option_of_code(const struct table *table, int code)
{
    for (size_t i = 0; i < table->count; i++)
        if (code == CODE_OF(i) || (code && code == table->options[i].letter))
            return &table->options[i];
    return NULL;
}

static noreturn void refuse_unknown(const struct table *table, const char *word)
{
    const struct cmd_option *option = option_of_code(table, optopt);
    if (option && option->type == CMD_FLAG)
        cmd_usage("--%s takes no value", option->name);
    if (optopt > 0 && optopt < CODE_OF(0))
        cmd_usage("unknown option -%c", optopt);
    const bool is_long = strncmp(word, "--", 2) == 0;
    const struct hatch_text name = {word + (is_long ? 2 : 0), strcspn(word, "=") - (is_long ? 2 : 0)};
    for (size_t i = 0; is_long && i < table->count; i++)
        if (hatch_text_is_near(name, table->options[i].name))
            cmd_usage("unknown option %s (is it --%s?)", word, table->options[i].name);
    cmd_usage("unknown option %s", word);
}

/* Rejects abbreviated names, which getopt_long accepts: a script that uses one would break when an option is added. */
static void refuse_abbreviation(const struct cmd_option *option, const char *word)
{
    size_t length = strcspn(word, "=");
    if (strncmp(word, "--", 2) == 0 && length != strlen(option->name) + 2)
        cmd_usage("unknown option %.*s (is it --%s?)", (int)length, word, option->name);
}

static void parse_words(struct table *table, int argc, char **argv, struct cmd_args *args)
{
    struct option longs[OPTIONS_MAX + 1];
    char letters[2 * OPTIONS_MAX + 3];
    make_getopt_tables(table, longs, letters);
    int code, begin;
    while (begin = optind, (code = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
        if (code == 1) {
            argv[args->operand_count++] = optarg;
            continue;
        }
        if (code == '?')
            refuse_unknown(table, argv[begin]);
        const struct cmd_option *option = option_of_code(table, code == ':' ? optopt : code);
        if (code >= CODE_OF(0) || (code == ':' && optopt >= CODE_OF(0)))
            refuse_abbreviation(option, argv[begin]);
        if (code == ':')
            cmd_usage("--%s needs a value: %s", option->name, option->metavariable);
        cmd_set_option(option, optarg);
        table->given[option - table->options] = true;
    }
    while (optind < argc)
        argv[args->operand_count++] = argv[optind++];
}

static void find_operand(const struct cmd_program *program, struct cmd_args *args)
{
    char name[32];
    name_operand(program, name);
    args->name = cmd_find_name(program->names, args->operands[0]);
    if (args->name < 0)
        cmd_refuse_name(name, args->operands[0], program->names, NULL);
}

void cmd_parse(const struct cmd_program *program, int argc, char **argv, struct cmd_args *args)
{
    static struct table table;
    table = (struct table){.count = 0};
    make_table(program, &table);
    common.seed = 1;
    common.max_memory = (uint64_t)4 << 30;
    *args = (struct cmd_args){.operands = argv};
    parse_words(&table, argc, argv, args);
    if (common.help)
        print_help(program, &table);
    if (common.version)
        print_version(program);
    if (common.options_table)
        print_table(program, &table);
    if (args->operand_count < program->operands_min)
        cmd_usage("too few operands, want %s", program->operands);
    if (program->operands_max >= 0 && args->operand_count > program->operands_max)
        cmd_usage("one operand too many: %s", args->operands[program->operands_max]);
    if (program->names)
        find_operand(program, args);
    const struct cmd_line line = {table.options, table.given, table.count,
                                  args->operand_count ? args->operands[0] : NULL};
    cmd_check_rules(program->rules, &line);
    args->output = common.output;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    if (common.threads == 0)
        common.threads = processors < 1 ? 1 : processors > THREADS_MAX ? THREADS_MAX : processors;
    args->threads = (uint32_t)common.threads;
    args->max_memory = common.max_memory;
    args->seed = (uint64_t)common.seed;
    args->json = common.json;
    args->verbose = common.verbose;
    args->quiet = common.quiet;
}
