#!/usr/bin/env bash
# install_test.sh BUILD WORK [compiler flag...]: installs BUILD into WORK, then builds and runs a project that knows only what was installed.
set -euo pipefail
here=$(dirname "$(realpath "$0")") build=$1 work=$2
shift 2
rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
cmake -S "$here" -B "$work/user" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" \
    -DCMAKE_CXX_FLAGS="$*" >"$work/configure.log"
cmake --build "$work/user" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
found=$("$work/user/user" "$work/prefix/share/yarte/scenes/glass/glass.yarte")
[[ $found == "8 bodies" ]] || { echo "the installed libraries found: $found"; exit 1; }
for program in yarte yarte-convert yarte-validate; do "$work/prefix/bin/$program" --version; done
