# What the server and its workers cannot do, tried from within its sandbox; and what they must be able to.
. /root/guest/lib.sh
fresh
sed -e 's|^ExecStart=.*|ExecStart=/opt/probe|; s|^Type=.*|Type=oneshot|; /^WatchdogSec/d; /^Restart/d; /^NotifyAccess/d' \
  -e 's|^StateDirectory=.*|StateDirectory=probe|' /lib/systemd/system/$unit >/run/systemd/system/probe.service
cp /root/probe /opt/probe
systemctl daemon-reload
code=0
systemctl start probe.service || code=$?
journalctl --sync
journalctl -o cat -t probe --since -30s >$work/probes
cat $work/probes
rm -rf /opt/probe /run/systemd/system/probe.service /var/lib/private/probe /var/lib/probe
systemctl daemon-reload
[ $code -eq 0 ] || fail "the sandbox has a hole"
[ "$(grep -c '^ok' $work/probes)" -ge 20 ] || fail "only $(grep -c '^ok' $work/probes) probes"

# The probes' doors are there without the sandbox: a probe that can never fail proves nothing.
/root/probe >$work/free || true
[ "$(grep -c '^HOLE' $work/free)" -ge 15 ] || fail "outside of the sandbox only these are open: $(cat $work/free)"

for process in $(pid) $(workers_of "$(pid)"); do
  for line in 'NoNewPrivs:	1' 'Seccomp:	2' 'CapEff:	0000000000000000' 'CapBnd:	0000000000000000'; do
    grep -q "^$line$" "/proc/$process/status" || fail "process $process has not '$line'"
  done
done
systemd-analyze security --threshold=20 $unit | tail -1
for limit in MemoryMax TasksMax; do
  [ "$(systemctl show --property $limit --value foothold.slice)" != infinity ] || fail "the slice has no $limit"
done
# The kernel enforces them where it offers the controllers to a container.
for limit in memory.max pids.max; do
  file=/sys/fs/cgroup/foothold.slice/$limit
  if [ -e $file ]; then [ "$(cat $file)" != max ] || fail "$file is not set"; else echo "no controller for $limit here: the limit is only read back"; fi
done
