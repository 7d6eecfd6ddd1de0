# A server that cannot run ends in `failed` instead of starting for ever; a fault in its configuration is not even tried twice.
. /root/guest/lib.sh
dropins=/run/systemd/system/$unit.d
systemctl stop $unit
mkdir -p $dropins
printf '[Service]\nEnvironment=FOOTHOLD_BUS_DIR=/nowhere\n' >$dropins/crash.conf   # no DDS: it ends with 4
systemctl daemon-reload
systemctl reset-failed $unit
begin=$(date '+%F %T')
systemctl start $unit 2>/dev/null || true
until_true 20 systemctl is-failed $unit
sleep 1
systemctl is-failed $unit
journalctl --sync
journalctl -u $unit --since "$begin" | grep 'Start request repeated too quickly'
[ "$(property NRestarts)" -ge 4 ] || fail "gave up after $(property NRestarts) restarts"
rm $dropins/crash.conf
systemctl daemon-reload

cp /etc/foothold/footholdd.yaml $work/good.yaml
echo 'quene_limit: 3' >>/etc/foothold/footholdd.yaml
systemctl reset-failed $unit
begin=$(date '+%F %T')
! systemctl start $unit 2>/dev/null || fail "started with a fault in its configuration"
systemctl is-failed $unit
[ "$(property NRestarts)" = 0 ] || fail "tried again with the same configuration"
journalctl --sync
journalctl -u $unit --since "$begin" | grep 'footholdd.yaml:[0-9]*: quene_limit: is not known here'
cp $work/good.yaml /etc/foothold/footholdd.yaml
fresh
systemctl is-active $unit
