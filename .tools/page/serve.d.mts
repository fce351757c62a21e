// SPDX-License-Identifier: MIT
import type { Server } from "node:http";

export function serve(
  directory: string,
  options?: { port?: number; prefix?: string; open?: boolean },
): Promise<{ server: Server; url: string }>;
