# Where the slice's memory ends, the kernel ends the worker that eats it, and neither the server nor another plan: memory.sh has set
# a limit, here or from outside.
. /root/guest/lib.sh
fresh
limit=/sys/fs/cgroup/foothold.slice/memory.max
[ -e $limit ] && systemctl set-property --runtime foothold.slice MemoryMax=512M MemoryHigh=infinity
old=$(pid)
begin_plan during $walk --set steps=100
until_true 10 has_steps during
printf 'robot: eater\nbudget: 60\n' >$work/eat.yaml
begin_plan eater $work/eat.yaml
expect_end eater 60 7
grep 'SIGKILL' $work/eater || fail "ended otherwise: $(cat $work/eater)"
[ "$(pid)" = "$old" ] || fail "the server was ended, not the worker"
expect_end during 40 0
begin_plan again $walk --set steps=2
expect_end again 20 0
[ ! -e $limit ] || systemctl revert foothold.slice
