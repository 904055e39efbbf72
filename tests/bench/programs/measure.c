/* measure N COMMAND ...: runs a command N times, discards its standard output, and prints the median, shortest and
 * longest seconds, the mean processor seconds and the peak memory in KiB, separated by tabs. In COMMAND, @ stands for
 * the number of the run, from 1. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define RUNS_MAX 1000

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static double in_seconds(struct timeval time)
{
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void run_child(char **command, int number)
{
    char text[16];
    snprintf(text, sizeof text, "%d", number);
    for (char **word = command; *word; word++)
        if (strcmp(*word, "@") == 0)
            *word = text;
    int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    execvp(command[0], command);
    perror(command[0]);
    _exit(127);
}

int main(int argc, char **argv)
{
    static double seconds[RUNS_MAX];
    int runs = argc > 2 ? atoi(argv[1]) : 0, status = 0;
    struct rusage usage;
    if (runs < 1 || runs > RUNS_MAX)
        return 2;
    for (int i = 0; i < runs; i++) {
        double from = now();
        pid_t child = fork();
        if (child == 0)
            run_child(argv + 2, i + 1);
        if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) {
            fprintf(stderr, "measure: %s failed\n", argv[2]);
            return 1;
        }
        seconds[i] = now() - from;
    }
    getrusage(RUSAGE_CHILDREN, &usage); /* of the largest child */
    qsort(seconds, (size_t)runs, sizeof *seconds, by_size);
    double middle = (seconds[(runs - 1) / 2] + seconds[runs / 2]) / 2;
    printf("%.4f\t%.4f\t%.4f\t%.4f\t%ld\n", middle, seconds[0], seconds[runs - 1],
           (in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime)) / runs, usage.ru_maxrss);
    return 0;
}
