/* SPDX-License-Identifier: MIT */
/* The version of the linked library, which may differ from that of the headers a program was compiled with. */
#include "tdsp/types.h"

const char *tdsp_version(void)
{
    return TDSP_VERSION_STRING;
}
