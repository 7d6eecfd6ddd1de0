# A robot's network as OPERATING.md says: the shipped DDS configurations and the shipped drop-in, with the addresses put in. Without
# the drop-in the kernel lets nothing through, whatever the configuration says.
. /root/guest/lib.sh
fresh
dropins=/etc/systemd/system/$unit.d
settings=/etc/foothold/footholdd.yaml
cp $settings $work/open.yaml
mkdir -p /etc/foothold/dds
# Not loopback besides: server and clients are on one host here, and are to meet on the network.
for vendor in cyclone fastdds; do
  sed 's/10\.0\.0\.[0-9]*/10.99.0.1/g; /<address>127/d' /usr/share/foothold/dds/$vendor-robot-network.xml >/etc/foothold/dds/$vendor.xml
done
asks() {
  foothold --timeout "$2" --dds "$1" --network /etc/foothold/dds/"$1".xml plan $requests/template-straight.yaml >$work/plan 2>&1
}
for server in fastdds cyclone; do
  sed "s|^  vendor: [a-z]*|  vendor: $server|; s|^  # network_config: .*|  network_config: dds/$server.xml|" $work/open.yaml >$settings
  systemctl restart $unit
  code=0
  asks $server 2 || code=$?
  [ $code -eq 9 ] || fail "without the drop-in, $server: $code $(cat $work/plan)"
  mkdir -p $dropins
  sed 's|10\.0\.0\.0/24|10.99.0.0/24|' /usr/share/doc/foothold/examples/robot-network.conf >$dropins/robot-network.conf
  systemctl daemon-reload
  systemctl restart $unit
  for client in cyclone fastdds; do
    asks $client 20 || fail "$client to $server: $(cat $work/plan)"
  done
  rm -r $dropins
  systemctl daemon-reload
done
rm -r /etc/foothold/dds
cp $work/open.yaml $settings
systemctl restart $unit
