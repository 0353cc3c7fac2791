#!/usr/bin/env bash
# The Debian packages in an empty Debian 12: empty_root.sh FOLDER_OF_DEBS [BASE]
# BASE is a root that debootstrap made (--variant=minbase bookworm) with g++, cmake, ca-certificates and the sources of apt;
# it is copied, never changed. Without BASE one is made, which fetches 200 MB. Needs root.
# Everything that happens in the copy: inside.sh. Prints its last lines, all of them are in FOLDER_OF_DEBS/empty_root.log.
set -euo pipefail
debs=$(realpath "$1")
base=${2:-}
sources=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d)
root=$work/root

release() {
  for mounted in dev proc; do umount -R -l "$root/$mounted" 2>/dev/null || true; done
  rm -rf --one-file-system "$work"
}
trap release EXIT

if [ -n "$base" ]; then
  cp -a "$base" "$root"
else
  debootstrap --variant=minbase --include=g++,cmake,ca-certificates bookworm "$root" >/dev/null
fi
mkdir -p "$root/packages" "$root/sources/docs" "$root/sources/tests/golden" "$root/sources/core/runtime"
cp "$debs"/*tactus*.deb "$root/packages"
# What an engineer outside has is the packages. The tests themselves and one model come along; the library's sources do not.
cp -a "$sources/docs/conformance" "$sources/docs/guide" "$root/sources/docs"
cp -a "$sources/tests/consumer" "$sources/tests/packages" "$root/sources/tests"
cp -a "$sources/tests/golden/models" "$root/sources/tests/golden"
for mounted in dev proc; do mount --rbind "/$mounted" "$root/$mounted" && mount --make-rslave "$root/$mounted"; done

log=$debs/empty_root.log
if chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
     bash /sources/tests/packages/inside.sh >"$log" 2>&1 </dev/null; then
  grep '^== ' "$log"
  echo "The packages work in an empty root."
else
  tail -n 40 "$log"
  echo "The packages do not work in an empty root: $log" >&2
  exit 1
fi
