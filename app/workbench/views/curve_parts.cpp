#include "app/workbench/views/curve_parts.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>

#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/controllers/ghost_controller.h"
#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/reference_controller.h"
#include "app/workbench/views/curves_panel.h"
#include "app/workbench/views/main_window.h"
#include "app/workbench/views/membership_editor.h"

namespace tactus::workbench {

CurveParts::CurveParts(MainWindow& window, const ModelController& models, EditController& edits, GhostController& ghost,
                       ReferenceController& references)
    : window_(window), models_(models), references_(references) {
  auto* curves = window_.findChild<CurvesPanel*>();
  curves->setGhost(ghost);
  curves->setReferences(references);
  const auto show_pace = [&edits, curves] { curves->setFast(edits.inGesture()); };
  connect(&edits, &EditController::changed, curves, show_pace);
  connect(&edits, &EditController::historyChanged, curves, show_pace);
  window_.findChild<MembershipEditor*>()->setGhost(ghost);

  open_reference_ = window_.addReferenceAction();
  open_reference_->setEnabled(false);
  connect(open_reference_, &QAction::triggered, this, &CurveParts::chooseReference);
  connect(&models_, &ModelController::opened, open_reference_, [this] { open_reference_->setEnabled(true); });
}

void CurveParts::chooseReference() {
  const QString folder = QFileInfo(models_.current()->path).absolutePath();
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Lay a reference curve over the plot"), folder,
                                                    tr("Tables (*.csv);;All files (*)"));
  if (!path.isEmpty()) references_.open(path);
}

}  // namespace tactus::workbench
