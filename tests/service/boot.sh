#!/bin/sh
# boot.sh FOLDER DEB: boots a Debian 12 with a real systemd in a container of its own: its files over the kept tree (tree.sh), its
# network nothing but loopback, the package at /root/foothold.deb, this folder's guest/ at /root/guest. Returns when it is up;
# FOLDER/init then holds the process id of its init. Exits 77 with the reason if this machine cannot do it.
set -eu
folder=$1 deb=$2
here=$(dirname "$(realpath "$0")")
cannot() { echo "SKIPPED: $*"; echo "$*" >"$folder/skipped"; exit 77; }

rm -rf --one-file-system "$folder"
mkdir -p "$folder/root"
[ "$(id -u)" -eq 0 ] || cannot "the tests of the service need root"
command -v systemd-nspawn >/dev/null || cannot "there is no systemd-nspawn (package systemd-container)"
tree=$("$here/tree.sh" "$deb" 2>"$folder/tree.log") || cannot "$(cat "$folder/tree.log")"
unshare --mount true 2>/dev/null || cannot "this kernel or container allows no mount namespace"

# A private mount namespace: a fresh /run, cgroups of version 2 alone, and the container's files in memory over the tree.
export folder tree deb here
setsid unshare --mount --propagation private sh -euc '
  mount -t tmpfs -o mode=755 tmpfs /run
  if [ "$(stat -fc %T /sys/fs/cgroup)" != cgroup2fs ]; then umount -R /sys/fs/cgroup; mount -t cgroup2 cgroup2 /sys/fs/cgroup; fi
  mkdir /sys/fs/cgroup/foothold-$$
  echo $$ >/sys/fs/cgroup/foothold-$$/cgroup.procs
  mkdir "$folder/memory"
  mount -t tmpfs tmpfs "$folder/memory"
  mkdir "$folder/memory/upper" "$folder/memory/work"
  mount -t overlay -o "lowerdir=$tree,upperdir=$folder/memory/upper,workdir=$folder/memory/work" overlay "$folder/root"
  cp "$deb" "$folder/root/root/foothold.deb"
  cp -r "$here/guest" "$folder/root/root/guest"
  echo $$ >"$folder/host"
  exec systemd-nspawn --quiet --boot -D "$folder/root" --register=no --keep-unit --private-network --capability=all \
    --system-call-filter=bpf --console=pipe --hostname=robot' </dev/null >"$folder/nspawn.log" 2>&1 &

# Its init is the first process of init.scope; seen from here, by whatever mount of version 2 this machine has.
groups=/sys/fs/cgroup
[ -d $groups/unified ] && groups=$groups/unified
tries=0
while [ $tries -lt 300 ]; do
  host=$(cat "$folder/host" 2>/dev/null) || host=none
  init=$(head -n 1 "$groups/foothold-$host/payload/init.scope/cgroup.procs" 2>/dev/null) || init=""
  if [ -n "$init" ] && nsenter -t "$init" -a test -S /run/dbus/system_bus_socket 2>/dev/null; then
    echo "$init" >"$folder/init"
    state=$(nsenter -t "$init" -a timeout 60 systemctl is-system-running --wait) || true
    [ "$state" = running ] || echo "the system is '$state'"
    exit 0
  fi
  tries=$((tries + 1))
  sleep 0.1
done
cat "$folder/nspawn.log"
cannot "the container did not boot"
