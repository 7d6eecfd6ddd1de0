# DDS Security inside the sandbox, as the shipped drop-in says: the keys stay root's, the server gets them from systemd; who has
# credentials is served, who has none sees no server. For either vendor of the server.
. /root/guest/lib.sh
fresh
dropins=/etc/systemd/system/$unit.d
settings=/etc/foothold/footholdd.yaml
cp $settings $work/open.yaml
foothold security init $work/authority
foothold security issue robot --role server --authority $work/authority -o /etc/foothold/security
foothold security issue operator --role client --authority $work/authority -o $work/operator
[ "$(stat -c '%U %a' /etc/foothold/security/identity.key)" = 'root 600' ] || fail "the server's key is not root's alone"
mkdir -p $dropins
cp /usr/share/doc/foothold/examples/dds-security.conf $dropins/
systemctl daemon-reload
for server in fastdds cyclone; do
  sed "s|^  vendor: [a-z]*|  vendor: $server|; s|^  # security: .*|  security: /run/credentials/$unit|" $work/open.yaml >$settings
  systemctl restart $unit
  for client in cyclone fastdds; do
    foothold --timeout 20 --dds $client --security $work/operator plan $requests/template-straight.yaml >$work/plan 2>&1 ||
      fail "$client to $server: $(cat $work/plan)"
  done
  code=0
  foothold --timeout 2 --dds $server plan $requests/template-straight.yaml >$work/plan 2>&1 || code=$?
  [ $code -eq 9 ] || fail "without credentials, $server: $code $(cat $work/plan)"
done
rm -r $dropins /etc/foothold/security
cp $work/open.yaml $settings
systemctl daemon-reload
systemctl restart $unit
