/* Counts the steps of a call: the basic blocks that it executes in the folders that tests/steps.mk instruments. The
 * count is the same on every run, however busy the machine is, so that tests can bound how it grows. The work of the C
 * library, such as memcpy, is not counted. Only for programs named test_*_steps.c. */
#ifndef HATCH_TEST_STEPS_H
#define HATCH_TEST_STEPS_H

#include <stdint.h>

static uint64_t steps;

/* The compiler inserts a call of this function into each block. */
void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    steps++;
}

#endif
