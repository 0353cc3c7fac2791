#!/usr/bin/env bash
# fetch_kernel.sh FOLDER: puts vmlinuz and the HID modules of Debian's cloud kernel there. The network is needed once, root never.
set -euo pipefail
folder=$1
[ -f "$folder/vmlinuz" ] && [ -f "$folder/hid.ko" ] && exit 0

package=$(apt-cache depends linux-image-cloud-amd64 | sed -n 's/^ *Depends: \(linux-image-[0-9].*\)/\1/p' | head -1)
[ -n "$package" ] || { echo "apt does not know linux-image-cloud-amd64; apt-get update may help" >&2; exit 1; }

rm -rf "$folder" && mkdir -p "$folder/unpacked" && cd "$folder"
apt-get -qq download "$package"
dpkg --fsys-tarfile "$package"_*.deb | tar -x -C unpacked --wildcards './boot/vmlinuz-*' '*/hid/hid.ko*' '*/hid/hid-generic.ko*' '*/hid/uhid.ko*'
# Newer kernels have compressed modules.
find unpacked -name '*.ko.xz' -exec xz -d {} +
find unpacked -name '*.ko' -exec mv {} . \;
[ -f hid.ko ] || { echo "the kernel package $package has no HID modules" >&2; exit 1; }
mv unpacked/boot/vmlinuz-* vmlinuz
rm -r unpacked "$package"_*.deb
