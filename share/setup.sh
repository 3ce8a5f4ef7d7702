# Sourced by run-demo.sh and run-tests.sh: installs what is missing, configures and builds build/release.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

say() { printf '%s\n' "$@"; }
fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# run_logged LOG COMMAND...: its output goes to LOG and is shown only when it fails.
run_logged() {
  local log=$1
  shift
  "$@" </dev/null >"$log" 2>&1 && return
  tail -n 60 "$log" >&2
  fail "Failed: $*
The whole log is in $log"
}

missing_packages() {
  local package
  sed -e 's/#.*//' "$root/share/debian-packages.txt" | while read -r package; do
    [[ -z $package ]] && continue
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *" installed" ]] || echo "$package"
  done
}

install_packages() {
  local missing
  command -v dpkg-query >/dev/null || fail "bslnav's scripts are for Debian 12: dpkg-query is missing here.
What has to be installed is in share/debian-packages.txt."
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]} == 0)) && return
  local -a as_root=()
  if ((EUID != 0)); then
    if ! { command -v sudo && sudo -n true; } >/dev/null 2>&1; then
      fail "Some packages are missing, and installing them needs root. Please type

  su - -c 'apt-get update && apt-get install --no-install-recommends ${missing[*]}'

or the same with sudo, and start this again."
    fi
    as_root=(sudo -n)
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  run_logged "$root/build/apt.log" "${as_root[@]}" apt-get update
  run_logged "$root/build/apt.log" "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}"
}

# Two compilers at a time fit into 4 GB of memory; with less, one.
build_jobs() {
  local memory_MB cores
  memory_MB=$(awk '/MemAvailable/ { print int($2 / 1024) }' /proc/meminfo)
  cores=$(nproc)
  if ((cores > 1 && memory_MB > 3000)); then echo 2; else echo 1; fi
}

# build_release [TARGET...]: nothing but a check when all is up to date.
build_release() {
  local target
  local -a targets=()
  for target in "$@"; do targets+=(--target "$target"); done
  local first=""
  [[ -e $build/build.ninja ]] || first=" (the first time takes several minutes)"
  say "Building$first ..."
  cd "$root"
  run_logged "$root/build/configure.log" cmake --preset release
  run_logged "$root/build/build.log" cmake --build --preset release --parallel "$(build_jobs)" "${targets[@]}"
}

set_up() {
  mkdir -p "$root/build"
  install_packages
  build_release "$@"
}
