// Hands the newest scenes from a thread that may take its time to a 1 kHz loop that may not wait.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <tactus/tactus.hpp>
#include <utility>
#include <vector>

// One model under the conditions of this simulator. Never changed once it is in a box.
struct Scenes {
  Scenes(unsigned long long model_serial, double offset_mm, tactus::Scene at_rest, tactus::Scene while_swallowing)
      : serial(model_serial),
        depth_offset_mm(offset_mm),
        rest(std::move(at_rest)),
        swallowing(std::move(while_swallowing)) {}

  unsigned long long serial;  // of the live link; 0: the model of the bundle
  double depth_offset_mm;     // depth of the model where that of the tube is 0
  tactus::Scene rest;
  tactus::Scene swallowing;       // as `rest` where the model has no input `swallow`
  unsigned long long number = 0;  // set by the box
};

// One thread puts, the loop takes. The putting thread frees old scenes once the loop has taken newer ones, so the loop
// never frees memory, and tactus_tube_scene is real-time safe.
class SceneBox {
 public:
  // Thread: the one that puts.
  void put(std::unique_ptr<Scenes> scenes) {
    scenes->number = ++count_;
    const unsigned long long taken = taken_.load(std::memory_order_acquire);
    held_.push_back(std::move(scenes));
    const Scenes* const untaken = slot_.exchange(held_.back().get(), std::memory_order_acq_rel);
    held_.erase(std::remove_if(held_.begin(), held_.end(),
                               [&](const auto& one) { return one.get() == untaken || one->number < taken; }),
                held_.end());
    const std::lock_guard<std::mutex> lock(mutex_);
    first_.notify_all();
  }

  // Whether there was something to take in time. Before the loop begins. Thread: that of the loop.
  bool waitForFirst(std::chrono::seconds patience) {
    std::unique_lock<std::mutex> lock(mutex_);
    return first_.wait_for(lock, patience, [this] { return slot_.load(std::memory_order_relaxed) != nullptr; });
  }

  // Scenes that the loop has not seen yet, or null. They stay valid until a call has given others, and the loop has
  // called `used` for those. Thread: the loop. Real-time safe: yes.
  const Scenes* take() { return slot_.exchange(nullptr, std::memory_order_acquire); }
  // The loop no longer uses scenes before these. Thread: the loop. Real-time safe: yes.
  void used(const Scenes& scenes) { taken_.store(scenes.number, std::memory_order_release); }

 private:
  std::vector<std::unique_ptr<Scenes>> held_;  // touched by the putting thread alone
  unsigned long long count_ = 0;               // likewise
  std::atomic<const Scenes*> slot_{nullptr};
  std::atomic<unsigned long long> taken_{0};
  std::mutex mutex_;  // for waiting alone
  std::condition_variable first_;
};
