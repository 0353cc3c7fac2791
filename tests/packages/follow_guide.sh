#!/usr/bin/env bash
# Does what a guide says, word by word: follow_guide.sh GUIDE.md FOLDER
# A block of code that begins with a comment of one file name becomes that file; blocks marked `sh` are run in their order,
# and the block marked `text` after one is what it printed. Lines that begin with `sudo apt` are for an installed system and
# are left out.
set -euo pipefail
guide=$(realpath "$1")
mkdir -p "$2" && cd "$2"
awk '
  /^```/ && !inside { inside = 1; kind = substr($0, 4); first = 1; name = ""; next }
  /^```/ && inside { inside = 0; next }
  inside && kind == "sh" && !/^sudo apt/ { print > "steps.sh"; next }
  inside && first {
    first = 0
    if (match($0, /[A-Za-z_]+\.(c|cpp|py|cs|txt)/)) { name = substr($0, RSTART, RLENGTH) }
    if (name != "") printf "" > name
  }
  inside && name != "" { print > name }
' "$guide"
bash -euxo pipefail steps.sh
