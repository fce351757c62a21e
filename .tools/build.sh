#!/usr/bin/env bash
# Builds the command line (build/native/planish), the wasm core and the static site (dist/).
# With names, only those: native, wasm, site, and npm (the package, into build/npm).
set -euo pipefail
cd "$(dirname "$0")/.."
bash .tools/setup.sh

jobs=${PLANISH_JOBS:-$(nproc)}

configure() { # preset
  [ -e "build/$1/build.ninja" ] || cmake --preset "$1" --log-level=WARNING
}

build() { # preset target
  configure "$1"
  cmake --build --preset "$1" --target "$2" -j "$jobs" | grep -v '^\[' || [ "${PIPESTATUS[0]}" -eq 0 ]
}

# Sources as JavaScript and types, with the module that they load.
package() {
  rm -rf build/npm
  npx --no-install tsc -p wasm/package/tsconfig.json
  cp build/wasm/wasm/planish_package.{mjs,wasm} wasm/package/src/planish_package.d.mts build/npm/
  cp -r wasm/package/{package.json,README.md,examples} LICENSE build/npm/
}

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(native wasm site)
for part in "${parts[@]}"; do
  case $part in
    native) build native planish && echo "build: build/native/planish" ;;
    wasm) build wasm planish_wasm && echo "build: build/wasm/wasm/planish.wasm" ;;
    npm) build wasm planish_package_wasm && package && echo "build: build/npm/" ;;
    site) npx --no-install vite build --config web/vite.config.ts --logLevel warn && echo "build: dist/" ;;
    *) echo "build: unknown part '$part' (native, wasm, site, npm)" >&2 && exit 2 ;;
  esac
done
