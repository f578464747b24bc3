// Formulations of the contact force loop side by side on one packing in simple shear, and how far the kernel
// is from the machine. Usage: bench_kernel_forms [PACKING.csv]
//
// Tried in a prototype besides, without enough gain (400 disks, Zen 5, AVX-512):
// - staging, law and scatter of neighbouring blocks interleaved by hand: none, 2.4 to 2.7 us instead of 2.4.
// - two or four vectors of the law side by side: a tenth off the law alone, lost again with the loads around
// it.
// - contact constants (k_n) stored by pair: 4 %, but a pass more at every visit, and a visit has a few steps.
// Not tried, by estimate only:
// - RVE-per-lane batches: RVEs share no contact topology, so every lane would gather for itself.
// - float for what is not the overlap: f_n and the normal must stay double to keep 1e-9 of the reference, and
// the
//   rest is 20 of 50 operations, against conversions of every field.
#include "tests/bench/kernel_forms.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/kernel_forms.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "support/paths.hpp"
#include "tests/bench/kernel_forms-inl.hpp"

#if HWY_ONCE
namespace sandgraph::dem {
HWY_EXPORT(StagedForces);
HWY_EXPORT(LawOnly);
HWY_EXPORT(TwoRves);
HWY_EXPORT(ForceGather);
HWY_EXPORT(GrainGather);

namespace {

constexpr double kStep = 1e-5;
const KernelConstants kLaw = kernel_constants(Material{});

double force_error(const FastState& s, const std::vector<double>& expected) {
    double error = 0, scale = 0;
    for (int g = 0; g < s.grains; ++g)
        for (int c = 0; c < 2; ++c) {
            error = std::max(error, std::abs(s.force[4 * g + c] - expected[4 * g + c]));
            scale = std::max(scale, std::abs(expected[4 * g + c]));
        }
    return error / scale;
}

void print_forms(const bench::Sheared& sheared, double clock, int contacts) {
    FastState first = sheared.state;
    contact_forces(first, kLaw, kStep, nullptr);
    const std::vector<double> expected(first.force.begin(), first.force.end());
    FastState s = sheared.state, other = sheared.later;
    GrainContacts grains(s);
    struct Form {
        const char* name;
        std::function<void()> run;
        double rves = 1;
    };
    const std::vector<Form> forms = {
        {"kernel: pair loop, records transposed in registers",
         [&] { contact_forces(s, kLaw, kStep, nullptr); }},
        {"pair loop, records staged in memory",
         [&] {
             HWY_DYNAMIC_DISPATCH(StagedForces)
             (s, kLaw, kStep);
         }},
        {"pair loop, two RVEs in turn",
         [&] {
             HWY_DYNAMIC_DISPATCH(TwoRves)
             (s, other, kLaw, kStep);
         },
         2},
        {"pair loop, forces gathered by grain",
         [&] {
             HWY_DYNAMIC_DISPATCH(ForceGather)
             (s, kLaw, kStep, grains);
         }},
        {"grain loop, each pair twice",
         [&] {
             HWY_DYNAMIC_DISPATCH(GrainGather)
             (s, kLaw, kStep, grains);
         }},
        {"(kernel without its scatter)",
         [&] {
             HWY_DYNAMIC_DISPATCH(LawOnly)
             (s, kLaw, kStep);
         }},
    };
    std::vector<std::function<void()>> runs;
    for (const Form& form : forms) runs.push_back(form.run);
    const std::vector<double> times = bench::medians(runs);
    std::printf("%-52s %8s %14s %14s %12s\n", "form", "us", "cycles/contact", "times kernel", "force error");
    for (std::size_t f = 0; f < forms.size(); ++f) {
        const double us = 1e6 * times[f] / forms[f].rves;
        s = sheared.state, grains = GrainContacts(s);
        forms[f].run();
        std::printf("%-52s %8.3f %14.1f %14.2f %12.1e\n", forms[f].name, us, 1e3 * us * clock / contacts,
                    1e-6 * us / times[0], force_error(s, expected));
    }
}

}  // namespace
}  // namespace sandgraph::dem

int main(int argc, char** argv) {
    using namespace sandgraph::dem;
    const bench::Sheared sheared(argc > 1 ? argv[1]
                                          : sandgraph::test::test_data("/yade/packing_dense_p32.csv"));
    const double clock = bench::clock_GHz();
    const int contacts = sheared.contacts();
    std::printf("%s, clock %.2f GHz (chain of additions), %d disks, %d contacts, %d listed pairs\n",
                kernel_target().c_str(), clock, sheared.state.grains, contacts, sheared.state.pairs);
    print_forms(sheared, clock, contacts);
    bench::print_machine(sheared, clock, contacts);
}
#endif
