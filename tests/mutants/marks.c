/* Linked into all programs of the build with marks (marks.pl): maps the file that HATCH_MARKS names, so that a mark
 * that is set stays, however the process ends. */
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "marks.h"

static char unused[HATCH_MARKS_MAX];
char *hatch_marks = unused;

__attribute__((constructor(101))) static void map_marks(void)
{
    const char *path = getenv("HATCH_MARKS");
    int file = path ? open(path, O_RDWR) : -1;
    if (file < 0)
        return;
    void *mapped = mmap(NULL, HATCH_MARKS_MAX, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped != MAP_FAILED)
        hatch_marks = mapped;
    close(file);
}
