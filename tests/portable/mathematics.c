/* SPDX-License-Identifier: MIT */
/* The library's own mathematics in bits (tests/golden/mathematics.txt): run on any machine, the output must be the same. */
#include "support/functions.h"

int main(void)
{
    functions_say(stdout);
    return 0;
}
