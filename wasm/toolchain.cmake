# Debian's Emscripten 3.1.6 beside NodeSource's node: acorn lies in /usr/share/nodejs.
set(ENV{NODE_PATH} /usr/share/nodejs)
set(CMAKE_CROSSCOMPILING_EMULATOR "node;--no-experimental-fetch" CACHE STRING "" FORCE)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
