#!/bin/sh
# generate.sh classes|descriptors FILE.idl DIR: runs one of the two IDL generators; any warning is an error.
set -eu
case "$1" in
  classes)     tool="fastddsgen -replace -cs -d $3 -I $(dirname "$2") $2" ;;
  descriptors) tool="idlc -l c -o $3 -I $(dirname "$2") $2" ;;
  *) echo "generate.sh: classes or descriptors, not '$1'" >&2; exit 2 ;;
esac
log=$($tool 2>&1) || { echo "$log" >&2; exit 1; }
if echo "$log" | grep -i -q -E 'warning|error'; then echo "$log" >&2; exit 1; fi
