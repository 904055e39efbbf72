/* A pool of threads. The results must not depend on which thread runs what: each task writes only
 * what is its own, and sums are taken over fixed pieces in a fixed order afterwards.
 */
#ifndef HATCH_BASE_PARALLEL_H
#define HATCH_BASE_PARALLEL_H

#include <stdint.h>

#include "base/arena.h"

struct hatch_pool;

/* Called on some thread, or at once on the caller's. index: 0 .. count-1 for hatch_parallel_for, 0
 * for a submitted task. */
typedef void (*hatch_task)(void *context, uint32_t index);

/* threads: 1 .. 256, the caller's thread counted. When the system gives fewer threads, the pool has
 * fewer: that is no error. The pool lives in arena; free it before the arena. */
enum hatch_status hatch_pool_make(uint32_t threads, struct hatch_arena *arena, struct hatch_pool **pool,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Waits for all tasks, ends the threads. NULL is allowed. */
void hatch_pool_free(struct hatch_pool *pool);

/* The number of threads, the caller's counted. NULL counts as 1. */
uint32_t hatch_pool_threads(const struct hatch_pool *pool);

/* Runs task(context, i) for i = 0 .. count-1, on all threads, and returns when all are done. A NULL
 * pool runs them in order on the caller's thread. Not to be called from within a task. */
void hatch_parallel_for(struct hatch_pool *pool, uint32_t count, hatch_task task, void *context);

/* Queues task(context, 0) and returns; with one thread, a NULL pool or a full queue the caller runs
 * it. Called from one thread only. context must live until hatch_pool_wait. */
void hatch_pool_submit(struct hatch_pool *pool, hatch_task task, void *context);

/* Helps with the queued tasks and returns when none is left or running. */
void hatch_pool_wait(struct hatch_pool *pool);

#endif
