#!/bin/bash
# SPDX-License-Identifier: MIT
# The Java wrapper over JNA: Debian's, or the jar that JNA_JAR names.
language=java
. "$(dirname "$0")/common.sh"

jna=${JNA_JAR:-/usr/share/java/jna.jar}
classes=$work/classes
rm -rf "$classes"
must "compiles without a warning" javac -Xlint:all -Werror -encoding UTF-8 -d "$classes" -cp "$jna" examples/java/*.java examples/java/tdsp/*.java tests/languages/Misuse.java
java="java -Djna.library.path=$build -Djava.library.path=/usr/lib/jni:/usr/lib/$(gcc -dumpmachine)/jni -cp $classes:$jna"
read_table "$java ReadTable"
$java Misuse $golden || failed=1
exit $failed
