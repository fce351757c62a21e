# Emscripten as wasm/emscripten.config has it, beside NodeSource's node: acorn lies in /usr/share/nodejs.
set(PLANISH_EM_ENVIRONMENT NODE_PATH=/usr/share/nodejs EM_CONFIG=${CMAKE_CURRENT_LIST_DIR}/emscripten.config)
set(ENV{NODE_PATH} /usr/share/nodejs)
set(ENV{EM_CONFIG} ${CMAKE_CURRENT_LIST_DIR}/emscripten.config)
set(CMAKE_CROSSCOMPILING_EMULATOR "node;--no-experimental-fetch" CACHE STRING "" FORCE)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(JOIN PLANISH_EM_ENVIRONMENT " " PLANISH_EM_WORDS)
set_property(GLOBAL PROPERTY RULE_LAUNCH_COMPILE "${CMAKE_COMMAND} -E env ${PLANISH_EM_WORDS}")
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env ${PLANISH_EM_WORDS}")
