// SPDX-License-Identifier: MIT
/// How the library says no. (Reading a file says it as a ReadError, in place of a mesh; commands
/// throw it with their exit code.)
#pragma once

#include <optional>
#include <string>

namespace planish {

/// One clear sentence that names what is wrong; nullopt where nothing is.
using Refusal = std::optional<std::string>;

}  // namespace planish
