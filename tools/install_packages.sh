#!/usr/bin/env bash
# Installs those of the named Debian packages that are missing; without any missing one it does nothing.
# Usage: install_packages.sh PACKAGE...        Exit code 1 when a package is missing and cannot be installed.
set -euo pipefail

missing=()
for package in "$@"; do
    state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

give_up() {
    echo "error: $1" >&2
    echo "Install these yourself, then run this again: ${missing[*]}" >&2
    exit 1
}

command -v apt-get >/dev/null || give_up "this system has no apt-get, so the packages cannot be installed from here."
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || give_up "installing needs root, and there is no sudo."
    as_root=(sudo)
fi

echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" >"$log" 2>&1 && return
    tail -n 20 "$log" >&2
    give_up "apt-get $1 failed; its last lines are above."
}
apt update
apt install --no-install-recommends "${missing[@]}"
