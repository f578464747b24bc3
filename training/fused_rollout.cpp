#include "training/element_law.hpp"

#include <ATen/core/ivalue.h>
#include <tbb/parallel_for.h>
#include <torch/csrc/autograd/custom_function.h>
#include <torch/types.h>

#include <cstring>
#include <functional>

#include "training/element_rollout.hpp"

namespace sandgraph::training {
namespace {

using namespace fused;
using torch::Tensor;
using torch::autograd::AutogradContext;
using torch::autograd::variable_list;

// Number `lane` of block `block`; past the last history, that one again.
template <class T>
Lanes<T> lanes_of(const Tensor& row, std::size_t block) {
    const auto values = row.accessor<T, 1>();
    Lanes<T> out;
    for (int lane = 0; lane < lanes; ++lane)
        out[lane] =
            values[std::min<std::int64_t>(static_cast<std::int64_t>(block) * lanes + lane, row.size(0) - 1)];
    return out;
}

template <class T>
void fill_constants(const Batch& batch, std::size_t block, Given<T>& g) {
    const auto of = [&](const Tensor& t) { return lanes_of<T>(t.contiguous(), block); };
    g.log_p0 = of(batch.p0.log());
    g.K0 = of(batch.K0), g.G0 = of(batch.G0), g.p_least = of(1e-3 * batch.p0);
    g.fabric_re = of(batch.fabric.select(1, 0)), g.fabric_im = of(batch.fabric.select(1, 1));
    g.still = {(g.log_p0 - T(std::log(1e4))) / T(3), of((batch.e0 - 0.22) / 0.04), of((batch.Z0 - 3.5) / 0.5),
               of((batch.sin_phi - 0.5) / 0.1)};
}

template <class T>
Blocks<T> blocks_of(const Batch& batch) {
    Blocks<T> blocks{batch.steps(), batch.size(), {}, {}};
    const Tensor de_re = batch.de.select(2, 0).contiguous(), de_im = batch.de.select(2, 1).contiguous();
    const Tensor e = (((1 + batch.e0) * batch.J - 1 - 0.22) / 0.04).contiguous();
    const auto count = static_cast<std::size_t>((batch.size() + lanes - 1) / lanes);
    for (std::size_t block = 0; block < count; ++block) {
        Given<T> g{};
        fill_constants(batch, block, g);
        std::vector<Given<T>> steps(static_cast<std::size_t>(batch.steps()), g);
        for (std::int64_t t = 0; t < batch.steps(); ++t) {
            Given<T>& step = steps[static_cast<std::size_t>(t)];
            step.dv = lanes_of<T>(batch.dv[t], block), step.e = lanes_of<T>(e[t], block);
            step.p_measured = lanes_of<T>(batch.p[t], block), step.lead = lanes_of<T>(batch.lead[t], block);
            step.de_re = lanes_of<T>(de_re[t], block), step.de_im = lanes_of<T>(de_im[t], block);
        }
        State<T> start{lanes_of<T>(batch.p0, block), Lanes<T>::Zero(), {}, {}};
        start.re.fill(Lanes<T>::Zero());
        start.im.fill(Lanes<T>::Zero());
        start.re[0] = lanes_of<T>(batch.s0.select(1, 0).contiguous(), block);
        start.im[0] = lanes_of<T>(batch.s0.select(1, 1).contiguous(), block);
        blocks.given.push_back(std::move(steps));
        blocks.start.push_back(start);
    }
    return blocks;
}

// One row of numbers a member [E, ...].
template <class T>
std::vector<Weights<T>> weights_of(const Tensor& constants) {
    std::vector<Weights<T>> members(static_cast<std::size_t>(constants.size(0)));
    TORCH_CHECK(constants.numel() * sizeof(T) == members.size() * sizeof(Weights<T>));
    std::memcpy(static_cast<void*>(members.data()), constants.data_ptr<T>(),
                members.size() * sizeof(Weights<T>));
    return members;
}

// A rollout that waits for its adjoint.
struct Rolled : torch::CustomClassHolder {
    virtual Tensor answers() const = 0;                        // p, re s, im s, slip [4, E, T, B]
    virtual Tensor gradient(const Tensor& adjoint) const = 0;  // of the constants
};

template <class T>
class Job : public Rolled {
  public:
    Job(const Batch& batch, const Tensor& constants, const Tensor& low, const Tensor& high, bool net)
        : members_(weights_of<T>(constants)),
          blocks_(blocks_of<T>(batch)),
          net_(net),
          answers_(torch::empty({4, constants.size(0), batch.steps(), batch.size()}, batch.dv.options())) {
        std::copy_n(low.data_ptr<T>(), X, range_.low.data());
        std::copy_n(high.data_ptr<T>(), X, range_.high.data());
    }
    void run(bool keep) {
        tapes_.resize(keep ? count() : 0);
        each([&](std::size_t k, std::size_t e, std::size_t block) {
            if (keep) tapes_[k].resize(static_cast<std::size_t>(blocks_.steps));
            roll_out(members_[e], range_, blocks_, block, net_, rows_of<T>(answers_, e),
                     keep ? &tapes_[k] : nullptr);
        });
    }
    Tensor answers() const override { return answers_; }
    Tensor gradient(const Tensor& adjoint) const override;

  private:
    std::size_t count() const { return members_.size() * blocks_.given.size(); }
    // Every piece of work is one member and one block of histories; nothing depends on who does it.
    void each(const std::function<void(std::size_t, std::size_t, std::size_t)>& work) const {
        tbb::parallel_for(std::size_t{0}, count(), [&](std::size_t k) {
            work(k, k / blocks_.given.size(), k % blocks_.given.size());
        });
    }
    template <class N>
    static Answers<N> rows_of(const Tensor& all, std::size_t member) {
        const auto at = [&](std::int64_t which) {
            return all[which][static_cast<std::int64_t>(member)].data_ptr<T>();
        };
        return {at(0), at(1), at(2), at(3)};
    }

    std::vector<Weights<T>> members_;
    Range<T> range_;
    Blocks<T> blocks_;
    bool net_;
    Tensor answers_;
    std::vector<std::vector<State<T>>> tapes_;  // [member x block]
};

template <class T>
Tensor Job<T>::gradient(const Tensor& adjoint) const {
    constexpr auto size = static_cast<std::int64_t>(sizeof(Weights<T>) / sizeof(T));
    const Tensor a = adjoint.contiguous();
    std::vector<Weights<T>> parts(count());
    each([&](std::size_t k, std::size_t e, std::size_t block) {
        parts[k] = roll_back(members_[e], range_, blocks_, block, net_, rows_of<const T>(a, e), tapes_[k]);
    });
    Tensor out = torch::zeros({std::ssize(members_), size}, answers_.options());
    for (std::size_t k = 0; k < parts.size(); ++k) {
        T* to = out.data_ptr<T>() + static_cast<std::int64_t>(k / blocks_.given.size()) * size;
        const T* from = reinterpret_cast<const T*>(&parts[k]);
        for (std::int64_t i = 0; i < size; ++i) to[i] += from[i];
    }
    return out;
}

c10::intrusive_ptr<Rolled> roll(const Batch& batch, const Tensor& constants, const Tensor& low,
                                const Tensor& high, bool net, bool keep) {
    const auto start = [&]<class T>(T) -> c10::intrusive_ptr<Rolled> {
        auto job = c10::make_intrusive<Job<T>>(batch, constants, low.contiguous(), high.contiguous(), net);
        job->run(keep);
        return job;
    };
    return batch.dv.scalar_type() == torch::kFloat ? start(0.0f) : start(0.0);
}

class Rollout : public torch::autograd::Function<Rollout> {
  public:
    static Tensor forward(AutogradContext* context, const Batch* batch, const Tensor& low, const Tensor& high,
                          bool net, bool keep, const Tensor& constants) {
        auto rolled = roll(*batch, constants, low, high, net, keep);
        const Tensor answers = rolled->answers();
        if (keep) context->saved_data["rolled"] = c10::IValue::make_capsule(std::move(rolled));
        return answers;
    }
    static variable_list backward(AutogradContext* context, const variable_list& adjoint) {
        const auto capsule = context->saved_data["rolled"].toCapsule();
        const Tensor gradient = static_cast<const Rolled&>(*capsule).gradient(adjoint[0]);
        return {Tensor(), Tensor(), Tensor(), Tensor(), Tensor(), gradient};  // in the order of forward's
    }
};

}  // namespace

Prediction roll_out_fused(const ElementLaw& law, const Batch& batch) {
    const bool net = law.rung() == Rung::learned;
    const bool keep = torch::GradMode::is_enabled();
    variable_list rows;
    for (const Tensor& c : law.constants()) rows.push_back(c.flatten(1));
    const Tensor out = Rollout::apply(&batch, law.low.to(batch.dv.dtype()), law.high.to(batch.dv.dtype()),
                                      net, keep, torch::cat(rows, 1).contiguous());
    const auto part = [&](std::int64_t k) { return out[k].transpose(0, 1); };
    return {part(0), torch::stack({part(1), part(2)}, 3), part(3)};
}

}  // namespace sandgraph::training
