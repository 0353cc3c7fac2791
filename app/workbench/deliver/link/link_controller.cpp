#include "app/workbench/deliver/link/link_controller.h"

#include <algorithm>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/model_controller.h"
#include "core/base/error.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
namespace {

/// The text is that which saving would write: with checks of the model as it is now.
link::LinkModel linkModel(editing::SharedModel model) {
  auto text = [model] { return model_io::formatModel(editing::withFreshChecks(model)->model); };
  return {model->compiled, std::move(text), link::inputIds(model->model)};
}

constexpr std::chrono::milliseconds kFrame{16};
constexpr std::chrono::milliseconds kWatch{100};
/// A simulator that says nothing for so long is no longer shown.
constexpr std::chrono::seconds kSilence{1};

}  // namespace

LinkController::LinkController(const ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  connect(&models_, &ModelController::opened, this, &LinkController::publish);
  connect(&models_, &ModelController::edited, this, &LinkController::publish);
  connect(&models_, &ModelController::shownChanged, this, &LinkController::publish);
  frame_.setSingleShot(true);
  frame_.setInterval(kFrame);
  watch_.setInterval(kWatch);
  connect(&frame_, &QTimer::timeout, this, &LinkController::hear);
  connect(&watch_, &QTimer::timeout, this, &LinkController::forget);
}

LinkController::~LinkController() = default;

QString LinkController::address() const {
  return server_ ? QStringLiteral("127.0.0.1:%1").arg(server_->port()) : QString();
}

QString LinkController::tokenFile() const { return server_ ? text(token_->path()) : QString(); }

void LinkController::start() {
  if (server_) return;
  if (!models_.shown()) {
    emit failed(tr("No model is open; open one to serve it."));
    return;
  }
  auto served = serve(chosen_port_ != 0 ? chosen_port_ : port_);
  if (!served && chosen_port_ == 0 && port_ != 0) served = serve(0);
  if (!served) {
    token_.reset();
    emit failed(text(served.error().message()));
    return;
  }
  port_ = server_->port();
  emit changed();
}

base::Result<void> LinkController::serve(std::uint16_t port) {
  if (!token_) {
    TACTUS_TRY(auto token, link::TokenFile::inPrivateFolder());
    token_.emplace(std::move(token));
  }
  link::LinkSettings settings;
  settings.port = port;
  settings.token = token_->token();
  settings.program = std::string(kGenerator);
  auto started = link::LinkServer::start(
      std::move(settings), linkModel(models_.shown()->shared), [this] { calls_.post([this] { showClients(); }); },
      [this] { calls_.post([this] { listen(); }); });
  if (!started) return tl::unexpected(started.error());
  server_ = std::move(*started);
  return {};
}

void LinkController::stop() {
  if (!server_) return;
  server_.reset();
  token_.reset();
  clients_.clear();
  all_left_at_.reset();
  forget();
  emit changed();
}

void LinkController::publish() {
  if (server_) server_->publish(linkModel(models_.shown()->shared));
}

void LinkController::tell(link::LinkStates states) {
  if (server_) server_->publish(std::move(states));
}

void LinkController::showClients() {
  if (!server_) return;  // said before it ended
  const bool had_any = !clients_.empty();
  clients_ = server_->clients();
  const bool all_left = had_any && clients_.empty();
  if (all_left) all_left_at_ = QDateTime::currentDateTime();
  if (!clients_.empty()) all_left_at_.reset();
  forget();
  emit changed();
  if (all_left) emit allLeft();
}

void LinkController::listen() {
  // What arrives until then is looked at together.
  if (!frame_.isActive()) frame_.start();
}

void LinkController::hear() {
  if (!server_) return;
  const auto now = std::chrono::steady_clock::now();
  for (link::LinkFelt& one : server_->takeFelt()) {
    const auto client =
        std::find_if(clients_.begin(), clients_.end(), [&](const auto& known) { return known.number == one.client; });
    if (client == clients_.end()) continue;  // it has left
    const auto shown = std::find_if(simulators_.begin(), simulators_.end(),
                                    [&](const Simulator& known) { return known.client == one.client; });
    Simulator simulator{one.client, text(client->name), std::move(one.felt), now};
    if (shown == simulators_.end()) {
      simulators_.push_back(std::move(simulator));
    } else {
      *shown = std::move(simulator);
    }
  }
  if (simulators_.empty()) return;
  if (!watch_.isActive()) watch_.start();
  emit simulatorsMoved();
}

void LinkController::forget() {
  const auto now = std::chrono::steady_clock::now();
  const auto gone = std::erase_if(simulators_, [&](const Simulator& one) {
    const auto is_one = [&](const link::LinkClient& client) { return client.number == one.client; };
    return now - one.heard > kSilence || std::none_of(clients_.begin(), clients_.end(), is_one);
  });
  if (simulators_.empty()) watch_.stop();
  if (gone > 0) emit simulatorsMoved();
}

}  // namespace tactus::workbench
