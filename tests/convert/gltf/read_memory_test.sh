#!/usr/bin/env bash
# read_memory_test.sh SOURCES READ_ALONE FOLDER: reading a .glb takes at most five times the memory that the file has bytes.
set -euo pipefail
sources=$1 read=$2 folder=$3
mkdir -p "$folder"
"$sources/tests/bench/height_field.py" 600 "$folder/large.glb" smooth
bytes=$(stat -c %s "$folder/large.glb")
for what in mesh scene; do
    peak=$("$read" "$what" "$folder/large.glb" | cut -d' ' -f2)
    echo "as a $what: $peak MB for a file of $bytes bytes"
    awk -v peak="$peak" -v bytes="$bytes" 'BEGIN { exit !(peak > 0 && peak * 1e6 <= 5 * bytes) }'
done
rm "$folder/large.glb"
