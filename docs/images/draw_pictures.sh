#!/bin/sh
# Draws the films of the scenes and the pictures of the views: docs/images/draw_pictures.sh [PROGRAM]
# Each loops: its end passes into its beginning. The same ones come out every time. Needs a display and ffmpeg.
set -eu
here=$(dirname "$0")
drapeau=${1:-$here/../../build/release/drapeau}
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
draw() { # SCENE FROM SECONDS SIZE QUALITY [OPTION...]
  scene=$1 from=$2 seconds=$3 size=$4 quality=$5
  shift 5
  rm -f "$frames"/*
  "$drapeau" "$scene" --record "$frames/%04d.png" --from "$from" --seconds "$seconds" --fps 24 --size "$size" "$@"
  ffmpeg -loglevel error -y -framerate 24 -i "$frames/%04d.png" -c:v libwebp_anim -quality "$quality" -loop 0 \
    "$here/$scene.webp"
}
draw report 8 6 800x500 70 --loop
for scene in breeze storm banner flutter; do draw $scene 4 4 480x300 60 --loop; done
draw calm 6 8 360x300 60 --loop
draw drum 4 3 400x300 60 --loop
draw halfmast 0 12 360x300 55
draw drop 0 4 400x300 60
# And the pictures of the views in docs/gallery.md.
still() { # NAME SCENE OPTION...
  name=$1 scene=$2
  shift 2
  "$drapeau" "$scene" --frames 330 --hide-ui --size 640x400 --screenshot "$frames/still.png" "$@"
  ffmpeg -loglevel error -y -i "$frames/still.png" -c:v libwebp -quality 80 "$here/view-$name.webp"
}
still cloth breeze
still bare-grid breeze --set view.bare_grid=true
still springs breeze --springs
still forces breeze --forces
still masses breeze --masses
still stretch breeze --set view.stretch=true
still velocities breeze --set view.velocities=true
still wind breeze --set view.wind=true
still person breeze --set view.person=true
still studio breeze --set view.background=studio
still reference storm --set view.reference=true
# What the greatest spring length buys, in docs/limit.md: a storm on its own springs, on springs a 64th as stiff, and on
# those with a limit of 5 %.
part() { # NAME OPTION...
  name=$1
  shift
  "$drapeau" "$here/../../assets/scenes/linear-drag/storm.toml" --record "$frames/$name-%04d.png" --from 4 --seconds 4 \
    --fps 24 --size 360x300 "$@"
}
rm -f "$frames"/*
soft="--set springs.stiffness=46.875 --set springs.diagonal_stiffness=23.4375"
part own
part soft $soft
part limited $soft --set limit.stretch=0.05
ffmpeg -loglevel error -y -framerate 24 -i "$frames/own-%04d.png" -framerate 24 -i "$frames/soft-%04d.png" \
  -framerate 24 -i "$frames/limited-%04d.png" -filter_complex hstack=3 -c:v libwebp_anim -quality 55 -loop 0 \
  "$here/limited.webp"
