#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables as C source: it compiles, warns of nothing, and holds the table's bytes."""
import os
import pathlib
import shutil
import subprocess

from harness import built, done, expect, expect_equal, fails, main, scene, test, write

CC = shutil.which("gcc") or shutil.which("cc") or "cc"


@test
def the_array_holds_the_bytes_of_the_table_aligned():
    table = built()
    report = done("embed", table, "-o", "harbour_table.c", "--json").json
    size = os.stat(table).st_size
    expect_equal(report, {"file": "harbour_table.c", "name": "harbour_table", "bytes": size})
    write("main.c", """#include <stdint.h>
#include <stdio.h>
extern const size_t harbour_table_length;
extern const unsigned char harbour_table[];
int main(void)
{
    if ((uintptr_t)harbour_table % 8 != 0) return 1;
    return fwrite(harbour_table, 1, harbour_table_length, stdout) == harbour_table_length ? 0 : 2;
}
""")
    subprocess.run([CC, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "main.c", "harbour_table.c", "-o", "main"], check=True)
    expect_equal(subprocess.run(["./main"], capture_output=True, check=True).stdout, pathlib.Path(table).read_bytes())


@test
def the_name_is_derived_from_the_file_s():
    table = built()
    for file, name in [("a b-c.c", "a_b_c"), ("3d.c", "table_3d"), ("int.c", "table_int"), ("_x.c", "table__x"), ("x.tdsp.c", "x"),
                       ("\u00e4.c", "table___"), (".c", "table_")]:
        expect_equal(done("embed", table, "-o", file, "--json").json["name"], name, file)


@test
def the_name_may_be_given():
    table = built()
    done("embed", table, "-o", "x.c", "--name", "my_table")
    expect("const unsigned char my_table[" in pathlib.Path("x.c").read_text(), "not the name")
    for name in ["1a", "a-b", "", "while", "_a", "a b", "\u00e4"]:
        fails(2, ["--name"], "embed", table, "-o", "y.c", "--name", name)


@test
def only_tables_are_embedded():
    fails(3, ["not a table"], "embed", scene(), "-o", "x.c")
    expect(not pathlib.Path("x.c").exists(), "something was written")


@test
def without_json_nothing_is_printed():
    result = done("embed", built(), "-o", "x.c")
    expect_equal([result.out, result.err], ["", ""])


main()
