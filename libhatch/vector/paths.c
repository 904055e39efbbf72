#include "vector/paths.h"

#include <math.h>

struct hatch_vector_builder hatch_vector_builder_of(struct hatch_arena *arena)
{
    return (struct hatch_vector_builder){.paths = {.arena = arena}, .points = {.arena = arena}};
}

static uint32_t point_count(const struct hatch_vector_builder *builder)
{
    return (uint32_t)(builder->points.size / (2 * sizeof(double)));
}

static const double *point_at(const struct hatch_vector_builder *builder, uint32_t i)
{
    return (const double *)(const void *)builder->points.data + 2 * (size_t)i;
}

static bool is_same(const double a[2], const double b[2])
{
    return !(a[0] < b[0] || a[0] > b[0] || a[1] < b[1] || a[1] > b[1]);
}

void hatch_vector_begin(struct hatch_vector_builder *builder, const struct hatch_vector_path *like)
{
    builder->path = *like;
    builder->path.first = point_count(builder);
    builder->path.count = 0;
    builder->path.closed = false;
}

enum hatch_status hatch_vector_add(struct hatch_vector_builder *builder, const double at[2], struct hatch_err *err)
{
    uint32_t count = point_count(builder);
    if (count > builder->path.first && is_same(point_at(builder, count - 1), at))
        return HATCH_OK;
    if (count == UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "a drawing has over %u points", UINT32_MAX);
    return hatch_buffer_add(&builder->points, at, 2 * sizeof *at, err);
}

enum hatch_status hatch_vector_end(struct hatch_vector_builder *builder, bool closed, struct hatch_err *err)
{
    struct hatch_vector_path *path = &builder->path;
    path->count = point_count(builder) - path->first;
    if (!path->count)
        return HATCH_OK;
    if (closed && path->count > 1 &&
        is_same(point_at(builder, path->first), point_at(builder, path->first + path->count - 1))) {
        path->count--;
        builder->points.size -= 2 * sizeof(double);
    }
    path->closed = closed && path->count > 2;
    return hatch_buffer_add(&builder->paths, path, sizeof *path, err);
}

enum hatch_status hatch_vector_append(struct hatch_vector_builder *builder, const struct hatch_vector_paths *paths,
                                      struct hatch_err *err)
{
    for (uint32_t i = 0; i < paths->count; i++) {
        const struct hatch_vector_path *path = &paths->paths[i];
        hatch_vector_begin(builder, path);
        for (uint32_t k = 0; k < path->count; k++)
            HATCH_TRY(hatch_vector_add(builder, hatch_vector_point(paths, path, k), err));
        HATCH_TRY(hatch_vector_end(builder, path->closed, err));
    }
    return HATCH_OK;
}

struct hatch_vector_paths hatch_vector_built(const struct hatch_vector_builder *builder)
{
    return (struct hatch_vector_paths){.count = (uint32_t)(builder->paths.size / sizeof(struct hatch_vector_path)),
                                       .paths = (void *)builder->paths.data,
                                       .points = (void *)builder->points.data};
}

double hatch_vector_distance(const double a[2], const double b[2])
{
    double x = b[0] - a[0], y = b[1] - a[1];
    return sqrt(x * x + y * y);
}

double hatch_vector_distance_to(const double at[2], const double a[2], const double b[2])
{
    double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    double t = square > 0 ? ((at[0] - a[0]) * x + (at[1] - a[1]) * y) / square : 0;
    t = fmin(fmax(t, 0), 1);
    const double nearest[2] = {a[0] + t * x, a[1] + t * y};
    return hatch_vector_distance(at, nearest);
}

double hatch_vector_length(const struct hatch_vector_paths *paths, const struct hatch_vector_path *path)
{
    double length = 0;
    for (uint32_t i = 0; i < hatch_vector_segments(path); i++)
        length += hatch_vector_distance(hatch_vector_point(paths, path, i), hatch_vector_point(paths, path, i + 1));
    return length;
}
