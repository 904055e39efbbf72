/* Keeps a part of the strokes of a scene:
 *     keep_strokes share X IN OUT     the points with a threshold of at most X times the largest of their mesh
 *     keep_strokes levels N IN OUT    the first N levels
 * Standard output gets the number of strokes of IN and of OUT. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "io/glb/glb.h"
#include "shared/scene.h"

static struct cmd_args args;

/* Appends the parts of a curve whose thresholds are at most `most` to those of a set. Points stay where they are. */
static void cut_curve(const struct hatch_curves *from, const struct hatch_curve *curve, float most,
                      struct hatch_curves *to)
{
    const uint32_t end = curve->first + curve->count;
    for (uint32_t first = curve->first, last; first < end; first = last + 1) {
        last = first;
        while (last < end && from->points[last].threshold <= most)
            last++;
        if (last < first + 2)
            continue;
        to->curves[to->count++] = (struct hatch_curve){
            .first = to->point_count, .count = last - first, .id = curve->id, .free_ends = curve->free_ends};
        for (uint32_t i = first; i < last; i++)
            to->points[to->point_count++] = from->points[i];
    }
}

/* Keeps the points of the strokes of a mesh whose thresholds and levels are small enough. */
static void keep(double share, uint32_t levels, struct hatch_curves *curves)
{
    struct hatch_err err;
    struct hatch_curves kept = {.set_count = 0};
    float most = 0;
    for (uint32_t i = 0; i < curves->point_count; i++)
        most = fmaxf(most, curves->points[i].threshold);
    cmd_check(HATCH_ALLOC(&args.keep, &kept.sets, curves->set_count, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&args.keep, &kept.curves, curves->point_count, &err), NULL, &err);
    cmd_check(HATCH_ALLOC(&args.keep, &kept.points, curves->point_count, &err), NULL, &err);
    for (uint32_t s = 0; s < curves->set_count; s++) {
        struct hatch_curve_set set = curves->sets[s];
        const uint32_t first = set.first, count = set.level < levels ? set.count : 0;
        set.first = kept.count;
        for (uint32_t i = 0; i < count; i++)
            cut_curve(curves, &curves->curves[first + i], (float)share * most, &kept);
        set.count = kept.count - set.first;
        if (set.count)
            kept.sets[kept.set_count++] = set;
    }
    *curves = kept;
}

int main(int argc, char **argv)
{
    static const struct cmd_option options[] = {{0}};
    static const char *const examples[] = {"keep_strokes share 0.5 in.glb out.glb", NULL};
    static const struct cmd_program program = {
        .name = "keep_strokes",
        .operands = "share X IN OUT\nlevels N IN OUT",
        .summary = "keep a part of the strokes of a scene",
        .examples = examples,
        .options = options,
        .operands_min = 4,
        .operands_max = 4,
    };
    struct hatch_scene scene;
    struct hatch_err err;
    double number;
    cmd_begin(&program, argc, argv, &args);
    const bool by_level = strcmp(args.operands[0], "levels") == 0;
    const char *text = args.operands[1], *input = args.operands[2];
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &number) || !(number >= 0 && number <= 16))
        cmd_usage("'%s' is not a number from 0 to 16", text);
    struct cmd_output *output = cmd_open_output(args.operands[3], "glb", true);
    struct hatch_buffer glb = {.arena = &args.keep};
    uint32_t before = 0, after = 0;
    cmd_read_scene(&args, input, CMD_SCENE_AS_IS, &scene);
    for (uint32_t i = 0; i < scene.mesh_count; i++) {
        before += scene.meshes[i].curves.count;
        keep(by_level ? 1 : number, by_level ? (uint32_t)number : HATCH_CURVE_LEVELS_MAX, &scene.meshes[i].curves);
        after += scene.meshes[i].curves.count;
    }
    cmd_check(hatch_glb_write_scene(&scene, NULL, &args.scratch, &glb, &err), input, &err);
    cmd_write(output, glb.data, glb.size);
    printf("%u\t%u\n", before, after);
    return cmd_end(&args, HATCH_OK);
}
