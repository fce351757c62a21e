#!/usr/bin/env bash
# Makes this machine able to build and test Planish. Safe to run again: it only adds what is missing. With
# `page` or `native`, what building the page or the command line needs; without, what all checks need;
# with `firefox`, also what tests in a second browser engine need.
set -euo pipefail
cd "$(dirname "$0")/../.."

both=(cmake ninja-build ccache libeigen3-dev libboost-dev libtinygltf-dev libstb-dev nlohmann-json3-dev
  googletest)
# Emscripten runs on clang 19, see wasm/emscripten.config.
page=(emscripten clang-19 lld-19 llvm-19)
native=(g++ libqrcodegencpp-dev)
checks=(chromium-headless-shell libbenchmark-dev clang-format clang-tidy clang libclang-rt-14-dev cppcheck
  python3-numpy python3-scipy python3-ezdxf python3-shapely python3-pytest python3-pytest-timeout
  pybind11-dev python3-dev python3-venv python3-pip python3-build python3-wheel python3-setuptools
  python3-distributed parallel)
case "${1:-}" in
  page) packages=("${both[@]}" "${page[@]}") ;;
  native) packages=("${both[@]}" "${native[@]}") ;;
  *) packages=("${both[@]}" "${page[@]}" "${native[@]}" "${checks[@]}") ;;
esac
if [ "${1:-}" = firefox ]; then
  packages+=(firefox-esr xvfb xauth libgl1-mesa-dri libegl1)
fi

has_package() { [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

install_debian_packages() {
  local missing=()
  for package in "${packages[@]}"; do has_package "$package" || missing+=("$package"); done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    echo "setup: missing Debian packages. Run as root:  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  echo "setup: installing Debian packages: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq -o Acquire::Retries=3
  apt-get install -y -qq -o Acquire::Retries=3 --no-install-recommends "${missing[@]}" >/dev/null
}

name_missing_tools() {
  local missing=()
  for tool in cmake ninja; do
    command -v "$tool" >/dev/null || missing+=("$tool")
  done
  for header in eigen3/Eigen/Core tiny_gltf.h stb/stb_image_write.h nlohmann/json.hpp \
    boost/polygon/polygon.hpp; do
    [ -e "/usr/include/$header" ] || missing+=("/usr/include/$header")
  done
  [ -d /usr/src/googletest ] || missing+=(/usr/src/googletest)
  [ ${#missing[@]} -eq 0 ] && return
  echo "setup: this is not Debian, so nothing was installed. Missing: ${missing[*]}" >&2
  exit 1
}

install_node_packages() {
  local major
  major=$(node -p 'process.versions.node.split(".")[0]' 2>/dev/null || echo 0)
  if [ "$major" -lt 20 ]; then
    echo "setup: Node.js 20 or newer is needed (found: $(node --version 2>/dev/null || echo none))." >&2
    exit 1
  fi
  local stamp=node_modules/.planish-lock
  cmp -s package-lock.json "$stamp" && return
  echo "setup: installing npm packages from package-lock.json"
  npm ci --no-audit --no-fund --loglevel=error
  cp package-lock.json "$stamp"
}

if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
  install_debian_packages
else
  name_missing_tools
fi
[ "${1:-}" = native ] || install_node_packages
