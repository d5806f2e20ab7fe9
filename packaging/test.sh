#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
#
# usage: test.sh [CMAKE OPTION...]
# Installs what the tests need, builds everything into build/release and runs every test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=${LC_ALL:-C.UTF-8}

packaging/install_dependencies.sh build test
cmake --preset release -DCAD2SLAM_BUILD_TESTS=ON -DCAD2SLAM_BUILD_BENCHMARKS=ON "$@"
cmake --build --preset release
ctest --preset release
