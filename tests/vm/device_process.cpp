#include "tests/vm/device_process.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

namespace tactus::vm {

DeviceProcess::DeviceProcess(const std::string& program, const std::string& descriptor) {
  std::array<int, 2> commands{};
  std::array<int, 2> answers{};
  if (pipe(commands.data()) != 0 || pipe(answers.data()) != 0) std::abort();
  child_ = fork();
  if (child_ == 0) {
    dup2(commands[0], STDIN_FILENO);
    dup2(answers[1], STDOUT_FILENO);
    for (int fd : {commands[0], commands[1], answers[0], answers[1]}) close(fd);
    execl(program.c_str(), program.c_str(), descriptor.c_str(), nullptr);
    _exit(127);
  }
  close(commands[0]);
  close(answers[1]);
  to_ = fdopen(commands[1], "w");
  from_ = fdopen(answers[0], "r");
  tell("hello");
}

DeviceProcess::~DeviceProcess() {
  std::fclose(to_);
  std::fclose(from_);
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

std::vector<std::string> DeviceProcess::tell(const std::string& command) {
  std::fprintf(to_, "%s\n", command.c_str());
  std::fflush(to_);
  std::vector<std::string> lines;
  std::array<char, 256> room{};
  while (std::fgets(room.data(), room.size(), from_) != nullptr) {
    std::string line = room.data();
    while (!line.empty() && line.back() == '\n') line.pop_back();
    if (line == "done") return lines;
    lines.push_back(std::move(line));
  }
  std::printf("the device program ended at `%s`\n", command.c_str());
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
  std::exit(2);
}

FeltForce DeviceProcess::force() {
  const std::string line = tell("force").at(0);
  FeltForce force;
  char* rest = nullptr;
  force.x = std::strtod(line.c_str(), &rest);
  force.y = std::strtod(rest, nullptr);
  return force;
}

std::vector<FeltForce> DeviceProcess::felt() {
  std::vector<FeltForce> forces;
  for (const std::string& line : tell("felt")) {
    FeltForce force;
    char* rest = nullptr;
    force.time_ns = std::strtoll(line.c_str(), &rest, 10);
    force.x = std::strtod(rest, &rest);
    force.y = std::strtod(rest, nullptr);
    forces.push_back(force);
  }
  return forces;
}

double DeviceProcess::number(const std::string& command) {
  const std::vector<std::string> lines = tell(command);
  return lines.empty() ? -1 : std::strtod(lines.front().c_str(), nullptr);
}

}  // namespace tactus::vm
