# Figures and health over HTTP inside the sandbox: there on loopback, and only there.
. /root/guest/lib.sh
fresh
get() { bash -c "exec 3<>/dev/tcp/$1/9747 && printf 'GET $2 HTTP/1.0\r\n\r\n' >&3 && cat <&3"; }
foothold plan $requests/template-straight.yaml >$work/plan
get 127.0.0.1 /healthz | grep '200 OK'
get 127.0.0.1 /metrics >$work/metrics
grep '^foothold_[a-z_]*{.*SUCCEEDED.*} [1-9]' $work/metrics || fail "the plan is not counted: $(cat $work/metrics)"
! get 10.99.0.1 /healthz 2>/dev/null || fail "figures are shown past loopback"
