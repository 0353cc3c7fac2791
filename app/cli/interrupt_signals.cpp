#include "app/cli/interrupt_signals.h"

#include <atomic>

namespace tactus::cli {
namespace {

// A signal handler gets no argument of ours, so its flag has to be global.
std::atomic<bool> g_raised{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void onSignal(int number) {
  if (!g_raised.exchange(true)) return;
  // Takes effect when this handler returns: until then the signal is blocked.
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

InterruptSignals::InterruptSignals() {
  g_raised = false;
  struct sigaction action {};
  action.sa_handler = onSignal;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
}

InterruptSignals::~InterruptSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

bool InterruptSignals::raised() const noexcept { return g_raised.load(); }

}  // namespace tactus::cli
