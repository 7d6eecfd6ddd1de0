#!/bin/sh
# install-packages.sh: installs what cmake/packages.txt names and this machine lacks. Needs root or sudo only if something is missing.
set -eu
list=$(dirname "$0")/packages.txt
missing=""
for package in $(sed 's/#.*//' "$list"); do
  dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -q '^installed$' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

echo "installing:$missing"
as_root=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install these packages as root, then run this again:$missing" >&2; exit 1; }
  as_root=sudo
fi
log=$(mktemp)
# shellcheck disable=SC2086
if ! { $as_root apt-get update && DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
  tail -20 "$log" >&2
  echo "apt-get could not install:$missing" >&2
  exit 1
fi
rm -f "$log"
