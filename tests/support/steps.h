/* How many steps a call takes: blocks of code that it runs through in the folders that tests/steps.mk compiles for
 * this. The number is the same on every run, however busy the machine is, so that tests can say by what it may
 * grow. What the C library does for a block, memcpy for one, is not in it. Only for programs called test_*_steps.c. */
#ifndef HATCH_TEST_STEPS_H
#define HATCH_TEST_STEPS_H

#include <stdint.h>

static uint64_t steps;

/* The compiler has each block call it. */
void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    steps++;
}

#endif
