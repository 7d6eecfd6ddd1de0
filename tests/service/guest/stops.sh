# The server stops within five seconds, also while it plans: the client is told, and no process is left.
. /root/guest/lib.sh
fresh
begin_plan cut $walk
begin_plan queued $walk --set steps=400
until_true 10 has_steps cut
old=$(pid)
begin=$(milliseconds)
systemctl stop $unit
took=$(($(milliseconds) - begin))
echo "stopped after $took ms"
[ $took -le 5000 ] || fail "took $took ms"
[ "$(property Result)" = success ] || fail "the stop was not clean: $(property Result)"
for plan in cut queued; do
  expect_end $plan 5 5
  grep -q SERVER_STOPPING $work/$plan || fail "$plan got another reason: $(cat $work/$plan)"
done
! workers_of "$old" || fail "a worker is left"
systemctl start $unit
foothold --timeout 20 state "$(id_of cut)" | grep -q CANCELLED || fail "another state after the start"
