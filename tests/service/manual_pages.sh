#!/bin/sh
# manual_pages.sh SOURCE BIN: the pages that were written by hand tell every option that the program has, and none that it has not.
set -eu
source=$1 bin=$2
for page in server/footholdd.8 plugins/toolkit/terrain/tools/foothold-terrain.1 plugins/toolkit/truss/tools/foothold-truss.1; do
  program=$(basename "$page" | sed 's/\.[18]$//')
  told=$(sed 's/\\-/-/g' "$source/$page" | grep -o -e '--[a-z][a-z-]*' | sort -u)
  had=$("$bin/$program" --help | grep -o -e '^ *-[^ ]*' | grep -o -e '--[a-z][a-z-]*' | sort -u)
  [ -n "$had" ] || { echo "$program --help has no options"; exit 1; }
  [ "$told" = "$had" ] || { printf '%s tells\n%s\nbut the program has\n%s\n' "$page" "$told" "$had"; exit 1; }
done
