#pragma once
#include <functional>
#include <vector>

#include "scene/value.hpp"

namespace sandgraph::scene {

class Flag : public Value {
  public:
    explicit Flag(bool& value) : value_(value) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return value_ ? "true" : "false"; }
    std::string canonical() const override { return shown(); }
    std::string allowed() const override { return "true or false"; }

  private:
    bool& value_;
};

class Text : public Value {
  public:
    explicit Text(std::string& value) : value_(value) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "\"" + value_ + "\""; }
    std::string canonical() const override { return shown(); }

  protected:
    std::string& value_;
};

// An existing file; a relative name is looked up beside the file that names it, then in the current folder.
class InputFile : public Text {
  public:
    using Text::Text;
    void read(const Entry& entry) override;
    bool names_file() const override { return true; }
};

// One of a list of names; the index in the list goes to `set` and comes from `get`.
class Choice : public Value {
  public:
    Choice(std::vector<std::string> names, std::function<void(std::size_t)> set,
           std::function<std::size_t()> get)
        : names_(std::move(names)), set_(std::move(set)), get_(std::move(get)) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "\"" + names_[get_()] + "\""; }
    std::string canonical() const override { return shown(); }
    std::string allowed() const override;

  private:
    std::vector<std::string> names_;
    std::function<void(std::size_t)> set_;
    std::function<std::size_t()> get_;
};

}  // namespace sandgraph::scene
