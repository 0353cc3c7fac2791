#!/bin/sh
# linked_csharp.sh TACTUS MODEL WORK MONO: Linked.cs on the live link.
set -e
work=$3
mkfifo "$work/listening"
"$1" serve "$2" --token-file "$work/token" >"$work/listening" &
server=$!
trap 'kill $server' EXIT
read -r line <"$work/listening"
port=${line#*\"port\":}
port=${port%%,*}
"$4" "$work/linked.exe" "$port" "$work/token"
