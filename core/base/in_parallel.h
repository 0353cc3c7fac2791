// The same work for many numbers, on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tactus::base {

/// How many threads compute what the user waits for: one fewer than there are processors, which leaves one for the
/// window, but at least two.
inline unsigned spareThreads() { return std::max(3U, std::thread::hardware_concurrency()) - 1; }

/// Runs `work` for 0 to count - 1 on `threads` threads, on the caller's alone if that is 1. The caller's thread asks
/// `go_on`, unless empty, with the share that is done, [0, 1], whenever more is, on several threads now and then too.
/// False: canceled, some are not done.
inline bool inParallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work,
                       const std::function<bool(double share)>& go_on = {}) {
  const auto goes_on = [&](std::size_t done) {
    return !go_on || go_on(static_cast<double>(done) / static_cast<double>(count));
  };
  if (threads <= 1 || count <= 1) {
    for (std::size_t one = 0; one < count; ++one) {
      work(one);
      if (!goes_on(one + 1)) return one + 1 == count;
    }
    return true;
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::size_t done = 0;
  std::mutex mutex;  // of done
  std::condition_variable more;
  std::vector<std::thread> team;
  for (std::size_t i = 0; i < std::min<std::size_t>(threads, count); ++i) {
    team.emplace_back([&] {
      for (std::size_t one = next++; one < count && !stop; one = next++) {
        work(one);
        const std::lock_guard lock(mutex);
        ++done;
        more.notify_one();
      }
    });
  }
  for (std::size_t told = 0; told < count && !stop;) {
    std::unique_lock lock(mutex);
    more.wait_for(lock, std::chrono::milliseconds(50), [&] { return done > told; });
    told = done;
    lock.unlock();
    if (!goes_on(told) && told < count) stop = true;
  }
  for (std::thread& one : team) one.join();
  return !stop;
}

}  // namespace tactus::base
