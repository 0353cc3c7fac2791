// Exchanges lines of text with a program of somebody else, which this program starts or reaches by a socket.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/unfinished.h"
#include "core/base/json/json_writer.h"

namespace tactus::certify {

/// How to reach the program.
struct Target {
  /// `tcp:HOST:PORT` or `unix:PATH`: connects. `node:FILE.js`: a module that exports `forceModel(inputs)`, in Node.
  /// A name that ends with `.so`, `.dll` or `.dylib`: a shared library with `double force_model(const double *, int
  /// *)`. Anything else: a program, started without a shell, found in PATH where it has no slash.
  std::string name;
  std::vector<std::string> arguments;  ///< of a program that is started
};

/// One sentence where `name` cannot be a target; empty where it can.
std::string targetMistake(const std::string& name);

/// How long it may take.
struct Patience {
  std::chrono::milliseconds answer{2000};
  std::function<bool()> is_stopped = [] { return false; };  ///< the user wants an end
};

/// Sends and receives lines. No answer in time is the error kData, after which it may be asked again; kCancelled is the
/// user's wish; any other error is the end: the program is gone, or sends a line of more than 1 MiB. What it writes to
/// its standard error is read and dropped but for the last line. The destructor ends a program that was started, and
/// what it started.
class ForeignProgram {
 public:
  static base::Result<ForeignProgram> open(const Target& target, Patience patience);
  ~ForeignProgram();
  ForeignProgram(ForeignProgram&& other) noexcept;
  ForeignProgram& operator=(ForeignProgram&&) = delete;

  /// `line`: without its end.
  base::Result<void> send(std::string_view line);
  /// The next line, at most `patience` away; by default that of an answer.
  base::Result<std::string> receive(std::optional<std::chrono::milliseconds> patience = {});

 private:
  explicit ForeignProgram(Patience patience) : patience_(std::move(patience)) {}

  base::Result<void> start(const std::function<void()>& body, const std::string& name);
  base::Result<void> connectTo(const Target& target);
  base::Result<void> wait(short events, std::chrono::steady_clock::time_point start,
                          std::chrono::milliseconds patience);
  void takeErrors();
  std::string ending() const;
  std::string lastWords() const;

  Patience patience_;
  base::Descriptor to_;
  base::Descriptor from_;
  base::Descriptor errors_;
  pid_t child_ = 0;
  base::Unfinished folder_;  ///< of a script that speaks for a module
  std::string waiting_;      ///< received, not yet returned
  std::string said_;         ///< the end of what it wrote to its standard error
};

/// Begins a line of the protocol: an object with this key. Its value and the object's end follow.
base::JsonWriter lineOf(std::string_view key);

// What speaks for a thing that is no program.

/// Answers the questions on `in` with the functions of the shared library `path`, on `out`, until `in` ends.
void answerWithLibrary(const std::string& path, int in, int out);

/// The script for Node that answers for the module named by its first argument.
std::string_view nodeScript();

}  // namespace tactus::certify
