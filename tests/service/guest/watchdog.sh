# A server that hangs is restarted by the watchdog: the whole process stopped, or only the loop while its other threads run.
. /root/guest/lib.sh
for how in whole loop; do
  fresh
  begin_plan held $walk_resumed
  until_true 10 has_steps held
  old=$(pid)
  begin=$(date '+%F %T')
  if [ $how = whole ]; then
    kill -STOP "$old"
  else
    /root/probe hold "$old" &
  fi
  until_true 20 serves_as_other_than "$old" || fail "not restarted"
  journalctl --sync
  journalctl -u $unit --since "$begin" | grep 'Watchdog timeout' || fail "restarted by something else"
  expect_end held 30 0
done
