#!/bin/sh
# boot.sh FOLDER DEB FILE...: boots a Debian 12 with a real systemd in a container of its own: its files over the kept tree (tree.sh), its
# network nothing but loopback, the package at /root/foothold.deb, the files beside it, this folder's guest/ at /root/guest. Returns when it is up;
# FOLDER/init then holds the process id of its init. Exits 77 with the reason if this machine cannot do it.
set -eu
folder=$1 deb=$2
shift 2
here=$(dirname "$(realpath "$0")")
cannot() { echo "SKIPPED: $*"; echo "$*" >"$folder/skipped"; exit 77; }

rm -rf --one-file-system "$folder"
mkdir -p "$folder/root"
[ "$(id -u)" -eq 0 ] || cannot "the tests of the service need root"
command -v systemd-nspawn >/dev/null || cannot "there is no systemd-nspawn (package systemd-container)"
tree=$("$here/tree.sh" "$deb" 2>"$folder/tree.log") || cannot "$(cat "$folder/tree.log")"
unshare --mount true 2>/dev/null || cannot "this kernel or container allows no mount namespace"

# A private mount namespace: a fresh /run, cgroups of version 2 alone, and the container's files in memory over the tree. What a kernel
# or a container around us may forbid comes first, and says so.
export folder tree deb here
setsid unshare --mount --propagation private sh -euc '
  trap "touch $folder/forbidden" EXIT
  mount -t tmpfs -o mode=755 tmpfs /run
  if [ "$(stat -fc %T /sys/fs/cgroup)" != cgroup2fs ]; then umount -R /sys/fs/cgroup; mount -t cgroup2 cgroup2 /sys/fs/cgroup; fi
  mkdir /sys/fs/cgroup/foothold-$$
  echo $$ >/sys/fs/cgroup/foothold-$$/cgroup.procs
  echo $$ >"$folder/host"
  mkdir "$folder/memory"
  mount -t tmpfs tmpfs "$folder/memory"
  mkdir "$folder/memory/upper" "$folder/memory/work"
  mount -t overlay -o "lowerdir=$tree,upperdir=$folder/memory/upper,workdir=$folder/memory/work" overlay "$folder/root"
  trap - EXIT
  cp "$deb" "$folder/root/root/foothold.deb"
  cp "$@" "$folder/root/root/"
  cp -r "$here/guest" "$folder/root/root/guest"
  exec systemd-nspawn --quiet --boot -D "$folder/root" --register=no --keep-unit --private-network --capability=all \
    --system-call-filter=bpf --console=pipe --hostname=robot' sh "$@" </dev/null >"$folder/nspawn.log" 2>&1 &
leader=$!

# Its init is the first process of init.scope; seen from here, by whatever mount of version 2 this machine has.
groups=/sys/fs/cgroup
[ -d $groups/unified ] && groups=$groups/unified
tries=0
while [ $tries -lt 300 ] && [ -d "/proc/$leader" ]; do
  host=$(cat "$folder/host" 2>/dev/null) || host=none
  init=$(head -n 1 "$groups/foothold-$host/payload/init.scope/cgroup.procs" 2>/dev/null) || init=""
  if [ -n "$init" ] && nsenter -t "$init" -a test -S /run/dbus/system_bus_socket 2>/dev/null; then
    echo "$init" >"$folder/init"
    nsenter -t "$init" -n ip address add 10.99.0.1/32 dev lo   # an address that is not loopback's, for what must not be reached
    state=$(nsenter -t "$init" -a timeout 60 systemctl is-system-running --wait) || true
    [ "$state" = running ] || echo "the system is '$state'"
    exit 0
  fi
  tries=$((tries + 1))
  sleep 0.1
done
[ -e "$folder/forbidden" ] && cannot "no mounts for a container: $(tail -n 1 "$folder/nspawn.log")"
cat "$folder/nspawn.log"
echo "FAILED: the container did not boot"
exit 1
