# Removal stops the server and keeps settings and state, which the package finds again when it comes back; purge leaves nothing of
# either.
. /root/guest/lib.sh
fresh
foothold plan $requests/template-straight.yaml >$work/done
old=$(pid)
dpkg -r foothold
! [ -d "/proc/$old" ] || fail "the server outlived its package"
[ -e /etc/foothold/footholdd.yaml ] && [ -s /var/lib/private/footholdd/journal.db ] || fail "removal took settings or state"
dpkg -i /root/foothold.deb
systemctl is-enabled $unit
foothold --timeout 20 state "$(id_of done)" | grep SUCCEEDED
dpkg -r foothold
rm -r /etc/foothold/robots/walker.yaml /etc/foothold/robots/eater.yaml /usr/local/lib/foothold   # the administrator's own
dpkg -P foothold
all_files >$work/files-after
diff $work/files-before $work/files-after || fail "purge left or took files"
! systemctl cat $unit >/dev/null 2>&1 || fail "systemd still knows the unit"
