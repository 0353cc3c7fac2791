#!/usr/bin/env bash
# Run by empty_root.sh in the copy: installs the packages, uses them as a simulator engineer does, removes them.
set -euo pipefail
say() { echo "== $* ($SECONDS s)"; }
# The services of a running system are not there.
install() { apt-get install -y -qq --no-install-recommends "$@" >/dev/null; }
multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || echo "$(uname -m)-linux-gnu")

apt-get update -qq
cd /packages
install ./*tactus*.deb
say "installed with $(apt-mark showauto | wc -l) packages that were there before or that they depend on"
dpkg --audit
tactus --version
ldconfig -p | grep -q 'libtactus.so.1 '
[ "$(find /usr/lib/udev/rules.d /lib/udev/rules.d -name 60-tactus.rules | head -n 1)" ]
QT_QPA_PLATFORM=offscreen tactus-workbench --version
# On a screen Qt loads this plugin; nothing that it needs may be missing.
if ldd "/usr/lib/$multiarch/qt6/plugins/platforms/libqxcb.so" | grep 'not found'; then exit 1; fi
say "program, workbench and library start"

install shared-mime-info desktop-file-utils libglib2.0-bin
desktop-file-validate /usr/share/applications/tactus-workbench.desktop
mkdir -p /tmp/types && cd /tmp/types
tactus study new study.tactus --name Ward
cp study.tactus no-ending
cp /usr/share/tactus/conformance/scale.tactus.json .
type_of() { gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p'; }
[ "$(type_of scale.tactus.json)" = application/vnd.tactus.model+json ]
[ "$(type_of study.tactus)" = application/vnd.tactus.study ]
[ "$(type_of no-ending)" = application/vnd.tactus.study ]
gio mime application/vnd.tactus.study | grep -q tactus-workbench.desktop
say "the types of files are known, and the workbench opens them"

install make pkgconf python3 mono-mcs mono-runtime
work=$(mktemp -d)
for test in points program examples python csharp; do
  cmake -DSOURCE=/sources -DMODEL=/sources/tests/golden/models/ngt.tactus.json -DPREFIX=/usr -DWORK="$work/consumer_$test" \
    -DGENERATOR="Unix Makefiles" -DC_COMPILER=/usr/bin/cc -DCXX_COMPILER=/usr/bin/c++ -DPYTHON=/usr/bin/python3 -DMCS=/usr/bin/mcs \
    -DMONO=/usr/bin/mono -DTACTUS=/usr/bin/tactus -DVERSION="$(dpkg-query -W -f='${Version}' libtactus-dev)" \
    -P /sources/tests/consumer/${test}_test.cmake
done
points=$(cat "$work"/consumer_points/*.wanted.csv | wc -l)
say "consumers in C, C++, Python and C#: the forces of tactus eval at $((points - 3)) points of three models"
cd / && python3 -c 'import tactus; print(tactus.version())'

bash /sources/tests/packages/follow_guide.sh /sources/docs/guide/simulator.md "$work/guide"
say "the guide, word by word"

dpkg -P tactus-workbench tactus tactus-doc libtactus-dev libtactus1
left=$(find /usr /etc /lib /var/lib -iname '*tactus*' ! -path '/usr/share/mime/*' -print)
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
say "removed, and nothing is left"
