#pragma once
#include <barrier>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "ranks/team.hpp"

namespace sandgraph::support {

// Ranks that are threads of one process, so that what they do together is tested without MPI.
class ThreadRanks {
  public:
    explicit ThreadRanks(int size) : size_(size), all_(size) {}

    // `work(team)` on every rank at once; throws what rank 0 threw.
    void run(const std::function<void(ranks::Team&)>& work) {
        std::exception_ptr failure;
        std::vector<std::jthread> threads;
        for (int rank = 1; rank < size_; ++rank)
            threads.emplace_back([this, rank, &work] {
                Member team(*this, rank);
                work(team);
            });
        Member team(*this, 0);
        try {
            work(team);
        } catch (...) {
            failure = std::current_exception();
        }
        threads.clear();
        if (failure) std::rethrow_exception(failure);
    }

  private:
    class Member final : public ranks::Team {
      public:
        Member(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}
        int rank() const override { return rank_; }
        int size() const override { return all_.size_; }
        int here() const override { return all_.size_; }
        void gather(ranks::ByteSpan mine, std::span<const std::size_t> sizes,
                    std::span<std::uint8_t> out) override {
            all_.give(rank_, mine);
            std::size_t begin = 0;
            for (std::size_t r = 0; r < sizes.size(); begin += sizes[r++])
                std::memcpy(out.data() + begin, all_.given_[r].data(), sizes[r]);
            all_.all_.arrive_and_wait();
        }
        void broadcast(std::span<std::uint8_t> word) override {
            all_.give(rank_, word);
            std::memcpy(word.data(), all_.given_[0].data(), word.size());
            all_.all_.arrive_and_wait();
        }
        void send(int to, ranks::ByteSpan message) override { all_.send(rank_, to, message); }
        ranks::Bytes receive(int from) override { return all_.receive(from, rank_); }
        void abandon(const std::string& why) override { throw std::runtime_error(why); }

      private:
        ThreadRanks& all_;
        int rank_;
    };

    void give(int rank, ranks::ByteSpan bytes) {
        given_[static_cast<std::size_t>(rank)].assign(bytes.begin(), bytes.end());
        all_.arrive_and_wait();
    }
    void send(int from, int to, ranks::ByteSpan message) {
        const std::lock_guard lock(mutex_);
        mail_[{from, to}].emplace_back(message.begin(), message.end());
        changed_.notify_all();
    }
    ranks::Bytes receive(int from, int to) {
        std::unique_lock lock(mutex_);
        auto& box = mail_[{from, to}];
        changed_.wait(lock, [&] { return !box.empty(); });
        ranks::Bytes out = std::move(box.front());
        box.pop_front();
        return out;
    }

    int size_;
    std::barrier<> all_;
    std::vector<ranks::Bytes> given_ = std::vector<ranks::Bytes>(static_cast<std::size_t>(size_));
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::pair<int, int>, std::deque<ranks::Bytes>> mail_;
};

}  // namespace sandgraph::support
