#!/bin/sh
# own_planner.sh BUILD FOLDER [CMAKE-OPTION...]: does what plugins/template/README.md says, with nothing but what the package
# foothold-dev installs: copies the template, calls it hopper, builds it, makes its package FOLDER/hopper.deb. Beside it the client
# to copy is built: FOLDER/client/plan_and_print.
set -eu
build=$1 folder=$2
shift 2
rm -rf "$folder"
mkdir -p "$folder"
cmake --install "$build" --component dev --prefix "$folder/usr" >/dev/null
examples=$folder/usr/share/doc/foothold-dev/examples

cp -r "$examples/template" "$folder/hopper"
mv "$folder/hopper/template.yaml" "$folder/hopper/hopper.yaml"
sed -i 's/template/hopper/g' "$folder/hopper/CMakeLists.txt" "$folder/hopper/hopper.yaml"
cmake -S "$folder/hopper" -B "$folder/hopper/build" -G Ninja -Dfoothold_DIR="$folder/usr/lib/cmake/foothold" "$@" >"$folder/log"
cmake --build "$folder/hopper/build" >>"$folder/log"
"$build/bin/foothold-worker" --describe "$folder/hopper/build/plugins/hopper.so" --robot "$folder/hopper/hopper.yaml"
(cd "$folder/hopper/build" && cpack >>"$folder/log")
mv "$folder"/hopper/build/foothold-planner-hopper_*.deb "$folder/hopper.deb"

cmake -S "$examples/client" -B "$folder/client" -G Ninja -Dfoothold_DIR="$folder/usr/lib/cmake/foothold" "$@" >>"$folder/log"
cmake --build "$folder/client" >>"$folder/log"
