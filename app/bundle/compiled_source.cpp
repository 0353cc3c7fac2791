#include "app/bundle/compiled_source.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/base/text.h"

extern char** environ;

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestMs = 60'000;  // a compiler that takes longer is not waited for
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

/// Reads points and writes their forces, all digits of them.
constexpr std::string_view kMain = R"(#include <stdio.h>
#include "force_model.h"
int main(void) {
  double inputs[FORCE_MODEL_INPUTS];
  for (;;) {
    int i, fired;
    for (i = 0; i < FORCE_MODEL_INPUTS; ++i) {
      if (scanf("%lf", &inputs[i]) != 1) return 0;
    }
    printf("%.17g\n", force_model(inputs, &fired));
  }
}
)";

/// Runs a program, found in PATH, with its input and output in files of `folder`. Returns whether it ended well.
bool run(std::vector<std::string> words, const std::string& folder, const std::stop_token& stop) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, (folder + "/in").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, (folder + "/out").c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, arguments.front(), &files, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  if (!started) return false;
  int status = 0;
  constexpr int kStepMs = 5;
  for (int waited = 0; waitpid(child, &status, WNOHANG) == 0; waited += kStepMs) {
    if (waited >= kLongestMs || stop.stop_requested()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return false;
    }
    poll(nullptr, 0, kStepMs);
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::optional<std::vector<double>> forcesOf(const exchange::CSource& source,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop) {
  std::error_code ignored;
  const base::Unfinished work =
      base::makeUnfinishedFolder((fs::temp_directory_path(ignored) / "tactus-c").string(), base::kUnfinishedEnding);
  if (!work.descriptor.isOpen()) return std::nullopt;
  struct Removed {
    const std::string& folder;
    ~Removed() {
      std::error_code unimportant;
      fs::remove_all(folder, unimportant);
    }
  } const removed{work.path};

  std::string input;
  for (const auto& point : points) {
    for (const double value : point) input += base::formatNumber(value) + ' ';
    input += '\n';
  }
  const auto write = [&](const std::string& name, std::string_view text) {
    return base::writeFileAtomically(work.path + "/" + name, text).has_value();
  };
  if (!write("force_model.h", source.header) || !write("force_model.c", source.source) || !write("main.c", kMain) ||
      !write("in", input))
    return std::nullopt;
  const std::string program = work.path + "/forces";
  if (!run({"cc", "-std=c99", "-O1", work.path + "/force_model.c", work.path + "/main.c", "-o", program, "-lm"},
           work.path, stop))
    return std::nullopt;
  if (!run({program}, work.path, stop)) return std::nullopt;
  const auto output = base::readFile(work.path + "/out", kMostBytes);
  if (!output) return std::nullopt;
  std::vector<double> forces;
  std::string_view rest = *output;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const auto force = base::parseNumber(rest.substr(0, end));
    if (!force) return std::nullopt;
    forces.push_back(*force);
    rest.remove_prefix(end + 1);
  }
  if (forces.size() != points.size()) return std::nullopt;
  return forces;
}

}  // namespace tactus::bundle
