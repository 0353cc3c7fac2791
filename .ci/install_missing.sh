# Sourced by run.sh and test.sh. `install_missing PACKAGE...` installs the Debian packages that are not there yet, or names
# them and stops where that is not possible.
install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${as_root[@]}" true 2>/dev/null; then
    echo "Missing Debian packages: ${missing[*]}" >&2
    echo "Install them as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi

  echo "Installing ${missing[*]}"
  local log
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    cat "$log" >&2
    echo "The packages could not be installed: ${missing[*]}" >&2
    exit 1
  fi
  rm -f "$log"
}

# `install_wanted PACKAGE...`: the same for what the program can do without. Only tries.
install_wanted() { (install_missing "$@") >/dev/null 2>&1 || true; }

# `quietly COMMAND...`: its output only where it fails.
quietly() {
  local log
  log=$(mktemp)
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    echo "Failed: $*" >&2
    exit 1
  fi
  rm -f "$log"
}

# What every build needs.
build_packages=(g++ cmake ninja-build pkgconf nlohmann-json3-dev libexpected-dev libcli11-dev libsqlitecpp-dev
                libhidapi-dev libcrypt-dev libsodium-dev libzip-dev libboost-dev)
# What the workbench needs on top.
workbench_packages=(qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools libqcustomplot-dev fonts-dejavu-core
                    fonts-noto-cjk)
# With it the workbench reads TIFF images.
wanted_packages=(qt6-image-formats-plugins)
