#!/usr/bin/env bash
# Sets up a bare Debian 12, builds bslnav, drives scenario S1 with Methods 1, 2 and 4 in the simulator, and
# evaluates a recorded log offline. The results are in out/demo.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
set_up app_bslnav app_bslnav-rawlog
bin=$build/bin
out=$root/out/demo
mkdir -p "$out"

# demo NAME DIRECTORY COMMAND...: runs it and prints its row of the table.
demo() {
  local name=$1 results=$out/$2
  shift 2
  run_logged "$out/log" "$@" --quiet --out "$results"
  printf '%-36s %-8s %8s %8s %9s %7s %9s\n' "$name" "$(value outcome)" "$(value time_to_goal_s '%.1f s')" \
    "$(value path_length_m '%.1f m')" "$(value min_clearance_m '%.2f m')" "$(value blind_spots_mean '%.1f')" \
    "$(value p50 '%.2f ms')"
}

# value KEY [FORMAT]: the first of this name in the run's summary, a dash for null, 0 for the little below it in contact.
value() {
  awk -v key="\"$1\":" -v format="${2:-%s}" '
    $1 == key { gsub(/[",]/, "", $2); if ($2 ~ /^-0\.0/) $2 = 0; if ($2 == "null") print "-"; else printf format "\n", $2; exit }
  ' "$results/summary.json"
}

s1=$root/config/scenarios/s1.ini
say "Driving ..."
printf '%-36s %-8s %8s %8s %9s %7s %9s\n' "" outcome time path "to person" "blind" "a cycle"
demo "S1, Method 1 (ROS default)" s1-method1 "$bin/bslnav" "$s1" --method 1
demo "S1, Method 2 (laser blind spots)" s1-method2 "$bin/bslnav" "$s1" --method 2
demo "S1, Method 4 (depth, velocity term)" s1-method4 "$bin/bslnav" "$s1" --method 4
demo "recorded log, Method 2 offline" rawlog "$bin/bslnav-rawlog" \
  "$root/config/rawlog.ini" "$root/config/rawlog-localization-demo.ini" --method 2
say "" "to person: nearest distance to the person; blind: mean number of blind spots" "" "Pictures:"
find "$out" -name '*.png' | sort | sed 's/^/  /'
