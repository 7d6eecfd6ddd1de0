#!/bin/sh
# example_client.sh BIN CONFIG: the client of clients/cpp/examples against a real footholdd, on loopback, of either vendor.
set -eu
bin=$1 config=$2
state=$(mktemp -d)
server=""
finish() {
  [ -z "$server" ] || { kill "$server" && wait "$server" || true; }
  rm -rf "$state"
}
trap finish EXIT

for vendor in cyclone fastdds; do
  "$bin/footholdd" --config "$config" --state-dir "$state/$vendor" --dds cyclone --domain 61 2>"$state/log" &
  server=$!
  if ! "$bin/plan_and_print" 61 "$vendor" >"$state/plan"; then
    cat "$state/plan" "$state/log" >&2
    exit 1
  fi
  [ "$(grep -c ' holds, ' "$state/plan")" -ge 2 ] && grep -q '^goal reached, .* proved least' "$state/plan" || { cat "$state/plan" >&2; exit 1; }
  kill "$server"
  wait "$server"
  server=""
done
