#include "shared/needs/needs.h"

void cmd_read_needs(struct cmd_args *args, const char *path, struct hatch_needs *needs)
{
    struct hatch_err err;
    cmd_check(hatch_needs_parse(cmd_read(args, path), NULL, needs, &err), cmd_input_name(path), &err);
}

void cmd_read_needs_and_regions(struct cmd_args *args, const char *path, struct hatch_needs *needs)
{
    struct hatch_err err;
    float *cells, *work;
    cmd_check(HATCH_ALLOC(&args->keep, &cells, HATCH_NEEDS_CELLS, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&args->keep, &work, HATCH_NEEDS_CELLS, &err), NULL, &err);
    cmd_check(hatch_needs_parse(cmd_read(args, path), cells, needs, &err), cmd_input_name(path), &err);
    hatch_needs_spread(&needs->regions, work);
}
