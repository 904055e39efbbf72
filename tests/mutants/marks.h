/* Included before all sources of the build with marks: a byte for each mutation, 1 once its line was reached. */
#ifndef HATCH_MARKS_H
#define HATCH_MARKS_H

#define HATCH_MARKS_MAX 4096
#ifdef __cplusplus
extern "C" char *hatch_marks;
#else
extern char *hatch_marks;
#endif

#endif
