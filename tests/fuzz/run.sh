#!/bin/sh
# tests/fuzz/run.sh [--seconds N | --runs N] [--idle] [TARGET...]: the fuzzers of build/fuzz, one behind the other, each for N seconds
# (60) or until it has made N runs in all, those of earlier calls counted. --idle: only while nothing else wants the processor.
# What they learn is kept in build/fuzz/corpus, what they find in build/fuzz/findings. A table of runs; exit code 1 if anything was
# found, else 3 if a target is not built (cmake --build --preset fuzz). A fuzzer that gets SIGINT ends with its runs counted.
#
# With --seconds leaks are looked for at every run, and inputs are chosen by how rare what they reach is. With --runs, where both
# would take a third of the time, any of the corpus is as good as any other, and leaks are looked for at the end, over all of it.
set -eu
cd "$(dirname "$0")/../.."
seconds=60 wanted=0 prefix= patience=20
while [ $# -gt 0 ]; do
  case "$1" in
    --seconds) seconds=${2:?--seconds needs a number}; shift 2 ;;
    --runs) wanted=${2:?--runs needs a number} seconds=0; shift 2 ;;
    --idle) prefix="chrt --idle 0" patience=300; shift ;;  # a run may stand still for long
    -h|--help) sed -n '2,8s/^# \{0,1\}//p' "$0"; exit 0 ;;
    -*) echo "run.sh: unknown argument '$1'; see --help" >&2; exit 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- $(ls tests/fuzz/targets | sed 's/\.cpp$//')

export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/leaks.txt:print_suppressions=0"
# Two frames of where memory came from, and 1 MB of freed memory that is watched: most runs free less, and what does not fit the
# processor's cache halves the runs a second.
export ASAN_OPTIONS="detect_leaks=1:allocator_may_return_null=1:detect_stack_use_after_return=0:malloc_context_size=2:quarantine_size_mb=1:thread_local_quarantine_size_kb=64"
export UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1"
[ -w /dev/shm ] && export TMPDIR=/dev/shm   # files that are replaced ten thousand times a second are no work for a disk
fuzz=build/fuzz
seeds=$fuzz/seeds
mkdir -p "$fuzz/findings" "$fuzz/runs"
if [ ! -x "$fuzz/bin/foothold-fuzz-seeds" ]; then
  echo "run.sh: $fuzz/bin/foothold-fuzz-seeds is not built: cmake --preset fuzz && cmake --build --preset fuzz" >&2
  exit 3
fi
"$fuzz/bin/foothold-fuzz-seeds" "$seeds"
status=0
printf '%-18s %12s %12s %10s  %s\n' target runs "in all" "a second" result
for target; do
  row() { printf '%-18s %12d %12d %10d  %s\n' "$target" "$1" "$2" "$3" "$4"; }
  if [ ! -x "$fuzz/bin/fuzz_$target" ]; then
    row 0 0 0 "NOT BUILT"
    [ $status -ne 0 ] || status=3
    continue
  fi
  corpus=$fuzz/corpus/$target past=tests/fuzz/corpus/$target
  mkdir -p "$corpus" "$seeds/$target"
  before=$(cat "$fuzz/runs/$target" 2>/dev/null || echo 0)
  set -- -max_total_time="$seconds"
  if [ "$wanted" -gt 0 ]; then
    [ "$before" -lt "$wanted" ] || { row 0 "$before" 0 "done before"; continue; }
    set -- -runs=$((wanted - before)) -detect_leaks=0 -entropic=0
  fi
  # Longer inputs make each run slow and find no more; what is read as octets has its seeds' length. With --runs what is YAML is
  # shorter still: 256 octets reach 98 of 100 branches that 768 do (a robot's file 384), in half the time.
  case $target in
    client_messages|server_messages|worker_frames|journal_*|bundle|credentials) longest=4096 ;;
    urdf) longest=6144 ;;   # less holds no whole robot
    mesh) longest=1024 ;;
    robot_files) longest=$((wanted > 0 ? 384 : 768)) ;;
    *) longest=$((wanted > 0 ? 256 : 768)) ;;
  esac
  folders="$corpus $seeds/$target"
  [ ! -d "$past" ] || folders="$folders $past"
  log=$fuzz/findings/$target.log
  result=clean
  # Malloc of what a length field promises is refused by bad_alloc, not by the fuzzer's own limit.
  limits="-max_len=$longest -timeout=$patience -report_slow_units=$patience -rss_limit_mb=3000 -malloc_limit_mb=0"
  limits="$limits -artifact_prefix=$fuzz/findings/$target-"
  $prefix "$fuzz/bin/fuzz_$target" $limits -print_final_stats=1 "$@" $folders >"$log" 2>&1 || case $? in
    72) result=interrupted ;;
    *) result="FOUND, see $log" status=1 ;;
  esac
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  in_all=$((before + ${runs:-0}))
  echo "$in_all" >"$fuzz/runs/$target"
  if [ "$wanted" -gt 0 ] && [ "$result" = clean ]; then
    $prefix "$fuzz/bin/fuzz_$target" $limits -runs=0 $folders >"$log.leaks" 2>&1 || { result="FOUND, see $log.leaks"; status=1; }
  fi
  row "${runs:-0}" "$in_all" "${rate:-0}" "$result"
done
exit $status
