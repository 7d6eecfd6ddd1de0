#!/bin/sh
# tests/fuzz/run.sh [--seconds N | --runs N] [TARGET...]: the fuzzers of build/fuzz, one behind the other, each for N seconds (60) or
# until it has made N runs in all, those of earlier calls counted. What they learn is kept in build/fuzz/corpus, what they find
# in build/fuzz/findings. A table of runs; exit code 1 if anything was found.
set -eu
cd "$(dirname "$0")/../.."
seconds=60 wanted=0
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds) seconds=${2:?--seconds needs a number}; shift 2 ;;
    --runs) wanted=${2:?--runs needs a number} seconds=0; shift 2 ;;
    -h|--help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    -*) echo "run.sh: unknown argument '$1'; see --help" >&2; exit 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- $(ls tests/fuzz/targets | sed 's/\.cpp$//')

export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/leaks.txt:print_suppressions=0"
export ASAN_OPTIONS="detect_leaks=1:allocator_may_return_null=1:detect_stack_use_after_return=0" UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1"
[ -w /dev/shm ] && export TMPDIR=/dev/shm   # files that are replaced ten thousand times a second are no work for a disk
fuzz=build/fuzz
seeds=$fuzz/seeds
mkdir -p "$fuzz/findings" "$fuzz/runs"
"$fuzz/bin/foothold-fuzz-seeds" "$seeds"
status=0
printf '%-18s %12s %12s %10s  %s\n' target runs "in all" "a second" result
for target; do
  corpus=$fuzz/corpus/$target past=tests/fuzz/corpus/$target
  mkdir -p "$corpus" "$seeds/$target"
  before=$(cat "$fuzz/runs/$target" 2>/dev/null || echo 0)
  limit="-max_total_time=$seconds"
  if [ "$wanted" -gt 0 ]; then
    [ "$before" -lt "$wanted" ] || { printf '%-18s %12d %12d %10s  %s\n' "$target" 0 "$before" - "done before"; continue; }
    limit="-runs=$((wanted - before))"
  fi
  log=$fuzz/findings/$target.log
  result=clean
  set -- "$corpus" "$seeds/$target"
  [ -d "$past" ] && set -- "$@" "$past"
  # Malloc of what a length field promises is refused by bad_alloc, not by the fuzzer's own limit.
  "$fuzz/bin/fuzz_$target" "$limit" -max_len=8192 -timeout=20 -rss_limit_mb=3000 -malloc_limit_mb=0 \
      -print_final_stats=1 -artifact_prefix="$fuzz/findings/$target-" "$@" >"$log" 2>&1 || { result="FOUND, see $log"; status=1; }
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  echo $((before + ${runs:-0})) >"$fuzz/runs/$target"
  printf '%-18s %12d %12d %10d  %s\n' "$target" "${runs:-0}" $((before + ${runs:-0})) "${rate:-0}" "$result"
done
exit $status
