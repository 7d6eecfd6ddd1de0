# An upgrade while the server plans: it is restarted once, the plan ends once, settings and journal stay; and a server that the
# administrator has switched off stays off.
. /root/guest/lib.sh
fresh
rm -rf $work/package
dpkg-deb -R /root/foothold.deb $work/package
sed -i 's/^Version: .*/&+next/' $work/package/DEBIAN/control
dpkg-deb -Zgzip -z1 -b $work/package $work/next.deb
sed -i 's/^name: .*/name: climber/' /etc/foothold/footholdd.yaml
foothold plan $requests/template-straight.yaml >$work/done
begin_plan during $walk --set steps=400
until_true 10 has_steps during

old=$(pid)
begin=$(milliseconds)
dpkg -i $work/next.deb
serves_as_other_than "$old" || fail "the server was not restarted"
echo "upgraded in $(($(milliseconds) - begin)) ms"
expect_end during 10 5
foothold --timeout 20 state "$(id_of during)" >$work/after || true
grep -q CANCELLED $work/after || fail "the plan has another state now: $(cat $work/after)"
foothold state "$(id_of done)" | grep -q SUCCEEDED || fail "the journal is gone"
foothold robots | grep -q '^climber' || fail "the settings are gone: $(foothold robots | head -n 1)"
foothold plan $requests/template-straight.yaml | grep SUCCEEDED

systemctl disable --now $unit
dpkg -i /root/foothold.deb
! systemctl is-enabled $unit || fail "enabled again by an upgrade"
! systemctl is-active $unit || fail "started by an upgrade although it is disabled"
systemctl enable --now $unit
