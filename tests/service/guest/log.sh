# What the server writes of a request is found in systemd's journal by the request, the robot and the final state.
. /root/guest/lib.sh
fresh
foothold plan $requests/template-straight.yaml >$work/logged
id=$(id_of logged)
journalctl --sync
journalctl -o cat -u $unit FOOTHOLD_REQUEST="$id" FOOTHOLD_ROBOT=template FOOTHOLD_STATE=SUCCEEDED | grep . ||
  fail "not found by its fields: $(journalctl -u $unit -o export -n 5)"
