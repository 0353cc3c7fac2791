#include "app/workbench/link_parts.h"

#include <QAction>
#include <utility>

#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"

namespace tactus::workbench {

LinkParts::LinkParts(MainWindow& window, const ModelController& models, const SceneController& scene,
                     FeelController& feel, LinkController& link)
    : window_(window),
      feel_(feel),
      link_(link),
      states_(feel, scene),
      dialog_(new LinkDialog(link, &window)),
      serve_(window.menus().addAction(MenuSlot::kFeelLink, tr("Serve to a s&imulator…"))) {
  auto* sign = new LinkSign(link);
  window.strip().addState(sign);
  connect(sign, &QToolButton::clicked, this, &LinkParts::showDialog);
  connect(&link_, &LinkController::allLeft, this, [this] { window_.say(tr("The last simulator has left.")); });
  serve_->setEnabled(models.current() != nullptr);
  connect(&models, &ModelController::opened, serve_, [this] { serve_->setEnabled(true); });
  connect(serve_, &QAction::triggered, this, &LinkParts::showDialog);
  connect(&feel_, &FeelController::sampled, this, [this](std::span<const haptics::Sample> samples) {
    if (link_.wantsStates()) link_.tell(states_.of(samples));
  });
  connect(&feel_, &FeelController::stateChanged, this, &LinkParts::showFelt);
  connect(&link_, &LinkController::changed, this, [this] {
    if (std::exchange(serving_, link_.isServing()) == link_.isServing()) return;
    window_.say(serving_ ? tr("Simulators can connect to %1.").arg(link_.address())
                         : tr("Simulators are no longer served."));
  });
}

void LinkParts::showDialog() {
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void LinkParts::showFelt() {
  if (std::exchange(felt_, feel_.isRunning()) && !felt_ && link_.wantsStates()) link_.tell(states_.afterRun());
}

}  // namespace tactus::workbench
