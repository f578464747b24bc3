#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "dem/fast/neighbour_list.hpp"
#include "dem/fast/packing.hpp"
#include "dem/packing/csv.hpp"
#include "dem/rve.hpp"
#include "tests/support/table1_options.hpp"
#include "yade_reference.hpp"

namespace {
thread_local long allocations = 0;
}

[[gnu::noinline]] void* operator new(std::size_t bytes) {
    ++allocations;
    if (void* p = std::malloc(bytes)) return p;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(bytes);
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace sandgraph::dem {
namespace {

TEST(FastKernel, AStepAllocatesNothing) {
    const Packing packing = read_packing_csv(test::yade_file("packing_dense_p32.csv"));
    const KernelConstants law = kernel_constants(Material{});
    const Mat2 L = (Mat2() << 0, 0.4, 0, 0).finished();
    FastState s;
    load(packing, Material{}, s);
    NeighbourList neighbours;
    neighbours.relist(s, packing.contacts);
    const double* const arrays[] = {s.record.data(), s.force.data(), s.tangential.data(), s.moment.data()};
    const long before = allocations;
    ASSERT_GT(before, 0);  // the count works
    double sum[4];
    for (int step = 0; step < 50; ++step) {
        contact_forces(s, law, 1e-5, step % 2 ? sum : nullptr);
        s.approach += neighbours.approach(s, kick_drift(s, law, L, 1e-5), 1e-5);
        neighbours.stale(s);
    }
    EXPECT_EQ(allocations, before);
    const double* const now[] = {s.record.data(), s.force.data(), s.tangential.data(), s.moment.data()};
    for (int k = 0; k < 4; ++k) EXPECT_EQ(now[k], arrays[k]);  // they do not come from operator new
}

TEST(Rve, AnUpdateOfAPackingItOwnsAllocatesNothing) {
    const Packing packing = read_packing_csv(test::yade_file("packing_dense_p32.csv"));
    Rve rve(compact(packing, Material{}, 32e3 * Mat2::Identity()));
    Workspace work;
    const Mat2 F = (Mat2() << 1, 1e-5, 0, 1).finished();
    rve.update(F, Material{}, support::table1_options(), work);
    const long before = allocations;
    for (int k = 0; k < 3; ++k) rve.update(F, Material{}, support::table1_options(), work);
    EXPECT_EQ(allocations, before);
    EXPECT_LT(rve.packing().bytes(), 32'000u);
}

}  // namespace
}  // namespace sandgraph::dem
