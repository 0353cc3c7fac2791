#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <poll.h>
#include <string>
#include <sys/stat.h>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "app/link/link_server.h"
#include "app/link/link_sockets.h"
#include "app/version.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

/// Tells when a file has changed, by looking at it again and again: that works on every file system, and for editors
/// that replace a file as well as for those that write into it.
class WatchedFile {
 public:
  using Clock = std::chrono::steady_clock;
  /// A file that did not change for this long is whole.
  static constexpr auto kQuiet = std::chrono::milliseconds(100);

  enum class Change {
    kNone,
    kNew,      ///< it has just changed: it may be half written
    kSettled,  ///< it changed a while ago, and not since
  };

  /// The first look says that the file is new.
  explicit WatchedFile(std::string path);

  /// What has happened since the last call. `now`: not before the last one.
  Change look(Clock::time_point now);

 private:
  std::string path_;
  struct stat seen_ {};  ///< all zero: no file
  std::optional<Clock::time_point> changed_at_;
};

struct stat lookAt(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return {};
  return info;
}

bool sameTime(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

bool sameFile(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size && sameTime(a.st_mtim, b.st_mtim) &&
         sameTime(a.st_ctim, b.st_ctim);
}

WatchedFile::WatchedFile(std::string path) : path_(std::move(path)) {}

WatchedFile::Change WatchedFile::look(Clock::time_point now) {
  const struct stat info = lookAt(path_);
  if (!sameFile(info, seen_)) {
    seen_ = info;
    changed_at_ = now;
    return Change::kNew;
  }
  // A write within one tick of the system's clock leaves no trace in the times, so the file is read once more.
  if (!changed_at_ || now - *changed_at_ < kQuiet) return Change::kNone;
  changed_at_.reset();
  return Change::kSettled;
}

using base::Result;

/// Between two looks at the file and at the signals: a changed file is served within 50 ms.
constexpr int kLookMs = 20;

struct ReadFile {
  std::string text;
  link::LinkModel model;
  std::vector<std::string> warnings;
};

Result<ReadFile> modelOf(std::string text, const std::string& path) {
  TACTUS_TRY(auto opened, openedModel(text, path));
  auto shared = std::make_shared<const std::string>(text);
  return ReadFile{std::move(text),
                  {std::move(opened.compiled), [shared] { return *shared; }, link::inputIds(opened.model)},
                  std::move(opened.warnings)};
}

Result<std::string> textOf(const std::string& path) { return base::readFile(path, model_io::kMostModelFileBytes); }

void warn(std::ostream& err, const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) err << "tactus: warning: " << base::oneLine(warning) << '\n';
  err << std::flush;
}

/// Serves each change of the file that is a model; keeps the last one otherwise.
class Watch {
 public:
  Watch(std::string path, std::string text, link::LinkServer& server, std::ostream& err)
      : file_(path), path_(std::move(path)), served_(std::move(text)), server_(server), err_(err) {}

  void look() {
    const auto change = file_.look(WatchedFile::Clock::now());
    if (change == WatchedFile::Change::kNone) return;
    auto text = textOf(path_);
    if (text && *text == served_) return said_.clear();
    auto read = text ? modelOf(std::move(*text), path_) : tl::unexpected(text.error());
    if (read) {
      warn(err_, read->warnings);
      served_ = std::move(read->text);
      said_.clear();
      server_.publish(std::move(read->model));
    } else if (change == WatchedFile::Change::kSettled && read.error().message() != said_) {
      said_ = read.error().message();
      err_ << "tactus: the last good model is served on: " << said_ << '\n' << std::flush;
    }
  }

 private:
  WatchedFile file_;
  std::string path_;
  std::string served_;
  std::string said_;
  link::LinkServer& server_;
  std::ostream& err_;
};

}  // namespace

Result<Output> serve(const ServeOptions& options, std::ostream& out, std::ostream& err) {
  TACTUS_TRY(auto text, textOf(options.model));
  TACTUS_TRY(auto read, modelOf(std::move(text), options.model));
  const InterruptSignals signals;
  TACTUS_TRY(auto token,
             options.token_file.empty() ? link::TokenFile::inPrivateFolder() : link::TokenFile::at(options.token_file));
  TACTUS_TRY(auto server,
             link::LinkServer::start({options.port, options.socket, token.token(), std::string(kGenerator)},
                                     std::move(read.model)));
  warn(err, read.warnings);
  out << "{\"listening\":{\"port\":" << (server)->port()
      << ",\"socket\":" << (options.socket.empty() ? "null" : base::jsonString(options.socket))
      << "},\"token_file\":" << base::jsonString(token.path()) << "}\n"
      << std::flush;
  if (!out.good()) return Output{};  // the caller says so

  Watch watch(options.model, std::move(read.text), *server, err);
  while (!signals.raised()) {
    ::poll(nullptr, 0, options.watch ? kLookMs : 5 * kLookMs);
    if (options.watch) watch.look();
  }
  return Output{};
}

}  // namespace tactus::cli
