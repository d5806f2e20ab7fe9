#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
#
# Installs what the programs need, builds them into build/release and shows the main job on a bundled sample: in the
# desktop app where there is a display, else on the command line with the results in out/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=${LC_ALL:-C.UTF-8}
root=$PWD
build=$root/build/release
sample=$root/sample_maps/office

has_display() {
  if [[ -n ${WAYLAND_DISPLAY:-} && -S ${XDG_RUNTIME_DIR:-/nonexistent}/$WAYLAND_DISPLAY ]]; then return 0; fi
  case ${DISPLAY:-} in
    '') return 1 ;;
    :*) local screen=${DISPLAY#:} && [[ -S /tmp/.X11-unix/X${screen%%.*} ]] ;;
    *) return 0 ;;  # forwarded from another machine
  esac
}

packaging/install_dependencies.sh build
# The tests stay on where packaging/test.sh has switched them on: this builds only the programs.
[[ -f $build/build.ninja ]] || cmake --preset release -DCAD2SLAM_BUILD_TESTS=OFF -DCAD2SLAM_BUILD_BENCHMARKS=OFF
cmake --build --preset release --target programs

if has_display && [[ -x $build/app/cad2slam ]]; then
  echo "Opening $sample/office.c2sproj"
  exec "$build/app/cad2slam" "$sample/office.c2sproj"
fi

cli=$build/app/cad2slam-cli
out=$root/out
mkdir -p "$out"
echo "No display: solving the sample in $sample on the command line"
maps=(--blueprint "$sample/blueprint.yaml" --slam "$sample/slam_1.yaml")
"$cli" solve "${maps[@]}" --anchors "$sample/anchors_1.csv" -o "$out/office.c2s"
"$cli" preview "$out/office.c2s" "${maps[@]}" -o "$out/office.png"
"$cli" warp "$out/office.c2s" --to slam "$sample/blueprint.yaml" -o "$out/office_in_slam.yaml"
cat <<END

Projector for robots:           $out/office.c2s
Picture of both maps together:  $out/office.png
Blueprint as a map for robots:  $out/office_in_slam.yaml
END
