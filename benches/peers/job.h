// What flint.c and flint3.c share: files of the folder of cases, and the clock.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double BUDGET = 0.1;
static const char *folder;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static FILE *open_file(const char *name, const char *mode)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, mode);
    if (!file) {
        fprintf(stderr, "cannot open %s\n", path);
        exit(1);
    }
    return file;
}

// The whole numbers on the next line.
static int read_line(FILE *file, long *numbers, int most)
{
    static char line[1 << 16];
    int count = 0;
    if (!fgets(line, sizeof line, file)) return 0;
    for (char *word = strtok(line, " \n"); word && count < most; word = strtok(NULL, " \n"))
        numbers[count++] = atol(word);
    return count;
}

// Runs the job until the time is over, and prints the seconds for each of its units.
static void time_job(const char *job, const char *label, const char *variant, int units, void (*run)(void))
{
    run();
    double start = now(), elapsed;
    long runs = 0;
    do {
        run();
        runs++;
    } while ((elapsed = now() - start) < BUDGET);
    printf("%s\t%s\t%s\t%.6e\n", job, label, variant, elapsed / runs / units);
}
