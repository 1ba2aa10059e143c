/* SPDX-License-Identifier: MIT */
/* Words of the library. */
#include "page.h"

PAGE_EXPORT(version) const char *page_version(void)
{
    return tdsp_version();
}

PAGE_EXPORT(status_name) const char *page_status_name(tdsp_status status)
{
    return tdsp_status_name(status);
}

PAGE_EXPORT(status_text) const char *page_status_text(tdsp_status status)
{
    return tdsp_status_text(status);
}
