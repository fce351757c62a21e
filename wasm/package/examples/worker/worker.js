// Edits in a worker: the page stays quick while a large mesh is solved.
import { edit, Mesh } from "../../index.js";

const mesh = Mesh.sample("vault", 16);

self.addEventListener("message", async ({ data }) => {
  const { moved, positions, report } = edit(await mesh, { handles: [data] });
  self.postMessage({ moved, positions, status: report.status }, [positions.buffer]);
});
