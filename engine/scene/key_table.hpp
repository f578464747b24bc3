#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/numbers.hpp"
#include "scene/words.hpp"

namespace sandgraph::scene {

// A key of a TOML file: what it is called, what it means, and the struct member it fills.
struct Key {
    std::string section, name, meaning;
    std::unique_ptr<Value> value;
    bool in_hash = true;  // does the key change results?
    bool given = false;   // was it in a file or an override?
    InputError::Where where{};

    std::string full_name() const { return section.empty() ? name : section + "." + name; }
};

// "section.name" of the keys that a file or an override sets, and where it does so.
using GivenKeys = std::map<std::string, InputError::Where, std::less<>>;

// All keys that a kind of file may have. The table refuses everything else with the nearest name it knows.
class KeyTable {
  public:
    // Keys of one [section]; "" is the top of the file. Members given to it must outlive the table.
    class Section {
      public:
        Section(KeyTable& table, std::string name) : table_(table), name_(std::move(name)) {}
        Key& add(const char* name, std::unique_ptr<Value> value, const char* meaning);
        Key& real(const char* name, double& value, const char* unit, Range range, const char* meaning);
        Key& flag(const char* name, bool& value, const char* meaning);
        Key& text(const char* name, std::string& value, const char* meaning);
        Key& input_file(const char* name, std::string& value, const char* meaning);
        template <class Int>
        Key& integer(const char* name, Int& value, std::int64_t low, const char* meaning,
                     std::vector<std::int64_t> only = {}) {
            return add(name, std::make_unique<Integer<Int>>(value, low, std::move(only)), meaning);
        }
        // `names` in the order of the enumerators.
        template <class Enum>
        Key& choice(const char* name, Enum& value, std::vector<std::string> names, const char* meaning) {
            const auto set = [&value](std::size_t index) { value = static_cast<Enum>(index); };
            const auto get = [&value] { return static_cast<std::size_t>(value); };
            return add(name, std::make_unique<Choice>(std::move(names), set, get), meaning);
        }

      private:
        KeyTable& table_;
        std::string name_;
    };

    Section section(std::string name) { return {*this, std::move(name)}; }
    // Fills the members from `root`; `file` names it in errors. May be called again: later values win.
    void read(const toml::table& root, const std::string& file, NamedFiles files = NamedFiles::exist);

    const std::vector<Key>& keys() const { return keys_; }
    // The key "section.name", which must exist.
    const Key& at(std::string_view full_name) const;
    GivenKeys given() const;

  private:
    void read_section(const toml::table& table, const std::string& section, const std::string& file);
    void read_key(const toml::node& node, const std::string& section, const std::string& name,
                  const std::string& file);
    [[noreturn]] void refuse_key(const Entry& entry, const std::string& section,
                                 const std::string& name) const;
    std::vector<std::string> section_names() const;

    std::vector<Key> keys_;
    NamedFiles files_ = NamedFiles::exist;  // of what is being read
};

}  // namespace sandgraph::scene
