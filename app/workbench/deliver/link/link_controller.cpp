#include "app/workbench/deliver/link/link_controller.h"

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
  return {model->compiled, std::move(text)};
}

}  // namespace

LinkController::LinkController(const ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  connect(&models_, &ModelController::opened, this, &LinkController::publish);
  connect(&models_, &ModelController::edited, this, &LinkController::publish);
  connect(&models_, &ModelController::shownChanged, this, &LinkController::publish);
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
  auto started = link::LinkServer::start(std::move(settings), linkModel(models_.shown()->shared),
                                         [this] { calls_.post([this] { showClients(); }); });
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
  emit changed();
  if (all_left) emit allLeft();
}

}  // namespace tactus::workbench
