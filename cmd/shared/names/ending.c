#include "shared/cmd.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

static bool is_listed(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = list; (at = strstr(at, word)); at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0))
            return true;
    return false;
}

void cmd_check_ending(const char *path, const char *endings)
{
    static const char formats[] =
        "3ds apng avi avif blend bmp csv dae dds eps exr fbx gif glb gltf hdr heic html jpeg jpg json jxl ktx ktx2 mkv "
        "mov mp4 obj off pbm pdf pgm ply png pnm ppm ps psd seeds stl svg tga tif tiff tsv txt usd usda usdc usdz webm "
        "webp xcf xml";
    const char *dot = path ? strrchr(path, '.') : NULL;
    char ending[8] = "";
    for (size_t i = 0; dot && i + 1 < sizeof ending && dot[i + 1]; i++)
        ending[i] = (char)tolower((unsigned char)dot[i + 1]);
    if (!*ending || !is_listed(formats, ending) || is_listed(endings, ending))
        return;
    char wanted[64];
    size_t used = 0;
    for (const char *at = endings; *at && used < sizeof wanted; at += strcspn(at, " "), at += *at == ' ') {
        int length = (int)strcspn(at, " ");
        const char *before = at == endings ? "" : strchr(at, ' ') ? ", " : " or ";
        used += (size_t)snprintf(wanted + used, sizeof wanted - used, "%s.%.*s", before, length, at);
    }
    cmd_usage("%s: the ending is that of another format: want %s", path, wanted);
}
