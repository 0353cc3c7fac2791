#include "app/workbench/tune/history/compare_strip.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/compare_switch.h"

namespace tactus::workbench {

CompareStrip::CompareStrip(CompareController& compare, QWidget* parent)
    : Card(parent),
      compare_(compare),
      shown_(new ElidedLabel(this)),
      other_(new ElidedLabel(this)),
      end_(new QToolButton(this)) {
  shown_->setFont(theme::headingFont());
  end_->setText(tr("End comparison"));
  end_->setToolTip(tr("Show and feel the open model again (Ctrl+Shift+B)"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, 4, theme::kGrid, 4);
  layout->setSpacing(2 * theme::kGrid);
  layout->addWidget(new CompareSwitch(compare_, this));
  layout->addWidget(shown_);
  layout->addWidget(other_);
  layout->addStretch(1);
  layout->addWidget(end_);
  hide();
  connect(end_, &QToolButton::clicked, &compare_, &CompareController::end);
  connect(&compare_, &CompareController::shownChanged, this, &CompareStrip::showState);
  connect(&compare_, &CompareController::choicesChanged, this, &CompareStrip::showState);
}

void CompareStrip::setFelt(bool felt) {
  if (felt == felt_) return;
  felt_ = felt;
  showState();
}

void CompareStrip::showState() {
  const auto side = compare_.shown();
  setVisible(side.has_value());
  if (!side) return;
  setColors(theme::accent(), theme::accent());
  for (ElidedLabel* label : {shown_, other_}) setInk(*label, Qt::white);
  const bool is_a = *side == CompareSide::kA;
  const QString letter = is_a ? QStringLiteral("A") : QStringLiteral("B");
  const QString name = compare_.nameOf(compare_.choice(*side));
  shown_->setFullText(felt_ ? tr("On screen and device: %1, %2").arg(letter, name)
                            : tr("Shown is %1: %2").arg(letter, name));
  const CompareSide hidden = is_a ? CompareSide::kB : CompareSide::kA;
  other_->setFullText(
      tr("%1: %2").arg(is_a ? QStringLiteral("B") : QStringLiteral("A"), compare_.nameOf(compare_.choice(hidden))));
}

}  // namespace tactus::workbench
