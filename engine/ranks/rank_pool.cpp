#include "ranks/rank_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/contracts.hpp"
#include "base/hash.hpp"

namespace sandgraph::ranks {
namespace {

using graph::RveAnswer, graph::RveJob;

constexpr std::int64_t kBalanceEvery = 200;  // exchanges
constexpr std::size_t kShown = 512;          // packings that rank 0 takes in at once for a checkpoint

// In front of each rank's answers.
struct Heading {
    std::uint64_t step = 0;       // hash of the jobs: have all computed the same?
    std::uint64_t will_look = 0;  // of rank 0
};
constexpr std::size_t kHeading = sizeof(Heading);

template <class T>
void add(Hasher& hash, const T* values, std::size_t count) {
    hash.add(std::as_bytes(std::span(values, count)));
}

std::uint64_t hash_of(std::span<const RveJob> jobs) {
    Hasher hash;
    for (const RveJob& job : jobs) {
        add(hash, &job.rve, 1);
        if (job.increment) add(hash, job.increment->data(), 4);
    }
    return hash.value();
}

// In the form of the kernel, as the pool that drives them holds them: what is shown of one that has not been
// driven has the same bits on every rank.
graph::InitialPackings in_form_of(dem::RveKernel kernel, graph::InitialPackings initial) {
    std::map<const dem::CompactPacking*, std::shared_ptr<const dem::CompactPacking>> ready;
    for (auto& packing : initial) {
        auto& form = ready[packing.get()];
        if (!form) form = kernel == dem::RveKernel::mixed ? dem::in_mixed_form(packing) : packing;
        packing = form;
    }
    return initial;
}

std::uint64_t hash_of(const graph::InitialPackings& initial) {
    Hasher hash;
    const dem::CompactPacking* last = nullptr;
    for (const auto& packing : initial) {
        const std::int64_t content = packing.get() == last ? 0 : dem::content_hash(*packing);
        add(hash, &content, 1);
        last = packing.get();
    }
    return hash.value();
}

}  // namespace

RankPool::RankPool(Team& team, const graph::InitialPackings& initial, const dem::Material& material,
                   const dem::RveOptions& options)
    : team_(team),
      initial_(in_form_of(options.kernel, initial)),
      local_(graph::local_pool(initial, material, options)),
      caps_(options.steps_max > 0),
      owners_(initial.size(), team.size()),
      known_(initial.size()) {
    floating_.assign(initial.size(), 0);
    for (std::size_t k = 0; k < initial.size(); ++k) note(k);
    ByteWriter out(untouched_);
    if (!initial.empty()) local_->save_one(0, out);
    require_same_packings(initial);
}

// Packings are prepared by each rank: on another kind of machine they may come out with other bits.
void RankPool::require_same_packings(const graph::InitialPackings& initial) {
    const std::uint64_t own = hash_of(initial);
    std::vector<std::uint64_t> all(static_cast<std::size_t>(team_.size()));
    const std::vector<std::size_t> sizes(all.size(), sizeof own);
    team_.gather({reinterpret_cast<const std::uint8_t*>(&own), sizeof own}, sizes,
                 {reinterpret_cast<std::uint8_t*>(all.data()), all.size() * sizeof own});
    for (std::size_t r = 0; r < all.size(); ++r)
        if (all[r] != all[0])
            throw std::runtime_error(
                fmt::format("rank {} starts from other packings than rank 0: give all "
                            "ranks machines of one kind, and one packing cache",
                            r));
}

void RankPool::drive(std::span<const RveJob> jobs, std::span<RveAnswer> answers) {
    SG_EXPECT(jobs.size() == answers.size());
    if (jobs.empty()) {
        waits_ = true;  // nobody hears in this step whether rank 0 will look
        return;
    }
    if (waits_) meet();
    guests_.clear();
    try {
        drive_own(jobs);
    } catch (const std::exception& error) {
        team_.abandon(error.what());  // the others wait for these answers
    }
    exchange(jobs, answers);
    if (figures_.exchanges % kBalanceEvery == 0) balance();
}

void RankPool::meet() {
    ++figures_.waits;
    if (team_.rank() == 0) return tell(team_, {Order::Kind::go});
    for (;;) {
        const Order order = heard_ ? *heard_ : hear(team_);
        heard_.reset();
        if (order.kind == Order::Kind::go) return;
        if (order.kind == Order::Kind::stop) throw Dismissed();
        SG_EXPECT(order.kind == Order::Kind::show);
        show(order.first, order.last);
    }
}

bool RankPool::await() {
    heard_ = hear(team_);
    return heard_->kind != Order::Kind::stop;
}

void RankPool::serve() {
    meet();
    throw std::logic_error("rank 0 takes a step more");
}

// The order of the jobs is kept: the longest first.
void RankPool::drive_own(std::span<const RveJob> jobs) {
    own_.clear();
    for (const RveJob& job : jobs)
        if (mine(job.rve)) own_.push_back(job);
    own_answers_.resize(own_.size());
    local_->drive(own_, own_answers_);
    records_.clear();
    ByteWriter out(records_);
    const Heading heading{hash_of(jobs), will_look_};
    out.put(heading.step), out.put(heading.will_look);
    for (std::size_t k = 0; k < own_.size(); ++k)
        put_record(own_[k], own_answers_[k], known(*local_, own_[k].rve), caps_, out);
}

void RankPool::exchange(std::span<const RveJob> jobs, std::span<RveAnswer> answers) {
    sizes_.assign(static_cast<std::size_t>(team_.size()), kHeading);
    for (const RveJob& job : jobs)
        sizes_[static_cast<std::size_t>(owners_.of(job.rve))] += record_bytes(job, caps_);
    std::size_t sum = 0;
    for (const std::size_t size : sizes_) sum += size;
    all_.resize(sum);
    SG_EXPECT(records_.size() == sizes_[static_cast<std::size_t>(team_.rank())]);
    team_.gather(records_, sizes_, all_);
    ++figures_.exchanges, figures_.bytes += static_cast<std::int64_t>(sum);
    take_all(jobs, answers);
    count(jobs, answers);
}

void RankPool::take_all(std::span<const RveJob> jobs, std::span<RveAnswer> answers) {
    std::vector<ByteReader> messages = open_messages();
    for (std::size_t slot = 0; slot < jobs.size(); ++slot) {
        const std::size_t k = jobs[slot].rve;
        take_record(jobs[slot], caps_, messages[static_cast<std::size_t>(owners_.of(k))], answers[slot],
                    known_[k]);
        floating_[k] = known_[k].floating;
    }
}

// Behind their headings. All ranks throw the same.
std::vector<ByteReader> RankPool::open_messages() {
    std::vector<ByteReader> out;
    Heading first;
    std::size_t begin = 0;
    for (std::size_t r = 0; r < sizes_.size(); begin += sizes_[r++]) {
        out.emplace_back(ByteSpan(all_).subspan(begin, sizes_[r]));
        Heading heading;
        out.back().take(heading.step), out.back().take(heading.will_look);
        if (r == 0) first = heading;
        if (heading.step != first.step)
            throw std::runtime_error(
                fmt::format("rank {} has come to another ground than rank 0: give all "
                            "ranks machines of one kind",
                            r));
    }
    waits_ = first.will_look != 0;
    return out;
}

void RankPool::count(std::span<const RveJob> jobs, std::span<const RveAnswer> answers) {
    std::vector<std::int64_t> steps(sizes_.size(), 0);
    for (std::size_t slot = 0; slot < jobs.size(); ++slot) {
        owners_.measure(jobs[slot].rve, answers[slot].report.dem_steps);
        steps[static_cast<std::size_t>(owners_.of(jobs[slot].rve))] += answers[slot].report.dem_steps;
    }
    for (const std::int64_t of_rank : steps) figures_.dem_steps += of_rank;
    figures_.slowest += *std::ranges::max_element(steps);
}

// Every rank goes through the same list of moves in its order, so that no two wait for each other.
void RankPool::balance() {
    const std::vector<Owners::Move> moves = owners_.balance();
    for (const Owners::Move& one : moves) move(one);
    figures_.moved += std::ssize(moves);
}

void RankPool::move(const Owners::Move& one) {
    if (one.from == team_.rank()) {
        Bytes state;
        ByteWriter out(state);
        local_->save_one(one.packing, out);
        team_.send(one.to, state);
        release(one.packing);
    }
    if (one.to == team_.rank()) {
        const Bytes state = team_.receive(one.from);
        ByteReader in(state);
        local_->load_one(one.packing, in);
    }
}

// Frees what another rank keeps from now on.
void RankPool::release(std::size_t rve) {
    ByteReader in(untouched_);
    local_->load_one(rve, in);
}

void RankPool::note(std::size_t rve) {
    known_[rve] = known(*local_, rve);
    floating_[rve] = known_[rve].floating;
}

void RankPool::copy(std::size_t from, std::size_t to) {
    const int home = owners_.of(from);
    if (mine(to) && !mine(from)) release(to);
    owners_.move(to, home);
    if (mine(from)) local_->copy(from, to);
    known_[to] = known_[from], floating_[to] = floating_[from];
    guests_.erase(to);
}

std::size_t RankPool::owning() const {
    return static_cast<std::size_t>(std::ranges::count_if(known_, &KnownPacking::owning));
}

const dem::Rve& RankPool::rve(std::size_t rve) const {
    return mine(rve) || team_.rank() != 0 ? local_->rve(rve) : fetch(rve);
}

const dem::Rve& RankPool::fetch(std::size_t rve) const {
    const std::lock_guard lock(fetching_);
    auto& guest = guests_[rve];
    if (guest) return *guest;
    const Bytes state = ask_to_show(rve, rve + 1)[static_cast<std::size_t>(owners_.of(rve))];
    ByteReader in(state);
    guest = std::make_unique<dem::Rve>(initial_[rve]);
    guest->load(in);
    return *guest;
}

// What the ranks that own some of [first, last) send, by rank.
std::vector<Bytes> RankPool::ask_to_show(std::size_t first, std::size_t last) const {
    SG_EXPECT(team_.rank() == 0);
    if (!waits_) throw std::logic_error("the ranks were told that nobody would look at packings");
    tell(team_, {Order::Kind::show, first, last});
    std::vector<Bytes> out(static_cast<std::size_t>(team_.size()));
    std::vector<std::uint8_t> asked(out.size(), 0);
    asked[0] = 1;
    for (std::size_t k = first; k < last; ++k) {
        const auto owner = static_cast<std::size_t>(owners_.of(k));
        if (!std::exchange(asked[owner], std::uint8_t{1}))
            out[owner] = team_.receive(static_cast<int>(owner));
    }
    return out;
}

void RankPool::show(std::size_t first, std::size_t last) {
    Bytes states;
    ByteWriter out(states);
    for (std::size_t k = first; k < last; ++k)
        if (mine(k)) local_->save_one(k, out);
    if (!states.empty()) team_.send(0, states);
}

void RankPool::save(ByteWriter& out) const {
    for (std::size_t first = 0; first < size(); first += kShown) {
        const std::size_t last = std::min(first + kShown, size());
        const std::vector<Bytes> states = ask_to_show(first, last);
        std::vector<ByteReader> in(states.begin(), states.end());
        for (std::size_t k = first; k < last; ++k) {
            if (mine(k)) {
                local_->save_one(k, out);
                continue;
            }
            dem::Rve shown(initial_[k]);
            shown.load(in[static_cast<std::size_t>(owners_.of(k))]);
            shown.save(out);
        }
    }
}

void RankPool::load(ByteReader& in) {
    for (std::size_t k = 0; k < size(); ++k) load_one(k, in);
    guests_.clear();
}

void RankPool::save_one(std::size_t rve, ByteWriter& out) const { this->rve(rve).save(out); }

void RankPool::load_one(std::size_t rve, ByteReader& in) {
    local_->load_one(rve, in);
    note(rve);
    if (!mine(rve)) release(rve);
}

}  // namespace sandgraph::ranks
