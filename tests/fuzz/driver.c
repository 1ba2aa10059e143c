/* SPDX-License-Identifier: MIT */
/*
 * Runs a target over files and all files of directories, in any build: what libFuzzer does, without the fuzzing.
 *   PROGRAM [--reached FILE] PATH...
 * Every name is told before its input is run, so that the last one is that of an input that ends the program; one that takes a minute does.
 *
 * Objects that are instrumented for libFuzzer count here as they would there. --reached writes the number of edges run through and of all, the address of the target, and
 * those of the functions entered; tests/fuzz/check_reached.py turns them into names.
 */
#include <dirent.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "input.h"

enum { MOST_SECONDS = 60, MOST_PATH = 4096 };

/* The names are the compiler's. An entry of the table of places is an address and flags; the first says that a function begins. */
void __sanitizer_cov_8bit_counters_init(char *start, char *stop);
void __sanitizer_cov_pcs_init(const uintptr_t *start, const uintptr_t *stop);

static char *counters, *counters_end;
static const uintptr_t *places;
static unsigned char *seen;

void __sanitizer_cov_8bit_counters_init(char *start, char *stop)
{
    counters = start;
    counters_end = stop;
}

void __sanitizer_cov_pcs_init(const uintptr_t *start, const uintptr_t *stop)
{
    (void)stop;
    places = start;
}

/* Counters are of eight bits: after each input they are taken over and begin at 0. */
static void note_seen(void)
{
    const size_t count = (size_t)(counters_end - counters);
    if (count && !seen) seen = calloc(count, 1);
    for (size_t i = 0; seen && i < count; i++) seen[i] |= counters[i] != 0;
    if (count) memset(counters, 0, count);
}

static int write_reached(const char *name)
{
    const size_t count = (size_t)(counters_end - counters);
    size_t edges = 0;
    FILE *file = fopen(name, "w");
    if (!file || !seen || !places) {
        fprintf(stderr, "%s: %s\n", name, file ? "this program does not count" : "cannot write");
        if (file) fclose(file);
        return 0;
    }
    for (size_t i = 0; i < count; i++) edges += seen[i];
    fprintf(file, "edges %zu %zu\ntarget %zx\n", edges, count, (size_t)(uintptr_t)&LLVMFuzzerTestOneInput);
    for (size_t i = 0; i < count; i++)
        if (seen[i] && (places[2 * i + 1] & 1u)) fprintf(file, "%zx\n", (size_t)places[2 * i]);
    return fclose(file) == 0;
}

static unsigned char *read_all(FILE *file, size_t *size)
{
    unsigned char *bytes = NULL;
    if (fseek(file, 0, SEEK_END) != 0) return NULL;
    const long length = ftell(file);
    if (length < 0 || fseek(file, 0, SEEK_SET) != 0) return NULL;
    *size = (size_t)length;
    bytes = malloc(*size + 1);
    if (bytes && fread(bytes, 1, *size, file) == *size) return bytes;
    free(bytes);
    return NULL;
}

static int run_file(const char *name, size_t *count)
{
    size_t size = 0;
    FILE *file = fopen(name, "rb");
    unsigned char *bytes = file ? read_all(file, &size) : NULL;
    if (file) fclose(file);
    if (!bytes) {
        fprintf(stderr, "%s: cannot read\n", name);
        return 0;
    }
    printf("# %s\n", name);
    fflush(stdout);
    alarm(MOST_SECONDS);
    LLVMFuzzerTestOneInput(bytes, size);
    alarm(0);
    note_seen();
    free(bytes);
    ++*count;
    return 1;
}

static int run_path(const char *path, size_t *count);

static int run_directory(const char *path, size_t *count)
{
    struct dirent **entries;
    int good = 1;
    const int number = scandir(path, &entries, NULL, alphasort);
    if (number < 0) return 0;
    for (int i = 0; i < number; i++) {
        char name[MOST_PATH];
        const int fits = snprintf(name, sizeof name, "%s/%s", path, entries[i]->d_name) < (int)sizeof name;
        if (entries[i]->d_name[0] != '.') good &= fits && run_path(name, count);
        free(entries[i]);
    }
    free(entries);
    return good;
}

static int run_path(const char *path, size_t *count)
{
    struct stat about;
    if (stat(path, &about) == 0 && S_ISDIR(about.st_mode)) return run_directory(path, count);
    return run_file(path, count);
}

int main(int argc, char **argv)
{
    const char *reached = argc > 2 && strcmp(argv[1], "--reached") == 0 ? argv[2] : NULL;
    size_t count = 0;
    int good = 1;
    note_seen(); /* what ran before main() is no target's */
    if (seen) memset(seen, 0, (size_t)(counters_end - counters));
    for (int i = reached ? 3 : 1; i < argc; i++) good &= run_path(argv[i], &count);
    if (reached) good &= write_reached(reached);
    free(seen);
    printf("%s rerun of %zu inputs\n", good && count ? "ok" : "not ok", count);
    return good && count ? 0 : 1;
}
