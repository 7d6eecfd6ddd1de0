# After kill -9 the server is back within two seconds, and nothing is lost: what was done is still known, what asked for it is
# planned again to the same steps, the rest ends with the reason.
. /root/guest/lib.sh
fresh
foothold plan $requests/template-straight.yaml >$work/done
begin_plan resumed $walk_resumed --set steps=100
begin_plan ended $walk --set steps=400
for i in 1 2 3 4 5 6; do begin_plan waiting$i $walk_resumed; done   # more than there are workers
until_true 10 has_steps resumed
until_true 10 has_steps ended
! ended resumed || fail "the machine is too slow for this check: the plan to be resumed has ended before the kill"

old=$(pid)
restarts=$(property NRestarts)
begin=$(milliseconds)
kill -9 "$old"
until_true 2 serves_as_other_than "$old" || fail "not back within 2 s"
echo "back after $(($(milliseconds) - begin)) ms"
[ "$(property NRestarts)" = $((restarts + 1)) ] || fail "restarted $(property NRestarts) times"
! workers_of "$old" || fail "a worker has outlived its server"

expect_end ended 20 4
grep -q SERVER_RESTARTED $work/ended || fail "another reason: $(cat $work/ended)"
for plan in waiting1 waiting2 waiting3 waiting4 waiting5 waiting6; do
  expect_end $plan 40 0
  steps_of $plan >$work/steps
  seq 0 39 | cmp - $work/steps || fail "$plan has other steps: $(cat $work/$plan)"
done
expect_end resumed 40 0
steps_of resumed >$work/steps
seq 0 99 | cmp - $work/steps || fail "the resumed plan has other steps: $(cat $work/resumed)"
foothold state "$(id_of done)" | grep -q SUCCEEDED || fail "what was done is forgotten"
