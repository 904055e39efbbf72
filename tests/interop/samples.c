/* samples FOLDER: writes sample files of every format and, for images, NAME.raw with the texels that another
 * program must read: level after level; of EXR files part after part, as floats, channels in the order of
 * NAME.channels. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "io/texture/container.h"
#include "io/exr/exr.h"
#include "io/glb/glb.h"
#include "io/png/png.h"
#include "shapes/shapes.h"

static struct hatch_arena arena, scratch;
static struct hatch_err err;

static void check(enum hatch_status status)
{
    if (status == HATCH_OK)
        return;
    fprintf(stderr, "samples: %s\n", err.text);
    exit((int)status);
}

static void save(const char *folder, const char *name, const char *extension, const void *data, size_t size)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s%s", folder, name, extension);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file) != 0) {
        fprintf(stderr, "samples: cannot write %s\n", path);
        exit(HATCH_IO);
    }
}

static const struct {
    const char *name;
    struct hatch_texels texels;
    bool dds;
} textures[] = {
    {"rgba", {.width = 64, .height = 64, .channels = 4, .level_count = 7}, true},
    {"rgb-odd", {.width = 37, .height = 11, .channels = 3, .level_count = 6}, false},
    {"r-array", {.width = 16, .height = 16, .layers = 6, .channels = 1, .level_count = 5}, true},
    {"rg-one", {.width = 9, .height = 7, .layers = 1, .channels = 2, .level_count = 3}, true},
    {"rgba-array", {.width = 8, .height = 8, .layers = 3, .channels = 4, .level_count = 4}, true},
    {"rgba-volume", {.width = 8, .height = 4, .depth = 19, .channels = 4, .level_count = 5}, true},
    {"bc1-array",
     {.width = 37, .height = 11, .layers = 3, .channels = 3, .level_count = 6, .code = HATCH_TEXELS_BC1},
     false},
    {"bc4-array",
     {.width = 37, .height = 11, .layers = 3, .channels = 1, .level_count = 6, .code = HATCH_TEXELS_BC4},
     false},
    {"bc7-volume",
     {.width = 16, .height = 8, .depth = 6, .channels = 4, .level_count = 5, .code = HATCH_TEXELS_BC7},
     false},
    {"words", {.width = 33, .height = 5, .channels = 1, .level_count = 1, .code = HATCH_TEXELS_R32UI}, false},
};

static void save_textures(const char *folder)
{
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++) {
        struct hatch_texels texture = textures[i].texels;
        struct hatch_buffer raw = {.arena = &arena}, file = {.arena = &arena}, dds = file;
        check(hatch_texels_make(&arena, &texture, &err));
        for (uint32_t level = 0; level < texture.level_count; level++) {
            size_t size = hatch_texels_level_size(&texture, level);
            for (size_t at = 0; at < size; at++)
                texture.texels[level][at] = (uint8_t)hatch_random_u64(i, level, at);
            check(hatch_buffer_add(&raw, texture.texels[level], size, &err));
        }
        check(hatch_ktx2_write(&texture, NULL, &file, &err));
        save(folder, textures[i].name, ".ktx2", file.data, file.size);
        save(folder, textures[i].name, ".ktx2.raw", raw.data, raw.size);
        if (!textures[i].dds)
            continue;
        check(hatch_dds_write(&texture, &dds, &err));
        save(folder, textures[i].name, ".dds", dds.data, dds.size);
        save(folder, textures[i].name, ".dds.raw", raw.data, raw.size);
    }
}

static const struct {
    const char *name, *letters, *channels;
    uint32_t width, height, parts;
    bool mips;
} pictures[] = {
    {"grey", "Y", "Y", 256, 256, 6, true},         {"grey-odd", "Y", "Y", 517, 300, 2, true},
    {"ids", "Yit", "Y id t", 300, 300, 3, true},   {"colour", "RGB", "R G B", 77, 130, 2, true},
    {"flat", "RGBA", "R G B A", 45, 33, 1, false}, {"dot", "Y", "Y", 1, 1, 2, true},
};

/* A random value of the channel's type; some halves are equal. */
static float texel(const struct hatch_channel *channel, uint64_t stream, uint64_t index)
{
    uint64_t bits = hatch_random_u64(77, stream, index);
    if (channel->type == HATCH_UINT)
        return (float)(bits % 16777217u);
    if (channel->type == HATCH_FLOAT)
        return (float)((double)bits * 0x1p-64);
    return index % 7 < 3 ? 1 : hatch_float_from_half((uint16_t)(bits & 0xbfff));
}

static void fill_part(size_t kind, uint32_t part, struct hatch_mipmap *mipmap, struct hatch_buffer *raw)
{
    uint32_t width = pictures[kind].width, height = pictures[kind].height;
    mipmap->level_count = pictures[kind].mips ? hatch_mip_chain_length(width, height) : 1;
    for (uint32_t l = 0; l < mipmap->level_count; l++) {
        struct hatch_image *level = &mipmap->levels[l];
        check(hatch_image_make(&arena, hatch_mip_size(width, l), hatch_mip_size(height, l), pictures[kind].letters,
                               level, &err));
        int id = hatch_image_channel(level, "i"), t = hatch_image_channel(level, "t");
        if (id >= 0)
            level->channels[id] = (struct hatch_channel){"id", HATCH_UINT};
        if (t >= 0)
            level->channels[t].type = HATCH_FLOAT;
        size_t count = (size_t)level->width * level->height * level->channel_count;
        for (size_t i = 0; i < count; i++)
            level->pixels[i] = texel(&level->channels[i % level->channel_count], part * 40 + l, i);
        check(hatch_buffer_add(raw, level->pixels, count * sizeof(float), &err));
    }
    snprintf(mipmap->name, sizeof mipmap->name, "part.%u", part);
    hatch_mipmap_set_number(mipmap, "hatch:tone", 0.25 * part, HATCH_ATTRIBUTE_FLOAT);
}

static void save_pictures(const char *folder)
{
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        struct hatch_buffer raw = {.arena = &arena}, file = {.arena = &arena};
        struct hatch_exr_writer *writer = NULL;
        for (uint32_t part = 0; part < pictures[i].parts; part++) {
            struct hatch_image levels[HATCH_MIP_LEVELS_MAX];
            struct hatch_mipmap mipmap = {.levels = levels};
            fill_part(i, part, &mipmap, &raw);
            if (!writer)
                check(hatch_exr_begin(&mipmap, pictures[i].parts, &arena, &writer, &err));
            check(hatch_exr_add_part(writer, part, &mipmap, &err));
        }
        check(hatch_exr_end(writer, &file, &err));
        save(folder, pictures[i].name, ".exr", file.data, file.size);
        save(folder, pictures[i].name, ".exr.raw", raw.data, raw.size);
        save(folder, pictures[i].name, ".exr.channels", pictures[i].channels, strlen(pictures[i].channels));
    }
}

/* The scene: a torus with a skin, a custom attribute and a texture; a plane with morph targets and a normal map,
 * used by two nodes, one of them with a matrix; cameras, lights, and an animation of every interpolation. */
static void make_meshes(struct hatch_scene_mesh meshes[2])
{
    const struct hatch_shape_options options = {.faces = 300};
    const enum hatch_shape shapes[] = {HATCH_SHAPE_TORUS, HATCH_SHAPE_PLANE};
    for (uint32_t i = 0; i < 2; i++) {
        check(hatch_shape_make(shapes[i], &options, &arena, &scratch, &meshes[i].mesh, &err));
        meshes[i].material = i;
    }
    static const char *const names[] = {"JOINTS_0", "WEIGHTS_0", "COLOR_0", "_TEMPERATURE"};
    struct hatch_mesh *torus = &meshes[0].mesh, *plane = &meshes[1].mesh;
    float *data[4], *displacements;
    check(hatch_mesh_add(&arena, plane, HATCH_MORPH_POSITION, 6, &displacements, &err));
    for (size_t i = 0; i < 6 * (size_t)plane->vertex_count; i++)
        displacements[i] = 0.125f * (float)(i % 3);
    for (uint32_t i = 0; i < 4; i++)
        check(hatch_mesh_add(&arena, torus, names[i], i < 3 ? 4 : 1, &data[i], &err));
    for (size_t v = 0; v < torus->vertex_count; v++) {
        float weight = (float)(v % 17) / 16;
        data[0][4 * v + 1] = weight < 1 ? 1 : 0; /* joint 0 if its weight is 0 */
        data[1][4 * v] = weight;
        data[1][4 * v + 1] = 1 - weight;
        data[2][4 * v] = data[2][4 * v + 3] = 1;
        data[3][v] = torus->attributes[0].data[3 * v]; /* a function of the position */
    }
}

static void make_texture(struct hatch_texture *texture)
{
    struct hatch_image image;
    struct hatch_buffer file = {.arena = &arena};
    check(hatch_image_make(&arena, 4, 4, "RGB", &image, &err));
    check(hatch_png_write(&image, HATCH_PNG_SRGB, 8, NULL, &scratch, &file, &err));
    *texture = (struct hatch_texture){.data = file.data, .size = file.size};
}

static float times[] = {0, 0.5f, 2}, values[27], rotations[12], inverse_bind[32];
static uint32_t joints[] = {2, 5};
static struct hatch_skin skin = {.joint_count = 2, .joints = joints, .inverse_bind = inverse_bind};
static struct hatch_animation_channel channels[] = {{2, HATCH_PATH_TRANSLATION, HATCH_CUBIC, 3, times, values, 0},
                                                    {5, HATCH_PATH_ROTATION, HATCH_LINEAR, 3, times, rotations, 0},
                                                    {5, HATCH_PATH_SCALE, HATCH_STEP, 3, times, values, 0},
                                                    {3, HATCH_PATH_WEIGHTS, HATCH_CUBIC, 3, times, values, 2}};
static struct hatch_animation animation = {.channel_count = 4, .channels = channels, .duration_s = 2};

static void fill_motion(void)
{
    for (uint32_t i = 0; i < 27; i++)
        values[i] = 1 + 0.1f * (float)i;
    for (uint32_t i = 0; i < 3; i++)
        rotations[4 * i + i] = 1;
    for (uint32_t i = 0; i < 8; i++)
        inverse_bind[i / 4 * 16 + i % 4 * 5] = 1;
}

static struct hatch_material materials[] = {{.base_color = {1, 0.5f, 0.25f, 1},
                                             .base.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_MIRROR},
                                             .base.has_transform = true,
                                             .base.scale = {2, 3},
                                             .base.turn_rad = 0.5f,
                                             .base.offset = {0.25f, 0}},
                                            {.base_color = {1, 1, 1, 1},
                                             .base.texture = HATCH_NONE,
                                             .base.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT},
                                             .normals = {true, {.wrap = {HATCH_WRAP_REPEAT, HATCH_WRAP_REPEAT}}, 0.5f},
                                             .double_sided = true,
                                             .alpha_cutoff = 0.5f,
                                             .blend = true}};
static struct hatch_camera cameras[] = {{.yfov_rad = 0.7f, .aspect = 1.5f, .znear = 0.1f},
                                        {.orthographic = true, .ymag = 2, .aspect = 1.5f, .zfar = 10}};
static struct hatch_light lights[] = {
    {.type = HATCH_LIGHT_DIRECTIONAL, .color = {1, 1, 1}, .intensity = 3},
    {.type = HATCH_LIGHT_POINT, .color = {1, 0, 0.5f}, .intensity = 10, .range = 7},
    {.type = HATCH_LIGHT_SPOT, .color = {1, 1, 1}, .intensity = 5, .inner_cone_rad = 0.1f, .outer_cone_rad = 0.7f}};

static void make_nodes(struct hatch_node nodes[6])
{
    static const uint32_t parents[] = {HATCH_NONE, HATCH_NONE, HATCH_NONE, 1, 1, 2};
    for (uint32_t i = 0; i < 6; i++)
        nodes[i] = (struct hatch_node){.parent = parents[i],
                                       .translation = {0.5f * (float)i},
                                       .scale = {1, 1, 1},
                                       .rotation = {0, i ? 0.6f : 0, 0, i ? 0.8f : 1},
                                       .skin = i ? HATCH_NONE : 0,
                                       .camera = HATCH_NONE,
                                       .light = HATCH_NONE};
    nodes[0].light = 1;
    nodes[2].light = 2;
    nodes[3].camera = 1;
    nodes[4].light = 0;
    nodes[5].camera = 0;
    nodes[0].mesh_count = 1;
    nodes[1].mesh_count = nodes[3].mesh_count = nodes[1].first_mesh = nodes[3].first_mesh = 1;
    nodes[1].has_matrix = true;
    nodes[1].matrix[0] = nodes[1].matrix[10] = nodes[1].matrix[15] = 1;
    nodes[1].matrix[5] = -2; /* mirrors */
}

static void save_scene(const char *folder)
{
    struct hatch_scene_mesh meshes[2] = {{.material = 0}};
    struct hatch_node nodes[6];
    struct hatch_texture texture;
    const struct hatch_scene scene = {.mesh_count = 2,
                                      .node_count = 6,
                                      .material_count = 2,
                                      .texture_count = 1,
                                      .camera_count = 2,
                                      .light_count = 3,
                                      .skin_count = 1,
                                      .animation_count = 1,
                                      .meshes = meshes,
                                      .nodes = nodes,
                                      .materials = materials,
                                      .textures = &texture,
                                      .cameras = cameras,
                                      .lights = lights,
                                      .skins = &skin,
                                      .animations = &animation};
    struct hatch_buffer file = {.arena = &arena};
    make_meshes(meshes);
    make_nodes(nodes);
    fill_motion();
    make_texture(&texture);
    check(hatch_glb_write_scene(&scene, "a sample", &scratch, &file, &err));
    save(folder, "scene", ".glb", file.data, file.size);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: samples FOLDER\n");
        return HATCH_USAGE;
    }
    hatch_arena_init(&arena, (size_t)1 << 30);
    hatch_arena_init(&scratch, (size_t)1 << 30);
    save_textures(argv[1]);
    save_pictures(argv[1]);
    save_scene(argv[1]);
    hatch_arena_free(&scratch);
    hatch_arena_free(&arena);
    return 0;
}
