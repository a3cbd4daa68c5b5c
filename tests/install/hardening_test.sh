#!/usr/bin/env bash
# hardening_test.sh PROGRAM...: what the linker and compiler were asked to protect is protected.
set -euo pipefail
for program in "$@"; do
    elf=$(LC_ALL=C readelf --wide --headers --dynamic --dyn-syms "$program")
    demand() { grep -qE "$1" <<<"$elf" || { echo "$program: $2" >&2; exit 1; }; }
    demand 'Type: +DYN' 'is not position-independent'
    demand 'GNU_RELRO' 'relocations stay writable'
    demand 'FLAGS.*(NOW|BIND_NOW)' 'symbols are bound late'
    demand 'GNU_STACK.* RW +0x' 'the stack is executable'
    demand '__stack_chk_fail' 'no canaries on the stack'
    demand '__[a-z]+_chk' 'no checked copies'
done
