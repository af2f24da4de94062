#!/bin/sh
# Draws the golden pictures anew: tests/window/golden/draw.sh [PROGRAM]. Needs a display; look at each before keeping it.
set -eu
here=$(dirname "$0")
drapeau=${1:-$here/../../../build/release/drapeau}
while read -r name scene options; do
  # shellcheck disable=SC2086 # options are words
  "$drapeau" "$scene" $options --frames 30 --hide-ui --size 400x250 --screenshot "$here/$name.png" </dev/null
done <"$here/views.txt"
