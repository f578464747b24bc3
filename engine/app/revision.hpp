#pragma once

namespace sandgraph::app {

// The git revision this binary was built from ("-dirty": with uncommitted changes), or "unknown".
const char* revision();

}  // namespace sandgraph::app
