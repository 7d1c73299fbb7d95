#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# Install the Debian packages of a list that are missing: install_missing.sh LIST. Quick when nothing is.
set -eu
missing=""
for package in $(grep -v '^#' "$1"); do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

root=""
[ "$(id -u)" = 0 ] || root=sudo
if [ -n "$root" ] && ! command -v sudo >/dev/null; then
  echo "These Debian packages are missing and there is no sudo; install them as root:$missing" >&2
  exit 1
fi
echo "Installing:$missing"
install() { $root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing; }
# The package lists may be old or absent, as in a fresh container.
install || { $root apt-get update && install; }
