#!/bin/sh
# linked_simulator.sh TACTUS MODEL WORK PYTHON CLIENT: the example simulator and the client in Python on a live link.
set -e
work=$3
mkfifo "$work/listening"
"$1" serve "$2" --token-file "$work/token" >"$work/listening" &
server=$!
trap 'kill $server' EXIT
read -r line <"$work/listening"
port=${line#*\"port\":}
port=${port%%,*}
"$work/build/simulator" "$work/swallow" --fast --port "$port" --token-file "$work/token" --out "$work"
if [ -n "$4" ]; then
  # Half a swallow in the throat, the head upright: large and small clipped at 0.5, so
  # (0.125 * 0.85 + 0.075 * 0.2) / (0.125 + 0.075).
  "$4" "$5" --port "$port" --token-file "$work/token" --ask 0.5,0,160,30,0.5
  # One client tells where it is, the other sees it; then the first is gone.
  "$4" -u "$5" --port "$port" --token-file "$work/token" --others >"$work/others" &
  others=$!
  trap 'kill $server $others' EXIT
  "$4" "$5" --port "$port" --token-file "$work/token" --push "$2" >"$work/pushed"
  grep -q '^live_link.py: 29[0-9]\.[0-9]* mm, 0\.[0-9]* N$' "$work/others" || { echo "the other client saw nothing"; cat "$work/pushed"; }
fi
