#include <memory>
#include <ostream>
#include <poll.h>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/interrupt_signals.h"
#include "app/cli/opened_model.h"
#include "app/cli/watched_file.h"
#include "app/link/link_server.h"
#include "app/link/token_file.h"
#include "app/version.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

using base::Result;

/// Between two looks at the file and at the signals: a changed file is served within 50 ms.
constexpr int kLookMs = 20;

struct ReadFile {
  std::string text;
  link::LinkModel model;
  std::vector<std::string> warnings;
};

Result<ReadFile> modelOf(std::string text, const std::string& path) {
  auto opened = openedModel(text, path);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  auto shared = std::make_shared<const std::string>(text);
  return ReadFile{
      std::move(text), {std::move(opened->compiled), [shared] { return *shared; }}, std::move(opened->warnings)};
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
  auto text = textOf(options.model);
  if (!text) return tl::unexpected(text.error());
  auto read = modelOf(std::move(*text), options.model);
  if (!read) return tl::unexpected(read.error());
  const InterruptSignals signals;
  auto token =
      options.token_file.empty() ? link::TokenFile::inPrivateFolder() : link::TokenFile::at(options.token_file);
  if (!token) return tl::unexpected(token.error());
  auto server = link::LinkServer::start({options.port, options.socket, token->token(), std::string(kGenerator)},
                                        std::move(read->model));
  if (!server) return tl::unexpected(server.error());
  warn(err, read->warnings);
  out << "{\"listening\":{\"port\":" << (*server)->port()
      << ",\"socket\":" << (options.socket.empty() ? "null" : base::jsonString(options.socket))
      << "},\"token_file\":" << base::jsonString(token->path()) << "}\n"
      << std::flush;
  if (!out.good()) return Output{};  // the caller says so

  Watch watch(options.model, std::move(read->text), **server, err);
  while (!signals.raised()) {
    ::poll(nullptr, 0, options.watch ? kLookMs : 5 * kLookMs);
    if (options.watch) watch.look();
  }
  return Output{};
}

}  // namespace tactus::cli
