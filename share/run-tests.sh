#!/usr/bin/env bash
# Sets up a bare Debian 12, builds bslnav and runs all its tests. More arguments go to ctest, for example -R costmap.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
set_up
say "Testing ..."
cd "$root"
exec ctest --preset release --parallel 2 "$@" </dev/null
