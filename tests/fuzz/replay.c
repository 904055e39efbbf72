/* replay_NAME FILE ...: runs a fuzz target once on each file, without clang, and prints TAP. A crash ends the
 * run; the plan, printed first, shows that tests are missing. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <sys/time.h>

#include "fuzz.h"

#define SECONDS_EACH 20 /* processor time per file; under sanitizers the slowest needs a few */

static int replay(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    /* Exactly as large as the content, so that AddressSanitizer detects every overrun. */
    uint8_t *data = size >= 0 ? malloc(size ? (size_t)size : 1) : NULL;
    int complete = data && fread(data, 1, (size_t)size, file) == (size_t)size;
    fclose(file);
    if (complete) {
        struct itimerval limit = {.it_value.tv_sec = SECONDS_EACH}, none = {.it_value.tv_sec = 0};
        setitimer(ITIMER_PROF, &limit, NULL);
        LLVMFuzzerTestOneInput(data, (size_t)size);
        setitimer(ITIMER_PROF, &none, NULL);
    }
    free(data);
    return complete;
}

int main(int argc, char **argv)
{
    printf("1..%d\n", argc - 1);
    for (int i = 1; i < argc; i++) {
        fflush(stdout);
        printf("%s %d - %s\n", replay(argv[i]) ? "ok" : "not ok", i, argv[i]);
    }
    return 0;
}
