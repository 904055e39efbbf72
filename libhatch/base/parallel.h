/* A pool of threads. To keep results independent of scheduling, a task must write only its own data; take sums
 * afterwards, over fixed pieces in a fixed order. */
#ifndef HATCH_BASE_PARALLEL_H
#define HATCH_BASE_PARALLEL_H

#include <stdint.h>

#include "base/arena.h"

struct hatch_pool;

/* A task, called on any thread of the pool.
 *   index  0 .. count-1 in hatch_parallel_for, 0 for a submitted task */
typedef void (*hatch_task)(void *context, uint32_t index);

/* Makes a pool in arena; the pool must be freed before the arena. Where the system grants fewer threads, the pool has
 * fewer.
 *   threads  1 .. 256, including the caller's */
enum hatch_status hatch_pool_make(uint32_t threads, struct hatch_arena *arena, struct hatch_pool **pool,
                                  struct hatch_err *err) HATCH_MUST_USE;

/* Waits for all tasks and ends the threads.
 *   pool  may be NULL */
void hatch_pool_free(struct hatch_pool *pool);

/* Returns the number of threads, including the caller's.
 *   pool  NULL counts as 1 */
uint32_t hatch_pool_threads(const struct hatch_pool *pool);

/* Returns the number of threads that may have working memory of their own in an arena: all of them, or as many as take
 * a quarter of its limit; at least 1.
 *   bytes  of each, over 0 */
uint32_t hatch_pool_workers(const struct hatch_pool *pool, size_t bytes, const struct hatch_arena *arena);

/* Runs task(context, i) for i = 0 .. count-1 on all threads; returns when all are done. Must not be called from a task.
 *   pool  NULL: runs them in order on the caller's thread */
void hatch_parallel_for(struct hatch_pool *pool, uint32_t count, hatch_task task, void *context);

/* Queues task(context, 0) and returns. Where the pool has only one thread, or its queue is full, the task runs before
 * this returns. Must be called from one thread only.
 *   pool     NULL: the task runs before this returns
 *   context  must stay valid until hatch_pool_wait returns */
void hatch_pool_submit(struct hatch_pool *pool, hatch_task task, void *context);

/* Runs queued tasks on the caller's thread, too; returns when no task is queued or running.
 *   pool  may be NULL */
void hatch_pool_wait(struct hatch_pool *pool);

#endif
