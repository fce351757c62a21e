// SPDX-License-Identifier: MIT
// Build only: leaves out the shaders of three.js for what the page never draws (textures, fog,
// morphs, bones, sprites, …). Inside a shader that is used, these parts stand behind an #ifdef
// that no material of ours turns on. A name that three.js no longer has is an error.
import type { Plugin } from "vite";

/** Parts that shaders include. */
const UNUSED_PARTS = `
  alphahash_fragment alphahash_pars_fragment alphamap_fragment alphamap_pars_fragment
  aomap_fragment aomap_pars_fragment batching_pars_vertex batching_vertex
  bumpmap_pars_fragment clearcoat_normal_fragment_begin clearcoat_normal_fragment_maps
  clearcoat_pars_fragment clipping_planes_fragment clipping_planes_pars_fragment
  clipping_planes_pars_vertex clipping_planes_vertex displacementmap_pars_vertex
  displacementmap_vertex dithering_fragment dithering_pars_fragment emissivemap_fragment
  emissivemap_pars_fragment envmap_common_pars_fragment envmap_fragment envmap_pars_fragment
  envmap_pars_vertex envmap_physical_pars_fragment envmap_vertex fog_fragment fog_pars_fragment
  fog_pars_vertex fog_vertex gradientmap_pars_fragment iridescence_fragment
  iridescence_pars_fragment lightmap_pars_fragment lights_lambert_fragment
  lights_lambert_pars_fragment lights_phong_fragment lights_phong_pars_fragment
  lights_toon_fragment lights_toon_pars_fragment logdepthbuf_fragment logdepthbuf_pars_fragment
  logdepthbuf_pars_vertex logdepthbuf_vertex map_fragment map_pars_fragment
  map_particle_fragment map_particle_pars_fragment metalnessmap_pars_fragment
  morphcolor_vertex morphinstance_vertex morphnormal_vertex morphtarget_pars_vertex
  morphtarget_vertex normal_fragment_maps normalmap_pars_fragment premultiplied_alpha_fragment
  roughnessmap_pars_fragment skinbase_vertex skinning_pars_vertex skinning_vertex
  skinnormal_vertex specularmap_pars_fragment tonemapping_fragment tonemapping_pars_fragment
  transmission_fragment transmission_pars_fragment uv_pars_fragment uv_pars_vertex uv_vertex`;

/** Whole shaders, of materials that the page has none of. */
const UNUSED_SHADERS =
  "background backgroundCube cube distance equirect linedashed meshlambert meshmatcap meshnormal meshphong meshtoon points sprite";

const words = (text: string): string[] => text.trim().split(/\s+/);

/** The name of the string that ShaderChunk has under `key`. */
function variableOf(code: string, key: string): string {
  const name = new RegExp(`^\\s*${key}: ([\\w$]+),?$`, "m").exec(code)?.[1];
  if (!name) throw new Error(`three.js has no shader "${key}"`);
  return name;
}

function emptied(code: string, key: string): string {
  const name = variableOf(code, key).replaceAll("$", "\\$");
  const text = new RegExp(`^(?:var|const) ${name} = "(?:[^"\\\\]|\\\\.)*";$`, "m");
  if (!text.test(code)) throw new Error(`three.js writes its shader "${key}" in another way`);
  return code.replace(text, (found) => `${found.slice(0, found.indexOf('"'))}"";`);
}

export function smallShaders(): Plugin {
  const keys = [
    ...words(UNUSED_PARTS),
    ...words(UNUSED_SHADERS).flatMap((name) => [`${name}_vert`, `${name}_frag`]),
  ];
  return {
    name: "small-shaders",
    apply: "build",
    transform: {
      filter: { id: /\/three\/build\/three\.module\.js$/ },
      handler: (code) => ({ code: keys.reduce(emptied, code), map: null }),
    },
  };
}
