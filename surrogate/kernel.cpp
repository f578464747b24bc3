#include "surrogate/kernel.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surrogate/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/contracts.hpp"
#include "surrogate/kernel_block-inl.hpp"

#if HWY_ONCE
namespace sandgraph::surrogate {

HWY_EXPORT(Serve);
HWY_EXPORT(TargetName);

void serve(const KernelModel& kernel, std::span<const std::int32_t> points, std::span<const Mat2> F_inc,
           std::span<double> states, std::span<stress::SurrogateAnswer> answers) {
    SG_EXPECT(answers.size() == points.size() && distinct_below(points, F_inc.size()));
    SG_EXPECT(all_below(points, states.size() / kernel.layout.size()));
    if (!points.empty()) HWY_DYNAMIC_DISPATCH(Serve)(kernel, points, F_inc, states, answers);
}

std::vector<std::int64_t> kernel_targets() { return hwy::SupportedAndGeneratedTargets(); }

std::string kernel_target() { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

}  // namespace sandgraph::surrogate
#endif
