#pragma once
#include <vector>

#include "scene/range.hpp"
#include "scene/value.hpp"

namespace sandgraph::scene {

// A real number; with a unit it must be written as text ("30 kPa"), without one as a bare number.
class Real : public Value {
  public:
    Real(double& value, std::string unit, Range range)
        : value_(value), unit_(std::move(unit)), range_(range) {}
    void read(const Entry& entry) override;
    std::string shown() const override;
    std::string canonical() const override;
    std::string allowed() const override { return range_.text(unit_); }
    bool unit_weight() const override { return unit_weight_; }

  protected:
    std::string shown(double value) const;

  private:
    double quantity(const Entry& entry) const;
    double& value_;
    std::string unit_;
    Range range_;
    bool unit_weight_ = false;
};

// A real number that stays 0 unless it is given, for the program to derive; `usual` is what that gives for
// the usual grains.
class DerivedReal : public Real {
  public:
    DerivedReal(double& value, std::string unit, Range range, double usual)
        : Real(value, std::move(unit), range), value_(value), usual_(usual) {}
    std::string shown() const override { return Real::shown(value_ == 0 ? usual_ : value_); }

  private:
    double& value_;
    double usual_;
};

// A list of bare numbers, rising.
class RisingReals : public Value {
  public:
    RisingReals(std::vector<double>& values, Range range) : values_(values), range_(range) {}
    void read(const Entry& entry) override;
    std::string shown() const override;
    std::string canonical() const override;
    std::string allowed() const override { return "rising, each " + range_.text(""); }

  private:
    std::vector<double>& values_;
    Range range_;
};

// A whole number of at least `low` (and one of `only`, unless that is empty).
template <class Int>
class Integer : public Value {
  public:
    Integer(Int& value, std::int64_t low, std::vector<std::int64_t> only = {})
        : value_(value), low_(low), only_(std::move(only)) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return std::to_string(value_); }
    std::string canonical() const override { return std::to_string(value_); }
    std::string allowed() const override;

  private:
    Int& value_;
    std::int64_t low_;
    std::vector<std::int64_t> only_;
};

extern template class Integer<int>;
extern template class Integer<std::int64_t>;
extern template class Integer<std::uint64_t>;

}  // namespace sandgraph::scene
