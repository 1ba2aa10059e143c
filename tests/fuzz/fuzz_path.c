/* SPDX-License-Identifier: MIT */
/* Any text at all as a path file: the reader must refuse it with a message, or hand out legs that the verifier can judge. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/growth.h"
#include "tdsp/path_json.h"
#include "tdsp/verify.h"

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

static void fuzz_quiet(const char *text)
{
    (void)text;
}

static void fuzz_require(int holds)
{
    if (!holds) abort();
}

/* One disc of one rate, one whose rate rises, one whose rate jumps. */
static tdsp_scene *fuzz_scene(void)
{
    static const double powers[] = {0.1, 0.004}, times[] = {0.0, 5.0, 12.0}, rates[] = {0.1, 0.3, 0.02};
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    const tdsp_growing_disc discs[] = {
        {{0.0, 3.0}, 1.0, {.kind = TDSP_GROWTH_RATE, .rate = 0.1}},
        {{-3.0, -1.0}, 1.0, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers}},
        {{5.0, 1.5}, 0.2, {.kind = TDSP_GROWTH_RATES, .count = 3, .values = rates, .times = times}},
    };
    tdsp_scene *scene = NULL;
    fuzz_require(tdsp_scene_create_growing(&journey, discs, 3, NULL, &scene) == TDSP_OK);
    return scene;
}

static void fuzz_judge(const PathFile *path)
{
    tdsp_scene *scene = fuzz_scene();
    tdsp_verdict verdict;
    tdsp_status status = tdsp_verify_path(scene, (const tdsp_leg *)(const void *)path->legs->data, path->legs->len, path->departure,
                                          path->arrival, &verdict);
    fuzz_require(status == TDSP_OK || status == TDSP_INVALID_ARGUMENT || status == TDSP_NO_MEMORY);
    tdsp_scene_free(scene);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    PathFile path = {0};
    g_autoptr(GError) error = NULL;
    g_set_printerr_handler(fuzz_quiet);
    char *text = g_malloc(size + 1); /* exactly as long as it is, so that a read past its end is seen */
    if (size) memcpy(text, data, size);
    text[size] = '\0';
    gboolean read = path_json_parse("input", text, size, 1.0, &path, &error);
    g_free(text);
    fuzz_require(read ? !error : error != NULL);
    if (read && path.legs) fuzz_judge(&path);
    path_file_clear(&path);
    return 0;
}
