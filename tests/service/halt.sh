#!/bin/sh
# halt.sh FOLDER: powers off what boot.sh booted, and leaves nothing of it but its logs.
set -eu
folder=$1
[ -e "$folder/init" ] || exit 0
init=$(cat "$folder/init") host=$(cat "$folder/host")
nsenter -t "$init" -a systemctl --no-block poweroff >/dev/null 2>&1 || true
tries=0
while [ -d "/proc/$init" ] && [ $tries -lt 150 ]; do tries=$((tries + 1)); sleep 0.1; done
[ -d "/proc/$init" ] && echo "the container did not power off; it is killed" && kill -9 "$host"
# nspawn outlives its container by a moment.
for groups in /sys/fs/cgroup /sys/fs/cgroup/unified; do
  leaving=0
  while [ -d "$groups/foothold-$host" ] && [ $leaving -lt 50 ]; do
    find "$groups/foothold-$host" -depth -type d -exec rmdir {} \; 2>/dev/null || true
    leaving=$((leaving + 1))
    sleep 0.1
  done
done
rm -f "$folder/init" "$folder/host"
[ $tries -lt 150 ]
