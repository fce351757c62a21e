#!/usr/bin/env bash
# The Python wheel as whoever installs it has it, in an environment with nothing else but numpy and
# pytest: build/python.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --build --preset native --target planish_python -j "${PLANISH_JOBS:-$(nproc)}"
bash .tools/start/build.sh catalogue
place=build/python
rm -rf "$place" && mkdir -p "$place"
/usr/bin/python3 -m build --wheel --no-isolation --outdir "$place" python >"$place/wheel.log" 2>&1 ||
  { cat "$place/wheel.log"; exit 1; }
/usr/bin/python3 -m venv --system-site-packages --without-pip "$place/venv"
/usr/bin/python3 -m pip --python "$place/venv/bin/python" install --quiet --no-index --no-deps "$place"/*.whl
