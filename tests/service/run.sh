#!/bin/sh
# run.sh FOLDER CHECK: runs guest/CHECK.sh in what boot.sh booted. Exits 77 with the reason if that was not possible.
set -eu
folder=$1 check=$2
[ -e "$folder/skipped" ] && { echo "SKIPPED: $(cat "$folder/skipped")"; exit 77; }
inside() { nsenter -t "$(cat "$folder/init")" -a env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 SYSTEMD_PAGER= DEBIAN_FRONTEND=noninteractive "$@"; }
begin=$(date '+%F %T')
code=0
inside sh -eu "/root/guest/$check.sh" || code=$?
[ $code -eq 0 ] || { echo "---- journal since the check began"; inside journalctl --no-pager --since "$begin" | tail -80; }
exit $code
