#pragma once
#include <limits>
#include <span>
#include <string>
#include <vector>

// The stability suite: cases that break solvers, each with bounds stated beforehand and what was measured.
namespace sandgraph::stability {

enum class Effort { quick, full };  // quick: for every build; full: as the table states it

// What was measured against what it must keep to. A NaN keeps to nothing.
struct Check {
    std::string what;
    double value = 0, low = -std::numeric_limits<double>::infinity(),
           high = std::numeric_limits<double>::infinity();
    std::string why = "";  // the bound is what it is
    bool bounded() const { return low > -std::numeric_limits<double>::infinity() || bounded_above(); }
    bool bounded_above() const { return high < std::numeric_limits<double>::infinity(); }
    bool holds() const { return !bounded() || (value >= low && value <= high); }
};

class Findings {
  public:
    std::string driven;  // what is driven, to where
    void at_most(std::string what, double value, double high);
    void at_least(std::string what, double value, double low);
    void within(std::string what, double value, double low, double high);
    void exactly(std::string what, double value, double wanted);
    void note(std::string what, double value);  // reported, without a bound
    void because(std::string why);              // why the bound of the check just made is what it is
    void add(Check check) { checks_.push_back(std::move(check)); }
    const std::vector<Check>& checks() const { return checks_; }

  private:
    std::vector<Check> checks_;
};

struct Case {
    const char* name;  // group.case
    void (*run)(Effort effort, Findings& found);
};

std::span<const Case> rve_cases();
std::span<const Case> repeat_cases();
std::span<const Case> killed_cases();
std::span<const Case> disk_cases();
std::span<const Case> gate_cases();
std::span<const Case> lying_cases();
std::span<const Case> plate_cases();
std::span<const Case> mesh_cases();
std::span<const Case> falling_cases();
std::span<const Case> collapse_cases();
std::span<const Case> time_step_cases();
std::span<const Case> column_cases();
std::span<const Case> rve_increment_cases();

// A row of the table for each check of a finished case.
struct Outcome {
    std::string name;
    Findings found;
    double seconds = 0;         // wall time
    std::string revision = "";  // of the program that measured it
    bool holds() const;
};

// Runs a case; what it throws becomes a check that does not hold.
Outcome run(const Case& c, Effort effort);

}  // namespace sandgraph::stability
