#!/bin/bash
# SPDX-License-Identifier: MIT
# Run a program in the emulator named by EMULATOR; a script by its interpreter, on this machine.
#   emulate.sh PROGRAM|INTERPRETER [ARGUMENT]...
case $1 in
*/*) exec $EMULATOR "$@" ;;
*) exec "$@" ;;
esac
