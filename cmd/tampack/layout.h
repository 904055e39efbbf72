/* The layouts of tampack: one line of the table each. */
#ifndef TAMPACK_LAYOUT_H
#define TAMPACK_LAYOUT_H

#include "shared/cmd.h"
#include "tam/tam.h"

/* What is packed, and how. */
struct pack_job {
    struct cmd_args *args;
    struct hatch_tam tam;
    bool ink_is_one;
    const char *comment; /* "seed 1", for PNG */
};

struct pack_layout {
    const char *name, *ending;
    const char *warning;                  /* which importers spoil it; NULL: none is known */
    bool keeps_ids, takes_ink, is_single; /* single: always one file */

    /* How many files, and what goes before the ending in the name of one, when there are several.
     */
    uint32_t (*count)(const struct hatch_tam *tam);
    void (*suffix)(const struct hatch_tam *tam, uint32_t index, char *suffix, size_t size);

    /* One file; several are encoded at once. What scratch holds afterwards is freed. */
    enum hatch_status (*encode)(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                struct hatch_buffer *file, struct hatch_err *err);
};

/* In the order of the option's choices. */
extern const struct pack_layout pack_layouts[];

/* The name of the file with that suffix, in args->keep: path is what -o says, a name or an existing
 * folder; input is where the map came from. */
const char *pack_file_name(struct cmd_args *args, const char *path, const char *input, const char *suffix,
                           const char *ending);

#endif
