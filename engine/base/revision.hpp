#pragma once

namespace sandgraph {

// The git revision this binary was built from ("-dirty": with uncommitted changes), or "unknown".
const char* revision();

const char* version();  // of the project, as in CMakeLists.txt

}  // namespace sandgraph
