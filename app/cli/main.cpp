#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <iostream>
#include <pthread.h>
#include <string_view>
#include <thread>
#include <unistd.h>

#include "app/cli/program.h"
#include "core/base/files/unfinished.h"

namespace {

using namespace std::chrono_literals;

constexpr unsigned kMostCleaningS = 5;

std::array<int, 2> g_stops{};  // a pipe: a signal handler may write into one
pthread_t g_main{};
std::atomic<bool> g_stands{false};  // the main thread

/// The main thread, which writes the files, stands still from here on; but not while it holds what the cleaning needs.
extern "C" void onStop(int number) {
  const int error = errno;
  const auto byte = static_cast<char>(number);
  [[maybe_unused]] const auto written = ::write(g_stops[1], &byte, 1);
  if (pthread_equal(pthread_self(), g_main) != 0 && !tactus::base::isExchanging()) {
    g_stands = true;
    for (;;) ::pause();
  }
  errno = error;
}

/// Ends the program after Ctrl-C or a request to end, without half-made files. Commands with a loop of their own have
/// their own way (InterruptSignals).
void watchStops() {
  char number = 0;
  ssize_t got = 0;
  while ((got = ::read(g_stops[0], &number, 1)) < 0 && errno == EINTR) {
  }
  if (got != 1) return;
  for (auto waited = 0ms; !g_stands && waited < 1s; waited += 1ms) {
    pthread_kill(g_main, number);
    std::this_thread::sleep_for(1ms);
  }
  ::alarm(kMostCleaningS);  // a disk that does not answer
  tactus::base::removeUnfinished();
  constexpr std::string_view kSaid = "\ntactus: stopped; nothing half-made is left\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kSaid.data(), kSaid.size());
  ::_exit(128 + number);
}

void catchStops() {
  if (::pipe2(g_stops.data(), O_CLOEXEC) != 0) return;
  g_main = pthread_self();
  std::thread(watchStops).detach();
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;  // as under nohup
    action = {};
    action.sa_handler = onStop;
    action.sa_flags = SA_RESTART;
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A limit on the size of files is then an error that is told, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  catchStops();
  return tactus::cli::run({argv + 1, argv + argc}, std::cout, std::cerr);
}
