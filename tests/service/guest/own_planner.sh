# A planner's package of one's own, built from the template against the installed headers alone, and a client built the same way:
# installed beside the server, the one is planned with, the other served, of either vendor.
. /root/guest/lib.sh
fresh
dpkg -i /root/hopper.deb
systemctl restart $unit
sed 's/^robot: .*/robot: hopper/' $requests/template-straight.yaml >$work/hop.yaml
foothold --timeout 20 plan $work/hop.yaml | grep SUCCEEDED
for vendor in cyclone fastdds; do
  /root/plan_and_print 0 $vendor >$work/printed
  grep '^goal reached' $work/printed || fail "$vendor: $(cat $work/printed)"
done
dpkg -P foothold-planner-hopper
systemctl restart $unit
