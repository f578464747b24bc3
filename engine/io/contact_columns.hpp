#pragma once
#include <vector>

#include "dem/packing/packing.hpp"
#include "io/h5_group.hpp"

namespace sandgraph::io {

// Contact history as one dataset per member of dem::Contact.
void write_contacts(h5::Group group, const std::vector<dem::Contact>& contacts);
std::vector<dem::Contact> read_contacts(const h5::Group& group);

}  // namespace sandgraph::io
