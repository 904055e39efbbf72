/* The numbers of accessors: their type in the file, and their bytes. */
#include <math.h>
#include <string.h>

#include "io/glb/parts.h"

#define STEPS_HIGH 16                     /* mean height of faces in texture coordinates that are rounded, in steps */
#define ROUNDED_8 (0.5 / 127 * 1.7320508) /* greatest error of a vector of three numbers of 8 bits */

static bool begins(const char *name, const char *start)
{
    return strncmp(name, start, strlen(start)) == 0;
}

/* Returns whether all numbers of an attribute are in low .. 1. */
static bool all_within(const struct hatch_mesh *mesh, const struct hatch_mesh_attribute *a, float low)
{
    for (size_t i = 0; i < (size_t)mesh->vertex_count * a->components; i++)
        if (!(a->data[i] >= low && a->data[i] <= 1))
            return false;
    return true;
}

/* Returns twice the signed area of a face in an attribute of two components, and its longest side, where the numbers
 * are rounded to multiples of `step`; 0: they are not. */
static double double_area(const struct hatch_mesh *mesh, const struct hatch_mesh_attribute *a, size_t face, double step,
                          double *longest)
{
    double at[3][2], squared = 0;
    for (size_t c = 0; c < 3; c++)
        for (size_t k = 0; k < 2; k++) {
            double value = (double)a->data[2 * (size_t)mesh->indices[3 * face + c] + k];
            at[c][k] = step > 0 ? floor(value / step + 0.5) * step : value;
        }
    for (size_t c = 0; c < 3; c++) {
        double x = at[(c + 1) % 3][0] - at[c][0], y = at[(c + 1) % 3][1] - at[c][1];
        squared = fmax(squared, x * x + y * y);
    }
    *longest = sqrt(squared);
    return (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) - (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
}

/* Returns whether texture coordinates can be rounded to multiples of `step`: no face turns over, and in the mean over
 * the area faces are many steps high. */
static bool faces_survive(const struct hatch_mesh *mesh, const struct hatch_mesh_attribute *a, double step)
{
    double areas = 0, errors = 0, longest;
    for (size_t f = 0; f < mesh->face_count; f++) {
        double rounded = double_area(mesh, a, f, step, &longest), area = double_area(mesh, a, f, 0, &longest);
        if (area != 0 && !(rounded * area > 0))
            return false;
        areas += fabs(area);
        errors += longest * step; /* the area, times a step as a share of the height */
    }
    return errors * STEPS_HIGH <= areas;
}

/* Returns whether all numbers of an attribute are whole ones of 16 bits. */
static bool all_whole(const struct hatch_mesh *mesh, const struct hatch_mesh_attribute *a)
{
    for (size_t i = 0; i < (size_t)mesh->vertex_count * a->components; i++)
        if (!(a->data[i] >= 0 && a->data[i] <= UINT16_MAX && a->data[i] == floorf(a->data[i])))
            return false;
    return true;
}

void hatch_glb_choose_numbers(struct hatch_glb *glb, const struct hatch_mesh *mesh,
                              const struct hatch_mesh_attribute *a, struct hatch_glb_view *view)
{
    const double rounding = (double)glb->scene->rounding;
    bool texcoord = begins(a->name, "TEXCOORD_"), direction = strcmp(a->name, "_HATCH_DIR") == 0;
    bool vector = strcmp(a->name, "NORMAL") == 0 || strcmp(a->name, "TANGENT") == 0;
    bool whole = begins(a->name, "JOINTS_") || strcmp(a->name, HATCH_CURVE_FACE) == 0 ||
                 strcmp(a->name, HATCH_CURVE_STROKE) == 0 || strcmp(a->name, HATCH_CURVE_NARROW) == 0;
    view->component = whole && all_whole(mesh, a) ? HATCH_GLB_U16 : HATCH_GLB_F32;
    if (!(rounding > 0) || !(texcoord || vector || direction) || !all_within(mesh, a, -1))
        return;
    bool positive = texcoord && all_within(mesh, a, 0);
    if (texcoord && !faces_survive(mesh, a, 1.0 / (positive ? UINT16_MAX : INT16_MAX)))
        return;
    view->normalized = true;
    if (texcoord)
        view->component = positive ? HATCH_GLB_U16 : HATCH_GLB_I16;
    else
        view->component = rounding >= ROUNDED_8 ? HATCH_GLB_I8 : HATCH_GLB_I16;
    glb->quantized = glb->quantized || vector || view->component == HATCH_GLB_I16;
}

size_t hatch_glb_number_bytes(enum hatch_glb_component component)
{
    return component == HATCH_GLB_I8 || component == HATCH_GLB_U8     ? 1
           : component == HATCH_GLB_I16 || component == HATCH_GLB_U16 ? 2
                                                                      : 4;
}

size_t hatch_glb_stride(const struct hatch_glb_view *view)
{
    size_t bytes = view->components * hatch_glb_number_bytes(view->component);
    return view->target == HATCH_GLB_VERTICES ? (bytes + 3) / 4 * 4 : bytes;
}

static void put_bytes(uint8_t *at, uint32_t value, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

/* Returns the bits of a number in the file. */
static uint32_t bits_of(const struct hatch_glb_view *view, float value)
{
    uint32_t bits;
    float one = view->component == HATCH_GLB_I8 ? 127 : view->component == HATCH_GLB_I16 ? 32767 : 65535;
    if (view->normalized)
        return (uint32_t)(int32_t)floorf(value * one + 0.5f);
    if (view->component == HATCH_GLB_U16)
        return (uint32_t)value;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

void hatch_glb_put_numbers(const struct hatch_glb_view *view, uint8_t *at)
{
    const float *values = view->data;
    const uint32_t *indices = view->data;
    size_t bytes = hatch_glb_number_bytes(view->component), stride = hatch_glb_stride(view);
    for (size_t i = 0; i < view->count; i++)
        for (size_t c = 0; c < view->components; c++) {
            size_t from = i * view->components + c;
            uint32_t bits = view->target == HATCH_GLB_INDICES ? indices[from] : bits_of(view, values[from]);
            put_bytes(at + i * stride + c * bytes, bits, bytes);
        }
}
