#include <math.h>
#include <string.h>

#include "base/text.h"
#include "dirfield.h"
#include "math/vector.h"
#include "surface/nearest.h"

#define WEIGHT_MAX 1e6

enum { VERTEX, X, Y, Z, DX, DY, DZ, WEIGHT, KEYS };

static const char *const key_names[KEYS] = {"vertex", "x", "y", "z", "dx", "dy", "dz", "weight"};

/* column_of[key]: where a row has it, or -1. */
struct header {
    int column_of[KEYS];
    uint32_t columns;
};

/* The scene's points by the numbers of the file's vertices. */
struct places {
    struct dirfield_part *parts;
    uint32_t part_count;
    uint32_t **vertex_points; /* per part; NULL: by position */
};

static enum hatch_status parse_header(struct hatch_text line, struct header *header, struct hatch_err *err)
{
    struct hatch_text field;
    for (int k = 0; k < KEYS; k++)
        header->column_of[k] = -1;
    for (header->columns = 0; hatch_text_field(&line, &field); header->columns++) {
        int key = 0;
        while (key < KEYS && !hatch_text_is(field, key_names[key]))
            key++;
        if (key == KEYS || header->column_of[key] >= 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "header: '%.*s' %s", (int)(field.length < 40 ? field.length : 40),
                              field.at, key == KEYS ? "is no column of constraints" : "stands twice");
        header->column_of[key] = (int)header->columns;
    }
    bool by_vertex = header->column_of[VERTEX] >= 0;
    for (int k = 0; k < KEYS; k++) {
        bool wanted = k == VERTEX ? by_vertex : k > Z || !by_vertex;
        if (wanted != (header->column_of[k] >= 0))
            return hatch_fail(err, HATCH_BAD_INPUT, "header: %s '%s', want vertex, or x y z, and dx dy dz weight",
                              wanted ? "no" : "vertex and", key_names[k]);
    }
    return HATCH_OK;
}

static enum hatch_status parse_row(struct hatch_text line, const struct header *header, uint32_t row,
                                   double values[KEYS], struct hatch_err *err)
{
    struct hatch_text field;
    uint32_t column = 0;
    for (; hatch_text_field(&line, &field); column++)
        for (int k = 0; k < KEYS; k++)
            if (header->column_of[k] == (int)column && !hatch_text_number(field, &values[k]))
                return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s '%.*s' is not a number", row, key_names[k],
                                  (int)(field.length < 40 ? field.length : 40), field.at);
    if (column != header->columns)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %u %s, want %u", row, column,
                          cmd_plural(column, "field", "fields"), header->columns);
    if (!(values[WEIGHT] > 0 && values[WEIGHT] <= WEIGHT_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: weight %g, want over 0 and at most %g", row, values[WEIGHT],
                          WEIGHT_MAX);
    double length = hatch_vec_length(&values[DX]);
    if (!(length > 0 && isfinite(length)))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: the direction has no length", row);
    return HATCH_OK;
}

static enum hatch_status find_vertex(const struct places *places, double vertex, uint32_t row,
                                     struct dirfield_part **part, uint32_t *point, struct hatch_err *err)
{
    double first = 0;
    for (uint32_t i = 0; i < places->part_count; i++) {
        *part = &places->parts[i];
        double count = (*part)->mesh->file_vertices;
        if (vertex >= first && vertex < first + count && vertex == floor(vertex)) {
            *point = places->vertex_points[i][(size_t)(vertex - first)];
            if (*point == HATCH_NO_SIDE)
                return hatch_fail(err, HATCH_BAD_INPUT, "line %u: no face uses vertex %.0f", row, vertex);
            return HATCH_OK;
        }
        first += count;
    }
    return hatch_fail(err, HATCH_BAD_INPUT, "line %u: vertex %.10g, want a whole number from 0 to %.0f", row, vertex,
                      first - 1);
}

/* How far a position of the scene is from a part's nearest point, where a pose shows it. */
static double distance(const struct dirfield_part *part, const struct dirfield_pose *pose, const double position[3],
                       uint32_t *point)
{
    double offset[3], local[3], at[3], shown[3];
    hatch_vec_sub(position, pose->offset, offset);
    if (!dirfield_to_mesh(pose, offset, local))
        return INFINITY;
    *point = hatch_surface_nearest(part->surface, local);
    hatch_surface_position(part->surface, *point, at);
    dirfield_to_scene(pose, at, shown);
    return hatch_vec_distance(shown, position);
}

/* The nearest point of all that the scene shows; false when it shows none. */
static bool find_nearest(const struct places *places, const double position[3], struct dirfield_part **part,
                         const struct dirfield_pose **pose, uint32_t *point)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < places->part_count; i++)
        for (uint32_t k = 0; k < places->parts[i].pose_count; k++) {
            uint32_t candidate = 0;
            double length = distance(&places->parts[i], &places->parts[i].poses[k], position, &candidate);
            if (!(length < least))
                continue;
            least = length;
            *part = &places->parts[i];
            *pose = &places->parts[i].poses[k];
            *point = candidate;
        }
    return least < INFINITY;
}

/* Where two rows meet at one point, the later one counts: it stands later in the part's list. */
static enum hatch_status add(struct cmd_args *args, struct dirfield_part *part, struct dirfield_constraint constraint,
                             struct hatch_err *err)
{
    uint32_t count = part->constraint_count;
    if ((count & (count - 1)) == 0) { /* full: 0, 1, 2, 4, 8 ... */
        struct dirfield_constraint *grown =
            HATCH_NEW(&args->keep, struct dirfield_constraint, count ? 2 * (size_t)count : 1, err);
        if (!grown)
            return HATCH_LIMIT;
        if (count)
            memcpy(grown, part->constraints, count * sizeof *grown);
        part->constraints = grown;
    }
    part->constraints[part->constraint_count++] = constraint;
    return HATCH_OK;
}

static enum hatch_status place(struct cmd_args *args, const struct places *places, const double values[KEYS],
                               uint32_t row, struct hatch_err *err)
{
    struct dirfield_part *part = NULL;
    const struct dirfield_pose *pose = NULL;
    struct dirfield_constraint made = {.line = row, .weight = values[WEIGHT]};
    hatch_vec_copy(&values[DX], made.direction);
    if (places->vertex_points) {
        HATCH_TRY(find_vertex(places, values[VERTEX], row, &part, &made.point, err));
    } else {
        if (!find_nearest(places, &values[X], &part, &pose, &made.point))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: the scene shows no mesh", row);
        dirfield_to_mesh(pose, &values[DX], made.direction);
    }
    return add(args, part, made, err);
}

static enum hatch_status list_vertices(struct cmd_args *args, struct places *places, struct hatch_err *err)
{
    places->vertex_points = HATCH_NEW(&args->keep, uint32_t *, places->part_count, err);
    if (!places->vertex_points)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < places->part_count; i++) {
        struct dirfield_part *part = &places->parts[i];
        uint32_t vertices = part->mesh->mesh.vertex_count;
        uint32_t *points = HATCH_NEW(&args->keep, uint32_t, vertices, err);
        if (!points)
            return HATCH_LIMIT;
        hatch_surface_vertex_points(part->surface, vertices, points);
        places->vertex_points[i] = points;
    }
    return HATCH_OK;
}

static enum hatch_status parse(struct cmd_args *args, struct hatch_bytes text, struct places *places,
                               struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(text), line;
    struct header header = {.columns = 0};
    for (uint32_t row = 1; hatch_text_line(&rest, &line); row++) {
        double values[KEYS] = {0};
        if (line.length == 0 || line.at[0] == '#')
            continue;
        if (header.columns == 0) {
            HATCH_TRY(parse_header(line, &header, err));
            if (header.column_of[VERTEX] >= 0)
                HATCH_TRY(list_vertices(args, places, err));
            continue;
        }
        HATCH_TRY(parse_row(line, &header, row, values, err));
        HATCH_TRY(place(args, places, values, row, err));
    }
    return header.columns ? HATCH_OK : hatch_fail(err, HATCH_BAD_INPUT, "no header line");
}

void dirfield_read_constraints(struct cmd_args *args, const char *path, struct dirfield_part *parts, uint32_t count)
{
    struct hatch_err err;
    struct places places = {.parts = parts, .part_count = count};
    cmd_check(parse(args, cmd_read(args, path), &places, &err), cmd_input_name(path), &err);
}
