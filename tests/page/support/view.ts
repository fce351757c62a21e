// SPDX-License-Identifier: MIT
// A 3D view without a screen: WebGL that draws nothing, in a canvas that says where it is. Cameras, rays and
// points on screen are those of the page.

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** The window without the bar above, the inspector beside and the status line under the view. */
const inside = ({ width, height }: Size) => ({
  x: 0,
  y: 52,
  width: width - 300,
  height: height - 100,
});

/** Pixels from the tip of the first visit's sentence to its point (tests/browser/support/view.ts). */
const TIP = 26;

let view = inside({ width: 900, height: 640 });

/** From now on the window is so large. */
export function resizeWindow(size: Size): void {
  view = inside(size);
}

/** Where an element is: of the canvas its place, of a marker over it where the page has put it. */
export function boxOf(element: Element): { x: number; y: number; width: number; height: number } {
  const { x, y, width, height } = element.getBoundingClientRect();
  return { x, y, width, height };
}

/** Where the page has put a mark over the view. */
function placeOf(element: HTMLElement): { x: number; y: number } | null {
  const [, x, y] =
    /translate(?:3d)?\((-?[\d.]+)px, ?(-?[\d.]+)px/.exec(element.style.transform) ?? [];
  return x === undefined || y === undefined ? null : { x: Number(x), y: Number(y) };
}

const LIMITS: Readonly<Record<number, unknown>> = {
  3379: 4096, // MAX_TEXTURE_SIZE
  3386: new Int32Array([4096, 4096]), // MAX_VIEWPORT_DIMS
  7938: "WebGL 2.0", // VERSION
  2978: new Int32Array([0, 0, 600, 540]), // VIEWPORT
  3088: new Int32Array([0, 0, 600, 540]), // SCISSOR_BOX
  34921: 16, // MAX_VERTEX_ATTRIBS
  34930: 16, // MAX_TEXTURE_IMAGE_UNITS
  35660: 16, // MAX_VERTEX_TEXTURE_IMAGE_UNITS
  35661: 32, // MAX_COMBINED_TEXTURE_IMAGE_UNITS
  36347: 1024, // MAX_VERTEX_UNIFORM_VECTORS
  36349: 1024, // MAX_FRAGMENT_UNIFORM_VECTORS
  36348: 30, // MAX_VARYING_VECTORS
  34076: 4096, // MAX_CUBE_MAP_TEXTURE_SIZE
  36183: 4, // MAX_SAMPLES
};

const ANSWERS: Readonly<Record<string, (...given: never[]) => unknown>> = {
  getContextAttributes: () => ({ alpha: true, antialias: false, depth: true, stencil: false }),
  getExtension: () => null,
  getParameter: (name: number) => LIMITS[name] ?? 0,
  getProgramParameter: () => 0,
  getProgramInfoLog: () => "",
  getShaderInfoLog: () => "",
  getShaderParameter: () => true,
  getShaderPrecisionFormat: () => ({ rangeMin: 127, rangeMax: 127, precision: 23 }),
  getSupportedExtensions: () => [],
  getUniformBlockIndex: () => 0,
  isContextLost: () => false,
  checkFramebufferStatus: () => 0x8cd5,
};

/** Constants are numbers of their own, objects are made, everything else is nothing. */
function drawingNothing(canvas: HTMLCanvasElement): unknown {
  const constants = new Map<string, number>();
  return new Proxy({ canvas } as Record<string, unknown>, {
    has: () => true,
    get(target, name) {
      if (typeof name === "symbol" || name in target) return target[name as string];
      if (name in ANSWERS) return ANSWERS[name];
      if (/^[A-Z0-9_]+$/.test(name)) {
        const number = NUMBERS[name] ?? constants.get(name) ?? 0x10000 + constants.size;
        constants.set(name, number);
        return number;
      }
      if (name.startsWith("create")) return () => ({});
      if (name === "drawingBufferWidth") return view.width;
      if (name === "drawingBufferHeight") return view.height;
      return () => undefined;
    },
  });
}

/** Names that the page asks limits by. */
const NUMBERS: Readonly<Record<string, number>> = {
  MAX_TEXTURE_SIZE: 0x0d33,
  MAX_VIEWPORT_DIMS: 0x0d3a,
  VERSION: 0x1f02,
  VIEWPORT: 0x0ba2,
  SCISSOR_BOX: 0x0c10,
  MAX_VERTEX_ATTRIBS: 0x8869,
  MAX_TEXTURE_IMAGE_UNITS: 0x8872,
  MAX_VERTEX_TEXTURE_IMAGE_UNITS: 0x8b4c,
  MAX_COMBINED_TEXTURE_IMAGE_UNITS: 0x8b4d,
  MAX_VERTEX_UNIFORM_VECTORS: 0x8dfb,
  MAX_FRAGMENT_UNIFORM_VECTORS: 0x8dfd,
  MAX_VARYING_VECTORS: 0x8dfc,
  MAX_CUBE_MAP_TEXTURE_SIZE: 0x851c,
  MAX_SAMPLES: 0x8d57,
};

const paper = (canvas: HTMLCanvasElement): unknown =>
  new Proxy({ canvas } as Record<string, unknown>, {
    get: (target, name) =>
      name in target
        ? target[name as string]
        : name === "measureText"
          ? (text: string) => ({ width: 7 * text.length })
          : name === "getImageData"
            ? (_x: number, _y: number, w: number, h: number) => ({
                width: w,
                height: h,
                data: new Uint8ClampedArray(4 * w * h),
              })
            : () => ({ addColorStop: () => undefined }),
    set: (target, name, value) => {
      target[name as string] = value;
      return true;
    },
  });

/** Gives every canvas a context and the view its place. */
export function provideView(): void {
  const contexts = new WeakMap<HTMLCanvasElement, unknown>();
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string) {
    const found = contexts.get(this) ?? (kind === "2d" ? paper(this) : drawingNothing(this));
    contexts.set(this, found);
    return found as never;
  } as never;
  HTMLCanvasElement.prototype.toDataURL = () => "data:image/webp;base64,UklGRg==";
  Element.prototype.getBoundingClientRect = function (this: Element): DOMRect {
    if (this.id === "view") return new DOMRect(view.x, view.y, view.width, view.height);
    // The words stand over the point that they speak of.
    const hint = this.closest<HTMLElement>(".hint:not([hidden])");
    const tip = hint && placeOf(hint);
    if (tip) return new DOMRect(view.x + tip.x, view.y + tip.y - TIP, 0, 0);
    const at = this instanceof HTMLElement && !this.hidden ? placeOf(this) : null;
    return at ? new DOMRect(view.x + at.x, view.y + at.y, 0, 0) : new DOMRect(0, 0, 0, 0);
  };
  for (const [name, size] of [
    ["clientWidth", () => view.width],
    ["clientHeight", () => view.height],
  ] as const)
    Object.defineProperty(Element.prototype, name, {
      configurable: true,
      get(this: Element) {
        return this.id === "view" ? size() : 0;
      },
    });
  Element.prototype.setPointerCapture = () => {};
  Element.prototype.releasePointerCapture = () => {};
  Element.prototype.hasPointerCapture = () => false;
}
