// SPDX-License-Identifier: MIT
// Build only: rhino3dm's glue makes functions of text, which the page's policy on scripts forbids
// wherever a server sends it to workers, too. Its compiler has an option for the same without
// (DYNAMIC_EXECUTION=0); this puts what that option gives in the place of both spots. And what it
// asks of node is left out, which a browser has not.
import type { Plugin } from "vite";

/** Calls into the module, argument by argument. */
const INVOKER = `return (humanName, throwBindingError, invoker, fn, runDestructors, fromRetWire, toClassParamWire, ...others) => {
  const [toWires, destroy] = [others.slice(0, argCount), others.slice(argCount)];
  const first = isClassMethodFunc ? 1 : 2;
  return function (...args) {
    const destructors = needsDestructorStack ? [] : null;
    const wired = isClassMethodFunc ? [toClassParamWire(destructors, this)] : [];
    toWires.forEach((toWire, i) => wired.push(toWire(destructors, args[i])));
    const rv = invoker(fn, ...wired);
    if (needsDestructorStack) runDestructors(destructors);
    else wired.filter((_, i) => argTypes[first + i].destructorFunction !== null).forEach((wire, i) => destroy[i](wire));
    if (returns) return fromRetWire(rv);
  };
}`;

/** Calls from the module. */
const CALLER = `(handle, methodName, destructorsRef, args) => {
  const values = argFromPtr.map((read, i) => read(args + i * GenericWireTypeSize));
  const target = kind === 3 ? null : Emval.toValue(handle);
  const result =
    kind === 0 ? target(...values)
    : kind === 1 ? target[getStringOrSymbol(methodName)](...values)
    : kind === 2 ? new target(...values)
    : values.at(-1);
  if (!retType.isVoid) return emval_returnValue(toReturnWire, destructorsRef, result);
}`;

const SPOTS = [
  ["return new Function(args1,invokerFnBody)", INVOKER],
  ["new Function(Object.keys(captures),functionBody)(...Object.values(captures))", CALLER],
] as const;

/** Throws if the glue is written in another way than that of the version in package.json. */
export function withoutCodeFromText(glue: string): string {
  const code = SPOTS.reduce((text, [spot, closure]) => {
    if (text.split(spot).length !== 2) throw new Error(`rhino3dm has no “${spot}”`);
    return text.replace(spot, () => closure);
  }, glue);
  if (code.includes("new Function")) throw new Error("rhino3dm makes code of text elsewhere, too");
  return code;
}

const NODE =
  'const{createRequire}=await import("node:module");var require=createRequire(import.meta.url)';

export function noCodeFromText(): Plugin {
  return {
    name: "no-code-from-text",
    apply: "build",
    transform: {
      filter: { id: /\/rhino3dm\/rhino3dm\.module\.js$/ },
      handler: (code) => ({
        code: withoutCodeFromText(code).replace(NODE, "var require=null"),
        map: null,
      }),
    },
  };
}
