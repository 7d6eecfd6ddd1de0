# A reload while the server plans: the same process goes on, the plan ends on the worker that it began on, the planner's new library
# gets new workers and a new robot is served. A fault in the settings fails the reload, and changes nothing.
. /root/guest/lib.sh
fresh
begin_plan during $walk --set steps=100
until_true 10 has_steps during
old=$(pid)
workers_of "$old" | sort >$work/workers-before

dpkg -i /root/hopper.deb
cp /usr/local/lib/foothold/walker.so $work/walker.so
mv $work/walker.so /usr/local/lib/foothold/walker.so   # another file, as an upgrade of a planner's package makes it
systemctl reload $unit
begun_anew() { workers_of "$old" | sort >$work/workers-after && [ "$(comm -13 $work/workers-before $work/workers-after | wc -l)" -ge 4 ]; }
until_true 10 begun_anew || fail "no new workers: $(cat $work/workers-after)"
! ended during || fail "the machine is too slow for this check: the plan has ended before the reload was done"
sed 's/^robot: .*/robot: hopper/' $requests/template-straight.yaml >$work/hop.yaml
until_true 10 foothold plan $work/hop.yaml
expect_end during 20 0
steps_of during >$work/steps
seq 0 99 | cmp - $work/steps || fail "the plan has other steps: $(cat $work/during)"
foothold plan $walk --set steps=2 | grep SUCCEEDED
[ "$(pid)" = "$old" ] || fail "the server was restarted"

cp /etc/foothold/footholdd.yaml $work/good.yaml
echo 'quene_limit: 3' >>/etc/foothold/footholdd.yaml
! systemctl reload $unit 2>/dev/null || fail "a reload with a fault in the settings succeeded"
journalctl --sync
journalctl -u $unit --since -10s | grep 'quene_limit: is not known here'
cp $work/good.yaml /etc/foothold/footholdd.yaml
dpkg -P foothold-planner-hopper
systemctl reload $unit
foothold plan $requests/template-straight.yaml | grep SUCCEEDED
[ "$(pid)" = "$old" ] && [ "$(systemctl is-active $unit)" = active ]
