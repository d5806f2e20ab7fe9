#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
#
# usage: reproduce.sh [COMMIT]
# Builds the Debian packages of a commit (default: HEAD) twice, from clones in two folders whose names have different
# lengths, and compares them byte by byte. Takes as long as two builds; ctest only packs one build twice
# (tests/packaging/packages.cmake).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C.UTF-8 CCACHE_DISABLE=1 # a cache would compare a build with itself
commit=$(git rev-parse "${1:-HEAD}^{commit}")
work=$(mktemp -d "${TMPDIR:-/tmp}/cad2slam-reproduce.XXXXXX")
trap 'rm -rf "$work"' EXIT

build() {
  local folder=$1
  git clone --quiet --no-checkout . "$folder"
  git -C "$folder" checkout --quiet --detach "$commit"
  cmake -S "$folder" -B "$folder/build/release" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCAD2SLAM_BUILD_TESTS=OFF \
    -DCAD2SLAM_BUILD_BENCHMARKS=OFF >"$folder.log"
  cmake --build "$folder/build/release" -j "${JOBS:-$(nproc)}" >>"$folder.log"
  (cd "$folder/build/release" && cpack -G DEB >>"$folder.log")
}

for folder in "$work/a" "$work/the_same_in_a_longer_folder"; do
  build "$folder" || {
    tail -n 30 "$folder.log" >&2
    exit 1
  }
done
cd "$work"
differs=0
for package in a/build/release/packages/*.deb; do
  other=the_same_in_a_longer_folder/build/release/packages/${package##*/}
  if cmp "$package" "$other"; then
    sha256sum "$package" | sed 's|a/build/release/packages/||'
  else
    differs=1
  fi
done
exit "$differs"
