// SPDX-License-Identifier: MIT
// A DOM around modules that are node's own: addresses of files stay addresses of files.
import { builtinEnvironments, type Environment } from "vitest/runtime";

export default {
  ...builtinEnvironments["happy-dom"],
  name: "page",
  viteEnvironment: "ssr",
} satisfies Environment;
