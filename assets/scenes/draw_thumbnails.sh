#!/bin/sh
# Draws the pictures of the gallery of scenes: assets/scenes/draw_thumbnails.sh [PROGRAM]
# The program draws them itself, 216 by 135 pixels after some seconds of each scene; the same ones come out every time.
set -eu
here=$(dirname "$0")
drapeau=${1:-$here/../../build/release/drapeau}
mkdir -p "$here/thumbnails"
for file in "$here"/*.toml; do
  scene=$(basename "$file" .toml)
  case $scene in
    drop) frames=75 ;;   # while it falls
    spring) frames=27 ;; # half a period: far from its rest
    *) frames=420 ;;
  esac
  "$drapeau" "$file" --frames $frames --size 216x135 --hide-ui --screenshot "$here/thumbnails/$scene.png"
done
