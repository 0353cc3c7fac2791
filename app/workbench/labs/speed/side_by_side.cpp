#include "app/workbench/labs/speed/side_by_side.h"

#include <atomic>
#include <thread>

namespace tactus::workbench {

bool sideBySide(std::size_t count, const std::function<void(std::size_t)>& work,
                const std::function<bool(double share)>& keep_going) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stopped = !keep_going(0);
  std::jthread other;
  if (std::thread::hardware_concurrency() > 1 && count > 1 && !stopped) {
    other = std::jthread([&] {
      for (std::size_t i = next++; i < count && !stopped; i = next++) work(i);
    });
  }
  for (std::size_t i = next++; i < count && !stopped; i = next++) {
    work(i);
    if (!keep_going(static_cast<double>(i + 1) / static_cast<double>(count))) stopped = true;
  }
  if (other.joinable()) other.join();
  return !stopped && keep_going(1);
}

}  // namespace tactus::workbench
