#!/bin/busybox sh
# The guest's first process: the HID modules, then the test, then off.
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs devtmpfs /dev
mount -t tmpfs tmpfs /tmp
for module in hid hid-generic uhid; do insmod /modules/$module.ko; done
/bin/vm_host /bin/uhid_device
echo "GUEST DONE $?"
reboot -f
