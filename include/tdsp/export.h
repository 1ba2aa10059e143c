/* SPDX-License-Identifier: MIT */
/* Visibility of public symbols, and the library's version. */
#ifndef TDSP_EXPORT_H
#define TDSP_EXPORT_H

/* Before each public function: the library exports these symbols and no others. */
#if defined(__GNUC__) && !defined(_WIN32)
#define TDSP_API __attribute__((visibility("default")))
#else
#define TDSP_API
#endif

#define TDSP_VERSION_MAJOR 0 /* of the headers; tdsp_version() tells that of the library */
#define TDSP_VERSION_MINOR 1 /* likewise */
#define TDSP_VERSION_PATCH 0 /* likewise */
#define TDSP_VERSION_STRING "0.1.0" /* all three */

#endif
