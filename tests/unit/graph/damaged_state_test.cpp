#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/memory_archive.hpp"
#include "tests/unit/graph/screening_bench.hpp"

// What an archive brings is a state of the law or it is refused; nothing is read that could index outside.
namespace sandgraph::graph {
namespace {

// A law's archive of its points, as bytes at hand; that of its initial packings is taken as it comes.
class Bytes final : public Archive {
  public:
    explicit Bytes(std::vector<std::uint8_t>* from = nullptr) : from_(from) {}
    bool reading() const override { return from_ != nullptr; }
    void field(std::string_view, std::vector<double>&) override { FAIL(); }
    void field(std::string_view, std::vector<std::int64_t>&) override {}
    void field(std::string_view, std::vector<std::uint8_t>& values) override {
        reading() ? values = *from_ : written = values;
    }
    std::vector<std::uint8_t> written;

  private:
    std::vector<std::uint8_t>* from_;
};

std::vector<std::uint8_t> saved(stress::Law& law) {
    Bytes out;
    law.archive(out);
    return out.written;
}

void load(stress::Law& law, std::vector<std::uint8_t> bytes) {
    Bytes in(&bytes);
    law.archive(in);
}

// Points of every mode, and audits.
Bench<ScreeningLaw> sheared() {
    ScreeningSetup setup = setup_of(3, 2e-3);
    setup.audit.share = 0.5, setup.audit.load_points = 2;
    auto bench = screening(3, setup);
    shear(bench, 520);
    return bench;
}

// Tries `values` in place of each byte asked for; returns how often the state was refused.
template <class Law>
int refused(Law& law, const std::vector<std::uint8_t>& whole, std::size_t stride) {
    int count = 0;
    for (std::size_t at = 0; at < whole.size(); at += stride)
        for (const int value : {0xff, 0x7f, whole[at] ^ 1}) {
            std::vector<std::uint8_t> bytes = whole;
            bytes[at] = static_cast<std::uint8_t>(value);
            try {
                load(law, bytes);
                EXPECT_EQ(saved(law), bytes) << "byte " << at;
            } catch (const StateError&) {
                ++count;
            }
        }
    return count;
}

TEST(DamagedState, OfAScreeningLawIsRefusedOrWrittenBackAsItWasRead) {
    auto bench = sheared();
    ASSERT_GT(bench.law.modes().grain_points(), 0u);
    const auto whole = saved(bench.law);
    EXPECT_GT(refused(bench.law, whole, 211), 10);
    load(bench.law, whole);
    EXPECT_EQ(saved(bench.law), whole);
}

TEST(DamagedState, OfPackingsIsRefusedOrWrittenBackAsItWasRead) {
    auto bench = full(3);
    shear(bench, 100);
    const auto whole = saved(bench.law);
    EXPECT_GT(refused(bench.law, whole, 211), 10);
}

TEST(DamagedState, OfOtherPointsIsRefused) {
    auto three = full(3), two = full(2);
    EXPECT_THROW(load(two.law, saved(three.law)), StateError);
    EXPECT_THROW(load(three.law, saved(two.law)), StateError);
    auto more = sheared(), fewer = screening(2, setup_of(2, 2e-3));
    EXPECT_THROW(load(fewer.law, saved(more.law)), StateError);
    EXPECT_THROW(load(more.law, saved(fewer.law)), StateError);
}

// The scene's hash knows the recipe of the initial packings, not what a machine makes of it.
TEST(DamagedState, OfOtherInitialPackingsIsRefused) {
    auto here = full(2);
    RveLawSetup elsewhere = setup_of(2, 0).grains;
    auto rounded = std::make_shared<dem::CompactPacking>(*elsewhere.packings.front().packing);
    rounded->position[7] = std::nextafter(rounded->position[7], 1);
    elsewhere.packings.front().packing = rounded;
    support::MemoryArchive memory;
    here.law.archive(memory);
    memory.read_from_now_on();
    RveLaw law(elsewhere), same(setup_of(2, 0).grains);
    EXPECT_NO_THROW(same.archive(memory));
    EXPECT_THROW(law.archive(memory), StateError);
}

TEST(DamagedState, CutShortOrWithMoreBehindItIsRefused) {
    auto bench = sheared();
    const auto whole = saved(bench.law);
    for (std::size_t size = 0; size < whole.size(); size += 977)
        EXPECT_THROW(load(bench.law, {whole.begin(), whole.begin() + static_cast<long>(size)}), StateError);
    auto longer = whole;
    longer.push_back(0);
    EXPECT_THROW(load(bench.law, longer), StateError);
}

}  // namespace
}  // namespace sandgraph::graph
