#include "io/contact_columns.hpp"

#include <fmt/format.h>

#include "io/h5_dataset.hpp"

namespace sandgraph::io {
namespace {

template <class T>
void write_member(h5::Group& group, const char* name, const char* unit,
                  const std::vector<dem::Contact>& contacts, T dem::Contact::*member) {
    std::vector<T> column;
    column.reserve(contacts.size());
    for (const dem::Contact& c : contacts) column.push_back(c.*member);
    h5::write(group, name, std::span<const T>(column), {column.size()}, unit);
}

template <class T>
void read_member(const h5::Group& group, const char* name, std::vector<dem::Contact>& contacts,
                 T dem::Contact::*member) {
    const std::vector<T> column = h5::read<T>(group, name);
    if (column.size() != contacts.size())
        h5::refuse(group, fmt::format("{} has {} entries", group.path_of(name), column.size()),
                   fmt::format("there are {} contacts", contacts.size()));
    for (std::size_t c = 0; c < column.size(); ++c) contacts[c].*member = column[c];
}

}  // namespace

void write_contacts(h5::Group group, const std::vector<dem::Contact>& contacts) {
    write_member(group, "i", "", contacts, &dem::Contact::i);
    write_member(group, "j", "", contacts, &dem::Contact::j);
    write_member(group, "cell_x", "", contacts, &dem::Contact::cell_x);
    write_member(group, "cell_y", "", contacts, &dem::Contact::cell_y);
    write_member(group, "tangential", "N", contacts, &dem::Contact::tangential);
    write_member(group, "moment", "N m", contacts, &dem::Contact::moment);
}

std::vector<dem::Contact> read_contacts(const h5::Group& group) {
    std::vector<dem::Contact> contacts(h5::read<std::int32_t>(group, "i").size());
    read_member(group, "i", contacts, &dem::Contact::i);
    read_member(group, "j", contacts, &dem::Contact::j);
    read_member(group, "cell_x", contacts, &dem::Contact::cell_x);
    read_member(group, "cell_y", contacts, &dem::Contact::cell_y);
    read_member(group, "tangential", contacts, &dem::Contact::tangential);
    read_member(group, "moment", contacts, &dem::Contact::moment);
    return contacts;
}

}  // namespace sandgraph::io
