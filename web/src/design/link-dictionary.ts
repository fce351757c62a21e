// SPDX-License-Identifier: MIT
/**
 * What the text of most designs holds, the commonest last: zlib's preset dictionary of links "#v2=". ASCII.
 * It is part of every link: another one is another version.
 */
export const DICTIONARY = [
  '"title":"","hash":"00000000","format":"obj","text":"# \\r\\nv 0.\\nv -1.\\ng \\nf 1 2 3 4\\nf ","bytes":"',
  '"cuts":["split=","strip=","corner=","refine=","trim="],"symmetry":["x","y","axis:z:2"],',
  '"supports":["polyline:","surface:","surface=","spring=","plane=0,0,1,","line=0,0,","level=x:","level=y:',
  '"],"supports":["level=z:boundary"],"supports":["outline:boundary"],"continuation":16,',
  '"reach_length":0.5,"clearance":0.1,"keep_out":["below=0","above=","box=","self","mesh="],',
  '"bounds":["fold=+5","angle=","area=","edge=","sheet="],"bounds":["fold=25"],',
  '"constraints":[{"kind":"conical","tolerance":1e-09}],"constraints":[{"kind":"circular","tolerance":1e-09}],',
  '"within":0.5,"flat":20.0,"sparsity":"l2","fairness":"third","fairness":"laplacian","hard":true,',
  '"eigen":true,"family":8,"exact":false,"smooth":100.0,"close":[]',
  '}},\n "page": {"n":"","v":[["","p":[2,0.0,0],"g":[["","s":[{"n":"Snapshot 1","planarised":false,"handles":',
  '{"sample":"trihex","hex","dome","vault","roof","freeform","size":',
  '{"format":"planish-design","version":1,"source":{"file":".obj","format":"obj","text":"',
  '"},"planarised":{"smooth":100.0,"keep_boundary":true,"shape":true},"unit":"mm","planarised":true,"unit":"cm",',
  '"pins":[],"options":{"attraction":10000.0,"locality":1.0,"smoothness":1.0,"fairness":"second",',
  '"sparsity":"l21","hard":false,"solver":"newton","tolerance":1e-06,"max_iterations":0,"shape":true,',
  '"reach":6,"keep_boundary":true,"softness":5.0},"variations":[],"result":{"hash":"',
  '{"format":"planish-design","version":1,"source":{"sample":"freeform","size":28},"planarised":false,',
  '"unit":"m","handles":[[1,0.0,0.0,0.0]],"pins":[],"options":{"attraction":1000.0,"locality":1.0,',
  '"smoothness":1.0,"fairness":"second","sparsity":"l21","hard":false,"solver":"newton","tolerance":1e-06,',
  '"max_iterations":0,"shape":true},"variations":[{"dimension":4,"eigen":false,"fairness_weight":3.0,',
  '"sparsity_weight":1.0,"closeness_weight":0.0,"correlation":0.95,"reach":2,"coefficients":[0.0,0.0,0.0,0.0],',
  '"exact":true}],"result":{"hash":"","moved":,"probes":[[]]}},\n "page": {"c":[',
].join("");
