# A planner's package of one's own, built from the template against the installed headers alone, and a client built the same way:
# installed beside the server, the one is planned with, the other served, of either vendor.
. /root/guest/lib.sh
fresh
old=$(pid)
dpkg -i /root/hopper.deb   # its trigger reloads the server
sed 's/^robot: .*/robot: hopper/' $requests/template-straight.yaml >$work/hop.yaml
until_true 20 foothold plan $work/hop.yaml
for vendor in cyclone fastdds; do
  /root/plan_and_print 0 $vendor >$work/printed
  grep '^goal reached' $work/printed || fail "$vendor: $(cat $work/printed)"
done
dpkg -P foothold-planner-hopper
withdrawn() { foothold robots | grep '^hopper  *unavailable'; }
until_true 20 withdrawn
[ "$(pid)" = "$old" ] || fail "the server was restarted"
