// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace planish {

/// What the text of most designs holds, the commonest last: the preset dictionary of zlib for links
/// "#v2=". ASCII. It is part of every link: another one is another version.
inline constexpr std::string_view kLinkDictionary =
    R"("title":"","hash":"00000000","format":"obj","text":"# \r\nv 0.\nv -1.\ng \nf 1 2 3 4\nf ",)"
    R"("bytes":""cuts":["split=","strip=","corner=","refine=","trim="],"symmetry":["x","y",)"
    R"("axis:z:2"],"supports":["polyline:","surface:","surface=","spring=","plane=0,0,1,",)"
    R"("line=0,0,","level=x:","level=y:"],"supports":["level=z:boundary"],)"
    R"("supports":["outline:boundary"],"continuation":16,"reach_length":0.5,"clearance":0.1,)"
    R"("keep_out":["below=0","above=","box=","self","mesh="],"bounds":["fold=+5","angle=",)"
    R"("area=","edge=","sheet="],"bounds":["fold=25"],"constraints":[{"kind":"conical",)"
    R"("tolerance":1e-09}],"constraints":[{"kind":"circular","tolerance":1e-09}],"within":0.5,)"
    R"("flat":20.0,"sparsity":"l2","fairness":"third","fairness":"laplacian","hard":true,)"
    R"("eigen":true,"family":8,"exact":false,"smooth":100.0,"close":[]}},)"
    "\n"
    R"( "page": {"n":"","v":[["","p":[2,0.0,0],"g":[["","s":[{"n":"Snapshot 1",)"
    R"("planarised":false,"handles":{"sample":"trihex","hex","dome","vault","roof","freeform",)"
    R"("size":{"format":"planish-design","version":1,"source":{"file":".obj","format":"obj",)"
    R"("text":""},"planarised":{"smooth":100.0,"keep_boundary":true,"shape":true},"unit":"mm",)"
    R"("planarised":true,"unit":"cm","pins":[],"options":{"attraction":10000.0,"locality":1.0,)"
    R"("smoothness":1.0,"fairness":"second","sparsity":"l21","hard":false,"solver":"newton",)"
    R"("tolerance":1e-06,"max_iterations":0,"shape":true,"reach":6,"keep_boundary":true,)"
    R"("softness":5.0},"variations":[],"result":{"hash":"{"format":"planish-design","version":1,)"
    R"("source":{"sample":"freeform","size":28},"planarised":false,"unit":"m","handles":[[1,0.0,)"
    R"(0.0,0.0]],"pins":[],"options":{"attraction":1000.0,"locality":1.0,"smoothness":1.0,)"
    R"("fairness":"second","sparsity":"l21","hard":false,"solver":"newton","tolerance":1e-06,)"
    R"("max_iterations":0,"shape":true},"variations":[{"dimension":4,"eigen":false,)"
    R"("fairness_weight":3.0,"sparsity_weight":1.0,"closeness_weight":0.0,"correlation":0.95,)"
    R"("reach":2,"coefficients":[0.0,0.0,0.0,0.0],"exact":true}],"result":{"hash":"","moved":,)"
    R"("probes":[[]]}},)"
    "\n"
    R"( "page": {"c":[)";

}  // namespace planish
