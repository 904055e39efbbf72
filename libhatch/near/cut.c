/* Cuts near faces into pieces, as vertices for the GPU. */
#include <string.h>

#include "near/subdivide.h"
#include "near/parts.h"

#define MARGIN 0.02 /* widening of the tile on each side, as a share of its width or height */
#define RATIO 2.0   /* largest length of a piece's edge, in multiples of its distance from the eye */

struct cutting {
    struct hatch_buffer *buffer;
    uint32_t corner[3]; /* vertices of the face being cut */
};

static enum hatch_status add_piece(void *context, const struct hatch_piece_corner *const corner[3],
                                   struct hatch_err *err)
{
    struct cutting *cutting = context;
    struct hatch_near_vertex vertices[3];
    struct hatch_pair origin[3];
    for (int axis = 0; axis < 3; axis++) {
        struct hatch_pair rest = hatch_piece_fixed(corner[0]->place[axis], vertices[0].origin[axis]);
        origin[axis] = hatch_pair_sub(corner[0]->place[axis], rest);
    }
    for (int i = 0; i < 3; i++) {
        struct hatch_near_vertex *vertex = &vertices[i];
        for (int k = 0; k < 3; k++) {
            vertex->position[k] = (float)corner[i]->at[k].high;
            vertex->weight[k] = (float)corner[i]->weight[k];
            vertex->corner[k] = cutting->corner[k];
            vertex->place[k] = (float)hatch_pair_sub(corner[i]->place[k], origin[k]).high;
        }
        if (i > 0)
            memcpy(vertex->origin, vertices[0].origin, sizeof vertex->origin);
    }
    return hatch_buffer_add(cutting->buffer, vertices, sizeof vertices, err);
}

/* Converts world coordinates to camera coordinates. */
static void set_position(const struct hatch_near_frame *frame, const double world[3], struct hatch_pair at[3])
{
    const struct hatch_view *view = frame->view;
    const double *axes[3] = {view->right, view->up, view->back};
    struct hatch_pair from[3];
    for (int k = 0; k < 3; k++) {
        const struct hatch_pair eye = {view->eye[k], view->eye_low[k]};
        from[k] = hatch_pair_sub(hatch_view_to_unit(&frame->scene->bounds, k, world[k]), eye);
    }
    for (int row = 0; row < 3; row++)
        at[row] = hatch_pair_dot(from, axes[row]);
}

/* Computes the texture coordinates as hatch_texcoord in the shader vertex.glsl does, in double-double precision. */
static void set_uv(const double turn[2], const float texcoord[2], const float repeat[2], struct hatch_pair uv[3])
{
    double tiles[2];
    for (int k = 0; k < 2; k++)
        tiles[k] = (double)texcoord[k] * (double)repeat[k];
    uv[0] = hatch_pair_sub(hatch_pair_product(turn[0], tiles[0]), hatch_pair_product(turn[1], tiles[1]));
    uv[1] = hatch_pair_add(hatch_pair_product(turn[1], tiles[0]), hatch_pair_product(turn[0], tiles[1]));
    uv[2] = hatch_pair_of(0);
}

/* Computes the place of a vertex in a solid texture.
 *   origin  of the mesh */
static void set_rest(const struct hatch_item_rest *rest, const double origin[3], const float position[3],
                     struct hatch_pair place[3])
{
    struct hatch_pair from[3];
    for (int k = 0; k < 3; k++)
        from[k] = hatch_pair_scale(hatch_pair_sum((double)position[k], -origin[k]), 1 / rest->unit);
    for (int k = 0; k < 3; k++)
        place[k] = hatch_pair_add(hatch_pair_dot(from, rest->axes[k]), hatch_pair_of(rest->offset[k]));
}

/* Returns the region that the tile shows, with a margin. */
static struct hatch_piece_view visible_region(const struct hatch_near_frame *frame)
{
    const struct hatch_view *view = frame->view;
    const struct hatch_tile *tile = frame->options->tile;
    struct hatch_piece_view picture = {.orthographic = view->orthographic, .near = view->near, .ratio = RATIO};
    double half[2] = {view->half_height * view->aspect, view->half_height};
    double begin[2] = {tile->x / tile->full_width, tile->y / tile->full_height};
    double size[2] = {tile->width / tile->full_width, tile->height / tile->full_height};
    for (int k = 0; k < 2; k++) {
        picture.low[k] = half[k] * (2 * (begin[k] - MARGIN * size[k]) - 1);
        picture.high[k] = half[k] * (2 * (begin[k] + (1 + MARGIN) * size[k]) - 1);
    }
    return picture;
}

enum hatch_status hatch_near_cut_faces(const struct hatch_near_frame *frame, const struct hatch_near_target *target,
                                       const struct hatch_near_choice *choice, struct hatch_buffer *buffer,
                                       struct hatch_err *err)
{
    static const float none[2] = {0, 0};
    const struct hatch_item *item = target->item;
    struct cutting cutting = {.buffer = buffer};
    const struct hatch_piece_view picture = visible_region(frame);
    const struct hatch_unit_mesh *mesh = &frame->scene->meshes[item->mesh];
    const float *texcoord = hatch_mesh_find(mesh->mesh, "TEXCOORD_0", 2);
    const float *position = hatch_mesh_find(mesh->mesh, "POSITION", 3);
    const struct hatch_item_rest rest = hatch_item_rest(frame->scene, (uint32_t)(item - frame->scene->items));
    for (uint32_t i = 0; i < choice->piece_count; i++) {
        struct hatch_piece_corner corner[3];
        for (size_t k = 0; k < 3; k++) {
            size_t vertex = cutting.corner[k] = hatch_near_corner(&target->faces, choice->piece_faces[i], k);
            set_position(frame, target->shape->positions + 3 * vertex, corner[k].at);
            if (frame->options->places == HATCH_NEAR_REST)
                set_rest(&rest, mesh->origin, position + 3 * vertex, corner[k].place);
            else
                set_uv(frame->options->turn, texcoord ? texcoord + 2 * vertex : none,
                       item->repeats ? item->repeats + 2 * vertex : item->repeat, corner[k].place);
            for (size_t j = 0; j < 3; j++)
                corner[k].weight[j] = j == k;
        }
        HATCH_TRY(hatch_pieces_cut(corner, &picture, add_piece, &cutting, err));
    }
    return HATCH_OK;
}
