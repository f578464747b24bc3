#pragma once
#include "surrogate/model.hpp"
#include "training/law.hpp"

namespace sandgraph::training {

// Frictional elements side by side whose stiffness, strength and dilatancy a small network sets from the
// state's invariants: the equations of surrogate/, which serves what is trained here. The rung says how much
// of it is free: elastic (no element slips), fitted (constants only), learned (the network too).
class ElementLaw : public Law {
  public:
    static constexpr std::int64_t elements = 8, hidden = 16, outputs = 3 * elements + 1;
    static constexpr auto features = static_cast<std::int64_t>(surrogate::feature_count);

    ElementLaw(Rung rung, std::int64_t members, std::uint64_t seed);
    Prediction rollout(const Batch& batch) const override;
    std::int64_t members() const override { return exponent.size(0); }
    void start_from(const surrogate::Model& model, const std::string& file) override;
    void hold_critical_state() override { measured_critical = true; }
    void learn_ranges(std::span<const Batch> batches) override;
    std::optional<surrogate::Model> served(double substep) const override;
    Rung rung() const { return rung_; }
    // What a step uses, member first: exponent, bulk, critical state, share, strength, W1, b1, W2, b2, W3, b3
    // (dilatancy and the shift of the bounded factors included).
    std::vector<torch::Tensor> constants() const;
    torch::Tensor critical_state() const;  // mature, pull, void ratio, slope [E, 4]

    // Midpoint rule as the kernel has it; without, coefficients are those of a step's beginning (half the
    // cost, good enough to train on short steps).
    bool midpoint = false;
    // Critical state's void ratio and slope stay as surrogate::CriticalState has them, which is as measured.
    bool measured_critical = false;
    // One operation for the whole rollout, its adjoint by hand; otherwise step by step, differentiated by
    // torch.
    bool fused = true;

    // Parameters, member first: what surrogate::Member holds, by its logarithm or the like where bounded.
    torch::Tensor exponent;  // [E], by sigmoid
    torch::Tensor log_bulk;  // [E]
    torch::Tensor critical;  // [E, 4]: log of mature and of pull, void ratio/0.04, log of slope
    torch::Tensor share, log_strength, dilatancy;  // [E, M]; share by softmax
    torch::Tensor W1, b1, W2, b2, W3, b3;          // [E, in, out], [E, 1, out]
    torch::Tensor low, high;                       // [features] clamp; no parameters

  private:
    struct Fixed;
    struct State;
    struct Coefficients;
    torch::Tensor output_bias() const;
    Fixed fix(const Batch& batch) const;
    State start(const Fixed& fixed) const;
    torch::Tensor network(const Fixed& fixed, const State& state, const torch::Tensor& layer1) const;
    static torch::Tensor drawn(const Fixed& fixed, const State& state, const torch::Tensor& e,
                               const torch::Tensor& own);
    Coefficients coefficients(const Fixed& fixed, const State& state, const torch::Tensor& layer1,
                              const torch::Tensor& e) const;
    State return_map(const Fixed& fixed, const State& state, const Coefficients& c, std::int64_t step,
                     double part) const;
    static void lead(const Batch& batch, std::int64_t step, State& state);

    Rung rung_;
    bool ranged_ = false;  // low and high tell what it was trained on, and not only where it starts
};

// ElementLaw::rollout with the coefficients of a step's beginning as one operation of torch. The gradient
// takes the loading of the elements at the start as given (zero where the start is isotropic).
Prediction roll_out_fused(const ElementLaw& law, const Batch& batch);

}  // namespace sandgraph::training
