#!/usr/bin/env bash
# Checks layout (clang-format) and code (clang-tidy) of the files or directories given, else of the whole project.
#   bash share/lint.sh [--fix] [--format-only] [FILE|DIRECTORY ...]
# BUILD is a configured build directory with compile_commands.json (default build/release).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$root/build/release}
fix=false
tidy=true
places=()
for argument in "$@"; do
  case $argument in
    --fix) fix=true ;;
    --format-only) tidy=false ;;
    *) places+=("$(realpath "$argument")") ;;
  esac
done
cd "$root"
((${#places[@]})) || places=(apps libs tests)
find_sources() { find "${places[@]}" -type f \( "$@" \) -print0 | sort -z; }

if $fix; then
  find_sources -name '*.h' -o -name '*.cpp' | xargs -0 -r clang-format-14 -i
fi
status=0
find_sources -name '*.h' -o -name '*.cpp' | xargs -0 -r -n 16 -P 2 clang-format-14 --dry-run -Werror || status=1
if $tidy; then
  [[ -f $build/compile_commands.json ]] || cmake --preset release >/dev/null
  find_sources -name '*.cpp' | xargs -0 -r -n 1 -P 2 clang-tidy-14 --quiet -p "$build" 2>/dev/null || status=1
fi
((status == 0)) && echo "lint: clean"
exit $status
