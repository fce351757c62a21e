// SPDX-License-Identifier: MIT
// Where a ray meets the structure.
import { type Ray, Vector3 } from "three";

export interface Triangles {
  /** Display coordinates. */
  readonly corners: Float32Array;
  readonly triangles: Uint32Array;
}

export interface SurfaceHit {
  /** The first of the triangle's corners. */
  readonly corner: number;
  readonly at: Vector3;
}

/** Where the ray enters the surface; null beside it. */
export function surfaceHit({ corners, triangles }: Triangles, ray: Ray): SurfaceHit | null {
  const [a, b, c, hit] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  const at = new Vector3();
  let nearest = Number.POSITIVE_INFINITY;
  let corner = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    a.fromArray(corners, 3 * (triangles[t] ?? 0));
    b.fromArray(corners, 3 * (triangles[t + 1] ?? 0));
    c.fromArray(corners, 3 * (triangles[t + 2] ?? 0));
    if (!ray.intersectTriangle(a, b, c, false, hit)) continue;
    const distance = hit.distanceToSquared(ray.origin);
    if (distance >= nearest) continue;
    nearest = distance;
    corner = triangles[t] ?? 0;
    at.copy(hit);
  }
  return nearest < Number.POSITIVE_INFINITY ? { corner, at } : null;
}
