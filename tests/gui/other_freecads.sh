#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# The tests of the window and of the FreeCAD objects in other FreeCADs than the system's: other_freecads.sh [--wheel] [trixie] [sid]
#
# For each Debian suite a root is made with debootstrap (once: about 10 minutes and 3 GB; trixie has FreeCAD 1.0, sid 1.1), the extension is
# built in it with its own OpenCASCADE and Python, and the tests run there under Xvfb. Needs root, a network and debootstrap.
# --wheel: nothing is built; the wheel for that Python in dist/repaired is taken, with the OpenCASCADE that it brings
# (make bundled-wheel PYTHON=python3.13).
# HEXFEATURE_ROOTS: where the roots are, /var/tmp/hexfeature-roots. HEXFEATURE_GUI_TESTS: as the arguments of run.sh.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
roots=${HEXFEATURE_ROOTS:-/var/tmp/hexfeature-roots}
wheel=
[ "${1:-}" != --wheel ] || { wheel=yes; shift; }
[ $# -gt 0 ] || set -- trixie sid
command -v debootstrap >/dev/null || apt-get install -y debootstrap

make_root() {
  root=$roots/$1
  if [ ! -d "$root/usr" ]; then
    mkdir -p "$roots"
    debootstrap --variant=minbase "$1" "$root" http://deb.debian.org/debian
  fi
  mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
  mountpoint -q "$root/sys" || mount -t sysfs sysfs "$root/sys"
  mountpoint -q "$root/dev" || mount --bind /dev "$root/dev"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  # The network's own certificates and apt's settings, where there are some.
  [ ! -d /usr/local/share/ca-certificates ] || cp -r /usr/local/share/ca-certificates "$root/usr/local/share/"
  cp -n /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
  if [ ! -f "$root/root/hexfeature-packages" ]; then
    chroot "$root" apt-get -q update >/dev/null
    # What packaging/debian-packages.txt asks for, by names that all suites have; CalculiX is not in every one.
    chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
      freecad freecad-python3 xvfb xauth libgl1-mesa-dri libxtst6 g++ cmake ninja-build ccache make git \
      libeigen3-dev libfontconfig-dev liblemon-dev libnglib-dev libtbb-dev pybind11-dev \
      python3-dev python3-numpy python3-h5py python3-meshio python3-vtk9 \
      libocct-data-exchange-dev libocct-foundation-dev libocct-modeling-algorithms-dev libocct-modeling-data-dev libocct-ocaf-dev \
      libocct-visualization-dev >/dev/null
    chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends calculix-ccx >/dev/null 2>&1 ||
      echo "$1 has no CalculiX: the tests that solve are left out"
    touch "$root/root/hexfeature-packages"
  fi
}

# A root that stays mounted would take the machine's own /dev with it when it is removed.
unmount() {
  for suite in $suites; do
    for each in dev sys proc; do
      ! mountpoint -q "$roots/$suite/$each" || umount "$roots/$suite/$each" || umount -l "$roots/$suite/$each" || true
    done
  done
}

code=0
suites=$*
older=$(mktemp -d)
trap 'rm -rf "$older"; unmount' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
HEXFEATURE_SAVE="$older/older.FCStd" QT_QPA_PLATFORM=offscreen \
  freecadcmd -P "$here/python" -P "$here/tests/parts" "$here/tests/freecad/save_document.py" >"$older/log" 2>&1 </dev/null || cat "$older/log"
for suite in "$@"; do
  echo "== $suite"
  make_root "$suite"
  mkdir -p "$root/root/src"
  (cd "$here" && git ls-files -z --cached --others --exclude-standard | tar cf - --null -T -) | tar xf - -C "$root/root/src"
  cp "$older/older.FCStd" "$root/root/older.FCStd"
  rm -f "$root"/root/*.whl
  if [ -n "$wheel" ]; then
    tag=$(chroot "$root" /usr/bin/python3 -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
    cp "$here"/dist/repaired/hexfeature-*-"$tag"-*.whl "$root/root/"
  fi
  chroot "$root" env HEXFEATURE_OLDER_DOCUMENT=/root/older.FCStd sh -euc '
    cd /root/src
    rm -rf python/hexfeature/_core*.so python/hexfeature.libs build/python/hexfeature/_core*
    if ls /root/*.whl >/dev/null 2>&1; then
      /usr/bin/python3 -m zipfile -e /root/*.whl python
      chmod +x python/hexfeature/hexfeature-netgen
    else
    cmake -G Ninja -B build -DCMAKE_BUILD_TYPE=Release -DHEXFEATURE_TESTS=OFF -DPython3_EXECUTABLE=/usr/bin/python3 >build.log 2>&1 || { cat build.log; exit 1; }
    cmake --build build >>build.log 2>&1 || { tail -40 build.log; exit 1; }
    fi
    code=0
    for t in TestHexFeature TestHexFeatureWindowless TestHexFeatureConstraints; do
      QT_QPA_PLATFORM=offscreen $(command -v freecadcmd || command -v FreeCADCmd) -P python -P tests/freecad -P tests/parts -t $t \
        >$t.log 2>&1 && grep -q "^OK" $t.log || { grep -A30 "^=====" $t.log || tail -30 $t.log; echo "FAILED $t"; code=1; }
      echo $t: $(grep -E "^Ran|^OK|^FAILED" $t.log)
    done
    FREECAD=$(command -v freecad || command -v FreeCAD) tests/gui/run.sh '"${HEXFEATURE_GUI_TESTS:-}"' || code=1
    exit $code' || code=1
done
exit $code
