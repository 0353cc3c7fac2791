#include "app/workbench/tune/history/compare_switch.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include "app/workbench/base/theme.h"
#include "app/workbench/tune/history/compare_controller.h"

namespace tactus::workbench {
namespace {

// The pressed one stands out from any ground.
class SwitchButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? theme::accent() : theme::border(), hasFocus() ? 2 : 1));
    painter.setBrush(isChecked() ? theme::ink() : theme::card());
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    QFont letter = font();
    letter.setWeight(isChecked() ? QFont::Bold : QFont::Normal);
    painter.setFont(letter);
    painter.setPen(isChecked() ? theme::card() : theme::ink());
    painter.drawText(rect(), Qt::AlignCenter, text());
  }
};

}  // namespace

CompareSwitch::CompareSwitch(CompareController& compare, QWidget* parent)
    : QWidget(parent),
      compare_(compare),
      a_(addButton(QStringLiteral("A"), CompareSide::kA)),
      b_(addButton(QStringLiteral("B"), CompareSide::kB)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(a_);
  layout->addWidget(b_);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&compare_, &CompareController::shownChanged, this, &CompareSwitch::showSide);
  connect(&compare_, &CompareController::choicesChanged, this, &CompareSwitch::showSide);
  showSide();
}

QToolButton* CompareSwitch::addButton(const QString& letter, CompareSide side) {
  auto* button = new SwitchButton(this);
  button->setText(letter);
  button->setCheckable(true);
  button->setAccessibleName(tr("Show and feel %1").arg(letter));
  button->setFixedWidth(5 * theme::kGrid);
  connect(button, &QToolButton::clicked, this, [this, side] {
    compare_.show(side);
    showSide();
  });
  return button;
}

void CompareSwitch::showSide() {
  a_->setChecked(compare_.shown() == CompareSide::kA);
  b_->setChecked(compare_.shown() == CompareSide::kB);
  if (compare_.options().empty()) return;
  a_->setToolTip(tr("Show and feel A: %1 (Ctrl+B)").arg(compare_.nameOf(compare_.choice(CompareSide::kA))));
  b_->setToolTip(tr("Show and feel B: %1 (Ctrl+B)").arg(compare_.nameOf(compare_.choice(CompareSide::kB))));
}

}  // namespace tactus::workbench
