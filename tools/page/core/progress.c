/* SPDX-License-Identifier: MIT */
/* Progress: the one function that the module imports. */
#include "page.h"

__attribute__((import_module("tdsp"), import_name("progress"))) int progress_told(double settled, double all);

int page_progress(void *ctx, double settled, double all)
{
    (void)ctx;
    return progress_told(settled, all);
}
