#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# A wheel in an environment of its own: both methods mesh a part, with the OpenCASCADE inside the wheel: test_wheel.sh WHEEL
set -eu
wheel=$(realpath "$1")
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
/usr/bin/python3 "$(dirname "$0")/../tests/parts/make_parts.py" "$home" bracket >/dev/null
"${PYTHON:-/usr/bin/python3}" -m venv "$home/env"
"$home/env/bin/pip" install --quiet "$wheel"
cd "$home"
for method in feature-line tet-split; do
  env/bin/hexfeature mesh bracket.step -o bracket.vtk --size 4 --method $method
done
env/bin/python - <<'END'
from hexfeature import _core
used = {line.split()[-1] for line in open("/proc/self/maps") if "libTK" in line}
assert used and all("hexfeature.libs" in path for path in used), used
print("OpenCASCADE of the wheel:", sorted(used)[0].split("/")[-1], "and", len(used) - 1, "more;", _core.__version__)
END
