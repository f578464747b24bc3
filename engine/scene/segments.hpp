#pragma once
#include <vector>

#include "scene/element_test_spec.hpp"
#include "scene/value.hpp"

namespace sandgraph::scene {

// [[segment]] tables of a path test.
class SegmentTables : public Value {
  public:
    explicit SegmentTables(std::vector<dem::PathSegment>& segments) : segments_(segments) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return ""; }
    std::string canonical() const override;

  protected:
    std::vector<dem::PathSegment>& segments_;
};

// segments = "FILE.csv": the header Lxx,Lxy,Lyx,Lyy,steps, then one row a segment.
class SegmentFile : public SegmentTables {
  public:
    using SegmentTables::SegmentTables;
    void read(const Entry& entry) override;
};

}  // namespace sandgraph::scene
