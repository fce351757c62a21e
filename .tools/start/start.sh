#!/usr/bin/env bash
# Sets up, builds and serves the page; prints its address. PORT chooses the port.
set -euo pipefail
cd "$(dirname "$0")/../.."
bash .tools/start/build.sh wasm site
exec node .tools/page/serve.mjs dist
