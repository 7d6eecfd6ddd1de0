# What the checks share. Sourced by each, as root in the booted container, with `set -eu`.
unit=footholdd.service
requests=/usr/share/foothold/requests
work=/root/work
mkdir -p $work

fail() { echo "FAILED: $*"; exit 1; }
property() { systemctl show --property "$1" --value $unit; }
pid() { property MainPID; }
milliseconds() { echo $(($(date +%s%N) / 1000000)); }

# until_true SECONDS COMMAND...: the command, again and again, until it succeeds.
until_true() {
  patience=$(($(milliseconds) + $1 * 1000))
  shift
  until "$@" >$work/until 2>&1; do
    [ "$(milliseconds)" -lt $patience ] || { cat $work/until; return 1; }
    sleep 0.05
  done
}

serves() { systemctl is-active $unit && [ "$(property StatusText)" != "" ]; }
serves_as_other_than() { [ "$(pid)" != 0 ] && [ "$(pid)" != "$1" ] && serves; }

# Starts counting starts afresh: a check must not be refused a restart for what the one before it did.
fresh() { systemctl reset-failed $unit 2>/dev/null || true; systemctl is-active --quiet $unit || systemctl start $unit; }

# Every file of the system but what the system itself keeps: its logs, its packages' names, this test.
all_files() {
  find / -xdev \( -path /proc -o -path /sys -o -path /run -o -path /tmp -o -path /dev -o -path /root -o -path /var/log -o -path /var/lib/dpkg \
    -o -path /var/tmp -o -path /var/lib/systemd/catalog -o -path /var/cache/ldconfig \) -prune -o -print | sort
}

# begin_plan NAME REQUEST [OPTION...]: plans in the background; what it prints and its exit code are in $work/NAME*.
begin_plan() {
  name=$1
  shift
  rm -f "$work/$name.code"
  { code=0; foothold --timeout 20 plan "$@" >"$work/$name" 2>&1 || code=$?; echo $code >"$work/$name.code"; } &
}
walk=/root/guest/walk.yaml
{ cat $walk; echo 'resume: true'; } >$work/walk-resumed.yaml
walk_resumed=$work/walk-resumed.yaml
has_steps() { grep -q '^ *[0-9][0-9]* .* step [0-9]' "$work/$1"; }
steps_of() { sed -n 's/^ *[0-9][0-9]*  .* step \([0-9][0-9]*\) .*/\1/p' "$work/$1"; }
ended() { [ -s "$work/$1.code" ]; }
# end_of NAME SECONDS: waits, and prints the exit code, which tells the final state (foothold --help).
end_of() { until_true "$2" ended "$1" || fail "plan $1 has no end: $(cat "$work/$1")"; cat "$work/$1.code"; }
id_of() { grep -o -m 1 '[0-9a-f]\{32\}' "$work/$1"; }
expect_end() {
  code=$(end_of "$1" "$2")
  [ "$code" = "$3" ] || fail "plan $1 ended with $code instead of $3: $(cat "$work/$1")"
}
workers_of() {
  found=1
  for process in /proc/[0-9]*; do
    if tr '\0' ' ' 2>/dev/null <"$process/cmdline" | grep -q "^/usr/lib/foothold/foothold-worker --daemon $1 "; then
      echo "${process#/proc/}"
      found=0
    fi
  done
  return $found
}
