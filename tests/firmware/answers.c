/* SPDX-License-Identifier: MIT */
/* tests/portable/answers.c on a processor without a command line: the files to read stand in `files.txt`, one a line. */
#define main answers_of_files
#include "../portable/answers.c"
#undef main

int main(void)
{
    char line[256];
    FILE *list = fopen("files.txt", "r");
    int read = list != NULL;
    while (read && fgets(line, sizeof line, list)) {
        line[strcspn(line, "\n")] = '\0';
        read = read_and_say(line);
    }
    if (list) fclose(list);
    return read ? 0 : 1;
}
