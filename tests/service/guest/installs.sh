# The package installs, and the server runs: enabled, ready, with every robot, as a user of its own.
. /root/guest/lib.sh
all_files >$work/files-before
dpkg -i /root/foothold.deb
systemctl is-active $unit
systemctl is-enabled $unit
systemd-analyze verify --man=no $unit foothold.slice
foothold --timeout 20 robots >$work/robots
for file in /etc/foothold/robots/*.yaml; do
  grep -q "^$(basename "$file" .yaml)  *ready" $work/robots || fail "$file is not ready: $(cat $work/robots)"
done
[ "$(stat -c %u /proc/"$(pid)")" -ge 61184 ] || fail "not a dynamic user: $(stat -c %u /proc/"$(pid)")"
[ "$(stat -c %a /var/lib/private/footholdd)" = 700 ] || fail "others may look into the state"
grep -q "^0::.*/foothold.slice/$unit" /proc/"$(pid)"/cgroup || fail "not in its slice: $(cat /proc/"$(pid)"/cgroup)"

# Planners of the administrator's own: their libraries and their robots' files.
mkdir -p /usr/local/lib/foothold
cp /root/many.so /usr/local/lib/foothold/walker.so
cp /root/memory.so /usr/local/lib/foothold/eater.so
cp /root/guest/walker.yaml /root/guest/eater.yaml /etc/foothold/robots/
systemctl restart $unit
foothold --timeout 20 robots walker
foothold doctor >$work/doctor || fail "the doctor is not content: $(cat $work/doctor)"
