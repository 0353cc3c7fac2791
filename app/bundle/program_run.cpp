#include "app/bundle/program_run.h"

#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace tactus::bundle {

Ran runProgram(std::vector<std::string> words, const std::string& folder, const std::stop_token& stop) {
  constexpr int kLongestMs = 60'000;  // a program that takes longer is not waited for
  constexpr int kStepMs = 5;
  constexpr int kNewFile = O_WRONLY | O_CREAT | O_TRUNC;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, (folder + "/in").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, (folder + "/out").c_str(), kNewFile, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, (folder + "/err").c_str(), kNewFile, 0600);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, arguments.front(), &files, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  if (!started) return Ran::kNotThere;
  int status = 0;
  for (int waited = 0; waitpid(child, &status, WNOHANG) == 0; waited += kStepMs) {
    if (waited >= kLongestMs || stop.stop_requested()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return Ran::kEnded;
    }
    poll(nullptr, 0, kStepMs);
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ran::kWell : Ran::kFailed;
}

}  // namespace tactus::bundle
