#!/usr/bin/env bash
# cppcheck over the core, the command line and the session; any finding fails. What is left out:
#   missingIncludeSystem  the C++ library and Eigen are not analysed, only used
#   returnStdMoveLocal    files.cpp: what is moved is a reference into a variant, where nothing could
#                         be elided; cppcheck 2.10 takes it for the returned object
set -euo pipefail
cd "$(dirname "$0")/../.."
build=build/cppcheck
mkdir -p "$build"
cppcheck --std=c++20 --language=c++ --enable=warning,performance,portability --quiet \
  --error-exitcode=1 --cppcheck-build-dir="$build" -j "${PLANISH_JOBS:-2}" \
  --template='{file}:{line}: {severity}: {message} [{id}]' -I core/include -I core/src \
  --suppress=missingIncludeSystem \
  --suppress=returnStdMoveLocal:core/workflow/mesh_files.cpp \
  core/src core/workflow core/cli wasm/session.cpp wasm/session_reports.cpp
