#include "base/parallel.h"

#include <pthread.h>
#include <stdbool.h>

#define QUEUE_LENGTH 64u

struct job {
    hatch_task task;
    void *context;
    uint32_t next, count; /* indices next .. count-1 have not been started yet */
};

struct hatch_pool {
    pthread_mutex_t lock;
    pthread_cond_t changed; /* a job was queued, all jobs ended, or the pool closes */
    struct job queue[QUEUE_LENGTH];
    uint32_t first, queued; /* index of the oldest job in queue, number of jobs in it */
    uint32_t running;       /* number of indices that are being run now */
    bool closing;
    uint32_t worker_count;
    pthread_t *workers;
};

/* Runs the next index of the oldest job; returns false where no job is queued. The lock is held on entry and on return,
 * but not while the task runs. */
static bool run_one(struct hatch_pool *pool)
{
    if (!pool->queued)
        return false;
    struct job *job = &pool->queue[pool->first];
    hatch_task task = job->task;
    void *context = job->context;
    uint32_t index = job->next++;
    if (job->next == job->count) {
        pool->first = (pool->first + 1) % QUEUE_LENGTH;
        pool->queued--;
    }
    pool->running++;
    pthread_mutex_unlock(&pool->lock);
    task(context, index);
    pthread_mutex_lock(&pool->lock);
    pool->running--;
    if (!pool->queued && !pool->running)
        pthread_cond_broadcast(&pool->changed);
    return true;
}

static void *work(void *context)
{
    struct hatch_pool *pool = context;
    pthread_mutex_lock(&pool->lock);
    while (!pool->closing || pool->queued)
        if (!run_one(pool))
            pthread_cond_wait(&pool->changed, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

enum hatch_status hatch_pool_make(uint32_t threads, struct hatch_arena *arena, struct hatch_pool **pool,
                                  struct hatch_err *err)
{
    struct hatch_pool *made;
    HATCH_TRY(HATCH_ALLOC(arena, &made, 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->workers, threads, err));
    pthread_mutex_init(&made->lock, NULL);
    pthread_cond_init(&made->changed, NULL);
    while (made->worker_count + 1 < threads &&
           pthread_create(&made->workers[made->worker_count], NULL, work, made) == 0)
        made->worker_count++;
    *pool = made;
    return HATCH_OK;
}

void hatch_pool_free(struct hatch_pool *pool)
{
    if (!pool)
        return;
    hatch_pool_wait(pool);
    pthread_mutex_lock(&pool->lock);
    pool->closing = true;
    pthread_cond_broadcast(&pool->changed);
    pthread_mutex_unlock(&pool->lock);
    for (uint32_t i = 0; i < pool->worker_count; i++)
        pthread_join(pool->workers[i], NULL);
    pthread_cond_destroy(&pool->changed);
    pthread_mutex_destroy(&pool->lock);
}

uint32_t hatch_pool_threads(const struct hatch_pool *pool)
{
    return pool ? pool->worker_count + 1 : 1;
}

uint32_t hatch_pool_workers(const struct hatch_pool *pool, size_t bytes, const struct hatch_arena *arena)
{
    size_t most = arena->limit_bytes / 4 / bytes;
    uint32_t threads = hatch_pool_threads(pool);
    return most >= threads ? threads : most > 1 ? (uint32_t)most : 1;
}

static bool enqueue(struct hatch_pool *pool, hatch_task task, void *context, uint32_t count)
{
    pthread_mutex_lock(&pool->lock);
    bool room = pool->queued < QUEUE_LENGTH;
    if (room) {
        uint32_t last = (pool->first + pool->queued++) % QUEUE_LENGTH;
        pool->queue[last] = (struct job){task, context, 0, count};
        pthread_cond_broadcast(&pool->changed);
    }
    pthread_mutex_unlock(&pool->lock);
    return room;
}

void hatch_parallel_for(struct hatch_pool *pool, uint32_t count, hatch_task task, void *context)
{
    if (count > 1 && pool && pool->worker_count && enqueue(pool, task, context, count)) {
        hatch_pool_wait(pool);
        return;
    }
    for (uint32_t i = 0; i < count; i++)
        task(context, i);
}

void hatch_pool_submit(struct hatch_pool *pool, hatch_task task, void *context)
{
    if (!pool || !pool->worker_count || !enqueue(pool, task, context, 1))
        task(context, 0);
}

void hatch_pool_wait(struct hatch_pool *pool)
{
    if (!pool)
        return;
    pthread_mutex_lock(&pool->lock);
    while (pool->queued || pool->running)
        if (!run_one(pool))
            pthread_cond_wait(&pool->changed, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
}
