#!/usr/bin/env bash
# Installs what is missing, checks the format, builds everything and runs every test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. .ci/install_missing.sh

# Where the time goes: `spent NAME` after each phase.
phases=""
begun=$SECONDS
spent() { phases+="${phases:+, }$1 $((SECONDS - begun)) s"; begun=$SECONDS; }

install_missing git ccache clang-format locales libgtest-dev libgmp-dev qemu-system-x86 busybox-static cpio fuzzylite \
  dpkg-dev file appstream desktop-file-utils g++-mingw-w64-x86-64-posix xvfb xauth xdotool \
  "${build_packages[@]}" "${workbench_packages[@]}"
install_wanted "${wanted_packages[@]}"
spent packages

# A fresh clone may belong to another user than the one who tests it.
files() { git -c safe.directory='*' ls-files -co --exclude-standard -- "$@"; }
# Each version formats a little otherwise.
wanted_format=$(sed -n 's/^# clang-format \([0-9]*\)$/\1/p' .clang-format)
found_format=$(clang-format --version | sed 's/.*version \([0-9]*\).*/\1/')
if [ "$found_format" = "$wanted_format" ]; then
  quietly xargs -r -a <(files '*.h' '*.cpp') clang-format --dry-run --Werror
else
  echo "Not checked: the format (clang-format $found_format is here, $wanted_format is wanted)"
fi
spent format

# One object cache for both builds below; precompiled headers need the third setting.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime

# Without Qt everything outside app/workbench must build.
[ -f build/core-only/build.ninja ] || quietly cmake --preset core-only
quietly cmake --build --preset core-only --target tactus_cli
spent "build without Qt"

[ -f build/dev/build.ninja ] || quietly cmake --preset dev
quietly cmake --build --preset dev
spent build

# Some tests run in a locale with decimal commas, which a small system does not have.
export LOCPATH=$PWD/build/locale
if [ ! -d "$LOCPATH/de_DE.UTF-8" ]; then
  mkdir -p "$LOCPATH"
  quietly localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8"
fi

# Leaves out the test programs that passed before. One is run again on another day, because the date chooses the random models,
# or when it has changed, a program that it starts, or any file that is not C++ source. Delete build/dev/stamps to run all.
mkdir -p build/dev/stamps
data=$({ date +%F; files ':!*.h' ':!*.cpp' ':(exclude,top,glob)*.md' | xargs -d '\n' sha256sum 2>/dev/null || true; } | sha256sum)
declare -A state=()
passed=()
while read -r program its_files; do
  # shellcheck disable=SC2086  # several files
  state[$program]=$({ echo "$data"; sha256sum $its_files; } | sha256sum)
  [ "${state[$program]}" != "$(cat "build/dev/stamps/$program" 2>/dev/null)" ] || passed+=("$program")
done <build/dev/tests/programs
left_out=()
[ ${#passed[@]} = 0 ] || left_out=(-LE "^($(IFS='|' && echo "${passed[*]}"))\$")

log=$(mktemp)
trap 'rm -f "$log"' EXIT
passes=true
ctest --preset dev -j "$(nproc)" "${left_out[@]}" >"$log" 2>&1 || passes=false
for program in "${!state[@]}"; do
  $passes || ! ctest --preset dev -N -L "^$program\$" | sed -n 's/^ *Test *#[0-9]*: //p' |
    grep -qxFf <(sed 's/^[0-9]*://' build/dev/Testing/Temporary/LastTestsFailed.log) || continue
  echo "${state[$program]}" >"build/dev/stamps/$program"
done
if ! $passes; then
  cat "$log" >&2
  exit 1
fi
spent tests
grep 'tests passed' "$log"
echo "Time: $phases"
grep -ah '^House: ' build/dev/Testing/Temporary/LastTest.log || true
unchanged=$({ sed -n 's/^Unchanged since it passed: //p' build/dev/Testing/Temporary/LastTest.log; printf '%s\n' "${passed[@]}"; } | sort | xargs)
[ -z "$unchanged" ] || echo "Not run again, as nothing they use has changed since they passed: $unchanged"
# A test that cannot run here says why.
grep -a '^SKIPPED' build/dev/Testing/Temporary/LastTest.log || true
