#!/usr/bin/env bash
# Installs what is missing, builds, and runs the main job: with a display the workbench on the demo study, without one
# the demo alone. The demo's files are in out/demo, or in the folder given as the first argument.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. .ci/install_missing.sh

folder=${1:-out/demo}
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  preset=release
  install_missing "${build_packages[@]}" "${workbench_packages[@]}"
  install_wanted "${wanted_packages[@]}"
else
  preset=release-cli
  install_missing "${build_packages[@]}"
fi

[ -f build/$preset/build.ninja ] || quietly cmake --preset $preset
quietly cmake --build --preset $preset

build/$preset/tactus demo "$folder"
if [ $preset = release ]; then
  exec build/$preset/tactus-workbench "$folder/models/averaged.tactus.json"
fi
