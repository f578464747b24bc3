#include "training/path.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "base/contracts.hpp"
#include "stress/increment.hpp"

namespace sandgraph::training {
namespace {

using Complex = std::complex<double>;

struct Strain {
    double dv = 0;
    Complex de;
    double angle = 0;

    double size() const { return std::sqrt(0.5 * dv * dv + 2 * std::norm(de)); }
    double dot(const Strain& o) const { return 0.5 * dv * o.dv + 2 * (de * std::conj(o.de)).real(); }
};

Strain strain_of(const Mat2& F) {
    const stress::Increment E = stress::increment(F);
    return {-(E.xx + E.yy), {-0.5 * (E.xx - E.yy), -E.xy}, std::atan2(E.sin, E.cos)};
}

double lead(const CutRule& rule, double path, double size) {
    if (rule.lead_strain <= 0) return 0;
    const double fully = std::clamp(path / rule.lead_from - 1, 0.0, 1.0);
    return fully * -std::expm1(-size / rule.lead_strain);
}

// Walks along a history and closes a step when the rule says so.
class Cutter {
  public:
    explicit Cutter(const CutRule& rule) : rule_(rule) {}

    bool closes_before(const Strain& next) const { return turns(next) && strain_of(F_).size() > rule_.least; }
    bool full() const {
        const double size = rule_.share * since_turn_;
        return strain_of(F_).size() >= std::clamp(size, rule_.least, rule_.most);
    }
    void add(const Mat2& F) {
        F_ = F * F_;
        open_ = true;
    }
    bool open() const { return open_; }
    void turn() { since_turn_ = 0; }
    Step close(const Stress& measured);

  private:
    // Against the direction of the open step: a reversal, after which the answer is stiff again.
    bool turns(const Strain& next) const {
        const Strain sum = strain_of(F_);
        return open_ && sum.dot(next) < 0.3 * sum.size() * next.size();
    }

    CutRule rule_;
    Mat2 F_ = Mat2::Identity();
    bool open_ = false;
    double since_turn_ = 0, path_ = 0, angle_ = 0, J_ = 1;
};

Step Cutter::close(const Stress& measured) {
    const Strain E = strain_of(F_);
    const double J = F_.determinant();
    Step step{E.dv,
              E.de * std::polar(1.0, -2 * angle_),
              J_,
              J_ * 0.5 * (1 + J),
              path_ += E.size(),
              mean_stress(measured),
              {}};
    since_turn_ += E.size();
    angle_ += E.angle;
    J_ *= J;
    step.s = deviator_of(measured) * std::polar(1.0, -2 * angle_);
    step.lead = lead(rule_, path_, E.size());
    step.weight = std::sqrt(std::min(1.0, E.size() / std::max(rule_.share * since_turn_, 1e-12)));
    F_ = Mat2::Identity();
    open_ = false;
    return step;
}

}  // namespace

Complex deviator_of(const Stress& stress) { return {-0.5 * (stress.xx - stress.yy), -stress.xy}; }

std::vector<Step> cut(const History& history, const CutRule& rule) {
    SG_EXPECT(history.F_inc.size() == history.stress.size());
    SG_EXPECT(rule.least > 0 && rule.most >= rule.least && rule.share > 0);
    std::vector<Step> steps;
    Cutter cutter(rule);
    for (std::size_t row = 0; row < history.F_inc.size(); ++row) {
        if (cutter.closes_before(strain_of(history.F_inc[row]))) {
            steps.push_back(cutter.close(history.stress[row - 1]));
            cutter.turn();
        }
        cutter.add(history.F_inc[row]);
        if (cutter.full()) steps.push_back(cutter.close(history.stress[row]));
    }
    if (cutter.open()) steps.push_back(cutter.close(history.stress.back()));
    return steps;
}

}  // namespace sandgraph::training
