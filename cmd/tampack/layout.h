/* The layouts of tampack: the ways to pack a map into files. */
#ifndef TAMPACK_LAYOUT_H
#define TAMPACK_LAYOUT_H

#include "shared/cmd.h"
#include "tam/tam.h"

struct pack_job {
    struct cmd_args *args;
    struct hatch_tam tam;
    bool ink_is_one;
    const char *comment; /* such as "seed 1", for PNG; NULL: none */
};

struct pack_layout {
    const char *name;
    const char *ending;  /* ending of file names, with the dot */
    const char *warning; /* message about importers that misread this layout; NULL: none is known */
    bool keeps_ids;
    bool is_single; /* always makes one file */

    /* Returns the number of files that a map is packed into. */
    uint32_t (*count)(const struct hatch_tam *tam);
    /* Writes the suffix of the name of file index, such as ".003"; it stands before the ending. */
    void (*suffix)(const struct hatch_tam *tam, uint32_t index, char *suffix, size_t size);

    /* Encodes one file; called on several threads at once. scratch is freed afterwards. */
    enum hatch_status (*encode)(const struct pack_job *job, uint32_t index, struct hatch_arena *scratch,
                                struct hatch_buffer *file, struct hatch_err *err);
};

/* All layouts, in the order of the choices of --layout. */
extern const struct pack_layout pack_layouts[];

#endif
