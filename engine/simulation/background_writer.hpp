#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace sandgraph::simulation {

// Runs jobs one after the other on a thread of its own, off the critical path. The queue is bounded: a
// producer that is ahead waits. What a job throws comes out of the next call.
class BackgroundWriter {
  public:
    explicit BackgroundWriter(std::size_t capacity = 4);
    ~BackgroundWriter();
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    void post(std::function<void()> job);
    void drain();  // returns when everything posted is done

  private:
    void work();
    void rethrow();
    std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    bool busy_ = false, stop_ = false;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace sandgraph::simulation
