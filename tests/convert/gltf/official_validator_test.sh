#!/usr/bin/env bash
# official_validator_test.sh SOURCE BIN WORK: Khronos's validator finds nothing wrong in what every scene becomes, as .glb
# and as .gltf. Exit code 77: the validator is not installed (ci/setup-validator).
set -euo pipefail
source=$1 bin=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
for scene in "$source"/scenes/*/*.yarte; do
    name=$(basename "$scene" .yarte)
    "$bin/yarte-convert" "$scene" "$work/$name.glb" 2>"$work/$name.log"
    "$bin/yarte-convert" "$scene" "$work/$name.gltf" 2>>"$work/$name.log"
done
status=0
"$source/ci/gltf-validate" "$work"/*.glb "$work"/*.gltf || status=$?
((status == 3)) && exit 77
exit "$status"
