#include "packings/samples.hpp"

#include <map>
#include <numeric>

#include "base/contracts.hpp"
#include "base/random.hpp"

namespace sandgraph::packings {
namespace {

// Far from the streams that a packing itself draws from.
enum Stream : std::uint64_t { deal_stream = 1000, seed_stream = 1001 };

// The samples that a row has yet to deal before it starts anew.
class Deck {
  public:
    int draw(int samples, Random& random) {
        if (left_.empty()) shuffle(samples, random);
        const int top = left_.back();
        left_.pop_back();
        return top;
    }

  private:
    void shuffle(int samples, Random& random) {
        left_.resize(static_cast<std::size_t>(samples));
        std::iota(left_.begin(), left_.end(), 0);
        for (std::size_t k = left_.size(); k > 1; --k)
            std::swap(left_[k - 1], left_[static_cast<std::size_t>(random.uniform() * double(k))]);
    }
    std::vector<int> left_;
};

}  // namespace

std::uint64_t sample_seed(std::uint64_t seed, int sample) {
    SG_EXPECT(sample >= 0);
    if (sample == 0) return seed;
    // Positive as a signed number, which is what logs keep.
    return Random(seed, seed_stream + static_cast<std::uint64_t>(sample)).bits() >> 1;
}

scene::Grains sample_recipe(const scene::Grains& grains, int sample) {
    scene::Grains one = grains;
    one.seed = sample_seed(grains.seed, sample);
    one.samples = 1;
    return one;
}

std::vector<std::int32_t> deal(std::span<const std::int32_t> row, const scene::Grains& grains) {
    SG_EXPECT(grains.samples > 0);
    Random random(grains.seed, deal_stream);
    std::map<std::int32_t, Deck> decks;
    std::vector<std::int32_t> out;
    out.reserve(row.size());
    for (const std::int32_t r : row)
        out.push_back(r * grains.samples + decks[r].draw(grains.samples, random));
    return out;
}

}  // namespace sandgraph::packings
