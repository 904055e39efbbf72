#include <math.h>
#include <string.h>

#include "base/text.h"
#include "vector/drawing.h"

#define PIXEL_MM (25.4 / 96) /* size of a pixel where no page is chosen, as in CSS */

const char *const hatch_page_names[] = {"a0", "a1", "a2", "a3", "a4", "a5", "a6", "letter", "legal", "tabloid", NULL};

/* Shorter and longer sides, in the order of the names. */
static const double sides_mm[][2] = {{841, 1189}, {594, 841}, {420, 594},     {297, 420},     {210, 297},
                                     {148, 210},  {105, 148}, {215.9, 279.4}, {215.9, 355.6}, {279.4, 431.8}};

static bool parse_sides(const char *text, double *width_mm, double *height_mm)
{
    size_t first = strcspn(text, "x"), length = strlen(text);
    if (length > 2 && strcmp(text + length - 2, "mm") == 0)
        length -= 2;
    return first < length && hatch_text_number((struct hatch_text){text, first}, width_mm) &&
           hatch_text_number((struct hatch_text){text + first + 1, length - first - 1}, height_mm);
}

bool hatch_page_find(const char *text, double aspect, struct hatch_page *page)
{
    double width_mm, height_mm;
    for (size_t i = 0; hatch_page_names[i]; i++)
        if (strcmp(text, hatch_page_names[i]) == 0) {
            page->width_mm = sides_mm[i][aspect > 1];
            page->height_mm = sides_mm[i][!(aspect > 1)];
            return true;
        }
    if (!parse_sides(text, &width_mm, &height_mm) || !(width_mm >= HATCH_PAGE_LEAST_MM) ||
        !(width_mm <= HATCH_PAGE_MOST_MM) || !(height_mm >= HATCH_PAGE_LEAST_MM) || !(height_mm <= HATCH_PAGE_MOST_MM))
        return false;
    page->width_mm = width_mm;
    page->height_mm = height_mm;
    return true;
}

double hatch_page_pixel_mm(struct hatch_page *page, double width_px, double height_px)
{
    if (!(page->width_mm > 0)) {
        page->width_mm = width_px * PIXEL_MM + 2 * page->margin_mm;
        page->height_mm = height_px * PIXEL_MM + 2 * page->margin_mm;
    }
    return fmin((page->width_mm - 2 * page->margin_mm) / width_px, (page->height_mm - 2 * page->margin_mm) / height_px);
}

void hatch_page_place(const struct hatch_page *page, double width_px, double height_px, double pixel_mm,
                      struct hatch_vector_paths *paths)
{
    double left = 0.5 * (page->width_mm - width_px * pixel_mm);
    double bottom = 0.5 * (page->height_mm + height_px * pixel_mm);
    for (uint32_t i = 0; i < paths->count; i++)
        for (uint32_t k = 0; k < paths->paths[i].count; k++) {
            double *at = &paths->points[2 * (size_t)(paths->paths[i].first + k)];
            at[0] = left + at[0] * pixel_mm;
            at[1] = bottom - at[1] * pixel_mm;
        }
}
