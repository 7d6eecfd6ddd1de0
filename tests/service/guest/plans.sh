# A plan for every robot, over every pair of vendors; the server's vendor is changed as an administrator does it.
. /root/guest/lib.sh
for server in fastdds cyclone; do
  sed -i "s/^  vendor: [a-z]*/  vendor: $server/" /etc/foothold/footholdd.yaml
  systemctl restart $unit
  for client in cyclone fastdds; do
    for file in /etc/foothold/robots/*.yaml; do
      robot=$(basename "$file" .yaml)
      [ ! -e /root/guest/"$robot".yaml ] || continue
      request=$(ls $requests/"$robot"-*.yaml | head -n 1)
      [ "$robot" = hyrecro ] && request=$requests/hyrecro-crossed-beams.yaml
      [ "$robot" = octopod ] && request=$requests/octopod-pa.yaml
      [ -e "$request" ] || fail "no request for $robot"
      foothold --timeout 20 --dds $client plan "$request" >$work/plan 2>&1 || fail "$robot, $client to $server: $(cat $work/plan)"
      grep -q SUCCEEDED $work/plan || fail "$robot, $client to $server: $(cat $work/plan)"
      echo "$robot $client to $server: $(grep -m 1 SUCCEEDED $work/plan)"
    done
  done
done
