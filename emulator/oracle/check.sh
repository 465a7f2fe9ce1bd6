#!/bin/sh
# Rebuilds the oracle's programs, runs them on QEMU, and compares with the hashes committed in expected/.
# With --update writes both the programs (elf/) and the hashes anew.
#
# Needs qemu-system-arm, python3, and the Rust target thumbv7em-none-eabihf (rustup target add).
set -eu
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-target}
python3 generate.py
cargo build --release --locked --target-dir "$target"
version=$(qemu-system-arm --version | head -n 1)
failed=0
for name in instructions exceptions mix; do
    elf=$target/thumbv7em-none-eabihf/release/$name
    actual=$(mktemp)
    {
        echo "# $version, -M mps2-an386 -icount shift=0"
        qemu-system-arm -M mps2-an386 -nographic -semihosting -icount shift=0 -kernel "$elf" 2>&1 </dev/null
    } >"$actual"
    if [ "${1:-}" = --update ]; then
        mkdir -p elf expected
        cp "$elf" "elf/$name.elf"
        chmod 644 "elf/$name.elf"
        cp "$actual" "expected/$name.txt"
    elif diff -I '^#' "expected/$name.txt" "$actual"; then
        echo "$name: $(grep -vc '^#' "$actual") hashes agree"
    else
        failed=1
    fi
    rm -f "$actual"
done
exit $failed
