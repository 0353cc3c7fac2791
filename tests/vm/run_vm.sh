#!/usr/bin/env bash
# run_vm.sh DEVICE_PROGRAM HOST_PROGRAM FOLDER: boots a Linux kernel in QEMU and runs both programs in it. FOLDER keeps the
# kernel and the guest's console. Exit status 0: every descriptor passed; 77: QEMU or a kernel is not to be had here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
device=$1 host=$2 folder=$3
kernel=$folder/kernel guest=$folder/guest console=$folder/console.log

skip() { echo "SKIPPED: $*"; exit 77; }
[ "$(uname -m)" = x86_64 ] || skip "the guest's kernel is for x86-64"
for tool in qemu-system-x86_64 busybox cpio dpkg apt-get; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
mkdir -p "$folder"
"$here/fetch_kernel.sh" "$kernel" 2>"$folder/fetch.log" || skip "Debian's kernel could not be fetched: $(tail -1 "$folder/fetch.log")"

rm -rf "$guest" && mkdir -p "$guest"/{bin,dev,proc,sys,tmp,modules}
cp "$(command -v busybox)" "$guest/bin/busybox"
cp "$device" "$guest/bin/uhid_device"
cp "$host" "$guest/bin/vm_host"
install -m 755 "$here/guest_init.sh" "$guest/init"
cp "$kernel"/*.ko "$guest/modules"
ldd "$device" "$host" | grep -o '/[^ ]* (' | tr -d ' (' | sort -u | xargs cp -L --parents -t "$guest"
(cd "$guest" && find . | cpio --quiet -o -H newc | gzip -1) >"$folder/initramfs.gz"

# Time in the guest is counted in instructions (TCG, 500 million per second), so a busy machine changes no number. Never KVM.
timeout 150 qemu-system-x86_64 -accel tcg -icount shift=1,sleep=off -smp 1 -m 256 -cpu qemu64,+arat \
  -M microvm,pit=on,pic=on,rtc=on,isa-serial=on -nodefaults -no-user-config -display none -no-reboot -serial stdio \
  -kernel "$kernel/vmlinuz" -initrd "$folder/initramfs.gz" \
  -append "console=ttyS0 panic=-1 reboot=t mitigations=off quiet" </dev/null 2>&1 | tr -d '\r' >"$console" || true

grep -a -E '^(RESULT|NUMBER) ' "$console" || true
if grep -a -q '^GUEST DONE 0$' "$console" && ! grep -a -q '^RESULT FAIL' "$console" &&
  [ "$(grep -a -c '^RESULT PASS' "$console")" -ge 3 ]; then
  exit 0
fi
cat "$console"
exit 1
