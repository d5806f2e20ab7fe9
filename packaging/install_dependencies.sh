#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
#
# usage: install_dependencies.sh [GROUP...]
# Installs the Debian packages of the given groups of dependencies.txt (default: build). Silent and without network
# when all of them are there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
list=$here/dependencies.txt

die() {
  printf 'install_dependencies.sh: %s\n' "$*" >&2
  exit 1
}

# The packages of one group, one a line.
packages_of() {
  awk -v wanted="[$1]" '
    { sub(/#.*/, ""); gsub(/[ \t\r]/, "") }
    /^\[.*\]$/ { inside = ($0 == wanted); found = found || inside; next }
    inside && NF { print }
    END { exit !found }' "$list"
}

packages=()
for group in "${@:-build}"; do
  names=$(packages_of "$group") || die "dependencies.txt has no group '$group'"
  mapfile -t -O "${#packages[@]}" packages <<<"$names"
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  die "this needs Debian's apt-get; on another system install what these packages hold: ${packages[*]}"
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null || true)
  [[ $status == ?i* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null ||
    die "not root and no sudo; as root run: apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo)
  # Without a terminal nobody can type a password: fail now instead of waiting for one.
  if ! [[ -t 0 ]] && ! sudo -n true 2>/dev/null; then
    die "sudo asks for a password; first run: sudo apt-get install --no-install-recommends ${missing[*]}"
  fi
fi

log=$(mktemp "${TMPDIR:-/tmp}/cad2slam-install.XXXXXX")
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" >>"$log" 2>&1 </dev/null
}

printf 'Installing %d Debian packages with apt-get%s (a few minutes the first time):\n' \
  "${#missing[@]}" "${as_root:+ through sudo}"
printf '%s\n' "${missing[*]}" | fold -s -w 100 | sed 's/^/  /'
# A failed update is no reason to stop: the lists that are there may do.
apt update || printf 'apt-get update failed, trying with the package lists that are there\n' >&2
if ! apt install --no-install-recommends "${missing[@]}"; then
  tail -n 25 "$log" >&2
  die "apt-get could not install the packages above; is the network up and does /etc/apt list Debian 12 (bookworm)?"
fi
