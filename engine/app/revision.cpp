#include "app/revision.hpp"

#include "revision_define.hpp"

namespace sandgraph::app {

const char* revision() { return SANDGRAPH_REVISION; }

}  // namespace sandgraph::app
