#include "app/workbench/shell/stage_rail.h"

#include <QEvent>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/shell/stage_button.h"

namespace tactus::workbench {

StageRail::StageRail(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (const Stage stage : kStages) {
    auto* button = new StageButton(stage, this);
    buttons_.insert(stage, button);
    layout->addWidget(button);
    button->hide();
    connect(button, &StageButton::clicked, this, [this, stage] { emit chosen(stage); });
  }
  layout->addStretch(1);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  fitWidth();
}

void StageRail::show(Stage stage) { buttons_.value(stage)->show(); }

void StageRail::setReady(Stage stage, bool ready) { buttons_.value(stage)->setEnabled(ready); }

void StageRail::setStage(std::optional<Stage> stage) {
  for (StageButton* button : buttons_) {
    // Among exclusive buttons the checked one cannot be unchecked.
    button->setAutoExclusive(stage.has_value());
    button->setChecked(stage == button->stage());
  }
}

void StageRail::setCompact(bool compact) {
  if (compact == compact_) return;
  compact_ = compact;
  for (StageButton* button : buttons_) button->setCompact(compact);
  fitWidth();
}

// Larger text is wider.
void StageRail::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && !buttons_.isEmpty()) fitWidth();
}

void StageRail::fitWidth() { setFixedWidth(buttons_.first()->sizeHint().width()); }

}  // namespace tactus::workbench
