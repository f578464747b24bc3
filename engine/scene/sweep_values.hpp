#pragma once
#include <vector>

#include "scene/sweep_spec.hpp"

namespace sandgraph::scene {

// [set]: keys of the scene, `grains.count = 200` or `"grains.count" = 200`.
class SettingsTable : public Value {
  public:
    explicit SettingsTable(std::vector<SweepSetting>& settings) : settings_(settings) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "{}"; }
    std::string canonical() const override { return shown(); }
    std::string allowed() const override { return "keys of the scene and their values"; }

  private:
    std::vector<SweepSetting>& settings_;
};

// [[axis]] tables:
//   key = "anchor.embedment_ratio"
//   values = [2, 3, 5]
//   with = { "domain.depth" = ["7 m", "8 m", "10 m"] }   other keys that change with it
class AxisTables : public Value {
  public:
    explicit AxisTables(std::vector<SweepAxis>& axes) : axes_(axes) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "[]"; }
    std::string canonical() const override { return shown(); }
    std::string allowed() const override { return "[[axis]] tables: key, values, with"; }

  private:
    std::vector<SweepAxis>& axes_;
};

}  // namespace sandgraph::scene
