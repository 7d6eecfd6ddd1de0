# Removal stops the server and keeps settings and state; purge leaves nothing of either.
. /root/guest/lib.sh
fresh
old=$(pid)
dpkg -r foothold
! [ -d "/proc/$old" ] || fail "the server outlived its package"
[ -e /etc/foothold/footholdd.yaml ] && [ -s /var/lib/private/footholdd/journal.db ] || fail "removal took settings or state"
rm -r /etc/foothold/robots/walker.yaml /usr/local/lib/foothold   # the administrator's own
dpkg -P foothold
all_files >$work/files-after
diff $work/files-before $work/files-after || fail "purge left or took files"
! systemctl cat $unit >/dev/null 2>&1 || fail "systemd still knows the unit"
