#!/bin/sh
# tree.sh DEB: prints the folder of a Debian 12 tree with systemd and what the package depends on, but not the package. Made once for
# each set of dependencies (needs root and apt's servers: about a minute) and kept in ~/.cache/foothold; ./test makes it before it
# leaves the network. Says on stderr why it cannot and exits 1.
set -eu
deb=$1
fail() { echo "tree.sh: $*" >&2; exit 1; }

depends=$(dpkg-deb -f "$deb" Depends | sed 's/([^)]*)//g; s/|[^,]*//g; s/ //g')
packages=systemd-sysv,dbus,libnss-systemd,$depends
key=$(echo "$packages" | sha256sum | cut -c1-12)
trees=${XDG_CACHE_HOME:-$HOME/.cache}/foothold
tree=$trees/bookworm-$key
[ -e "$tree/complete" ] && { echo "$tree/root"; exit 0; }

[ "$(id -u)" -eq 0 ] || fail "needs root"
command -v mmdebstrap >/dev/null || fail "needs mmdebstrap"
rm -rf "$tree"
mkdir -p "$tree"
sources=/etc/apt/sources.list.d/debian.sources
[ -e $sources ] || sources=""
# shellcheck disable=SC2086
mmdebstrap --quiet --variant=essential --components=main --include="$packages" bookworm "$tree/root" $sources >"$tree/log" 2>&1 ||
  fail "mmdebstrap failed: $(tail -5 "$tree/log")"
touch "$tree/complete"
echo "$tree/root"
