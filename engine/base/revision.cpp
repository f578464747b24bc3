#include "base/revision.hpp"

#include "revision_define.hpp"

namespace sandgraph {

const char* revision() { return SANDGRAPH_REVISION; }

const char* version() { return SANDGRAPH_VERSION; }

}  // namespace sandgraph
