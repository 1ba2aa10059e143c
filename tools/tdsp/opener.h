/* SPDX-License-Identifier: MIT */
/* Opening a file as a double click would. */
#ifndef OPENER_H
#define OPENER_H

#include <glib.h>

/* Is there a desktop on which something could be seen? */
gboolean opener_has_display(void);

/* Let the desktop open a file with its usual program, and do not wait until that is closed. An error that tells why it could not, or that it took too long. */
gboolean opener_open(const char *path, GError **error);

#endif
