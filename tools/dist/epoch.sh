#!/bin/bash
# SPDX-License-Identifier: MIT
# The time of the release that is being made, in seconds since 1970: that of the newest entry of tools/debian/changelog. It is the same with and without
# a repository around, so that what is packed from an unpacked release is the release again.
set -euo pipefail
cd "$(dirname "$0")/../.."
date --utc --date="$(sed -n 's/^ -- .*>  *//p' tools/debian/changelog | head -n 1)" +%s
