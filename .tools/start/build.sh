#!/usr/bin/env bash
# Builds the command line (build/native/planish), the wasm core and the static site (dist/).
# With names, only those: native, wasm, site, npm (the package, into build/npm) and catalogue (the page
# that the Python package puts beside the designs of a sweep, into build/catalogue).
set -euo pipefail
cd "$(dirname "$0")/../.."

jobs=${PLANISH_JOBS:-$(nproc)}

configure() { # preset
  [ ! -e "build/$1/build.ninja" ] || return 0
  echo "build: everything is compiled the first time, which takes some minutes on two cores"
  cmake --preset "$1" --log-level=WARNING
}

# In place of a line a file: how far it is, at each tenth of the way.
readonly TENTHS='
  /^\[/ {
    split(substr($1, 2), at, /[\/\]]/); tenth = int(10 * at[1] / at[2])
    if (tenth > last && at[2] > 9) { print "build: " at[1] " of " at[2] " compiled"; fflush() }
    if (tenth > last) last = tenth
    next
  }
  { print; fflush() }'

build() { # preset target
  configure "$1"
  cmake --build --preset "$1" --target "$2" -j "$jobs" | awk "$TENTHS"
}

# Sources as JavaScript and types, with the module that they load.
package() {
  rm -rf build/npm
  npx --no-install tsc -p wasm/package/tsconfig.json
  cp build/wasm/wasm/planish_package.{mjs,wasm} wasm/package/src/planish_package.d.mts build/npm/
  cp -r wasm/package/{package.json,README.md,examples} LICENSE build/npm/
}

catalogue() {
  npx --no-install vite build --config web/catalogue.config.ts --logLevel warn
  cp web/src/catalogue/index.html build/catalogue/
  cat node_modules/echarts/{NOTICE,LICENSE} >build/catalogue/echarts-licence.txt
}

# The page, and beside it the element that shows it in other pages.
site() {
  npx --no-install vite build --config web/vite.config.ts --logLevel warn &&
    npx --no-install tsc -p wasm/package/tsconfig.json --outDir build/editor &&
    cp build/editor/{planish-editor.js,planish-editor.d.ts,mesh-format.d.ts} dist/
}

parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(native wasm site)
case " ${parts[*]} " in *" native "*) bash .tools/start/setup.sh native ;; esac
case " ${parts[*]} " in *" wasm "* | *" npm "* | *" site "*) bash .tools/start/setup.sh page ;; esac
for part in "${parts[@]}"; do
  case $part in
    native) build native planish && echo "build: build/native/planish" ;;
    wasm) build wasm planish_page_wasm && echo "build: build/wasm/wasm/" ;;
    npm) build wasm planish_package_wasm && package && echo "build: build/npm/" ;;
    site) site && echo "build: dist/" ;;
    catalogue) catalogue && echo "build: build/catalogue/" ;;
    *) echo "build: unknown part '$part' (native, wasm, site, npm, catalogue)" >&2 && exit 2 ;;
  esac
done
