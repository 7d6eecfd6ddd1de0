#!/bin/sh
# memory.sh FOLDER: guest/eats.sh under a limit of memory. Where the kernel offers the memory controller to the container, the limit
# is the slice's own; where it is bound to control groups of version 1, what runs in the slice is put into such a group from here.
# Exits 77 where there is neither.
set -eu
folder=$1
here=$(dirname "$(realpath "$0")")
[ -e "$folder/skipped" ] && { echo "SKIPPED: $(cat "$folder/skipped")"; exit 77; }
groups=/sys/fs/cgroup
[ -d $groups/unified ] && groups=$groups/unified
slice=$groups/foothold-$(cat "$folder/host")/payload/foothold.slice
old=/sys/fs/cgroup/memory
[ -e "$slice/memory.max" ] && exec "$here/run.sh" "$folder" eats
[ -e $old/memory.limit_in_bytes ] || { echo "SKIPPED: this kernel offers no memory controller to a container"; exit 77; }

group=$old/foothold-$$
move() { while read -r process; do echo "$process" >"$2/cgroup.procs" || true; done <"$1"; }
finish() { move $group/cgroup.procs $old; rmdir $group; }
mkdir $group
trap finish EXIT
echo 512M >$group/memory.limit_in_bytes
move "$slice/footholdd.service/cgroup.procs" $group
"$here/run.sh" "$folder" eats
