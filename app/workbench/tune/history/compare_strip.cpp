#include "app/workbench/tune/history/compare_strip.h"

#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/recovery_controller.h"

namespace tactus::workbench {

RecoveryStrip::RecoveryStrip(RecoveryController& recovery, QWidget* parent)
    : Card(parent),
      recovery_(recovery),
      label_(new QLabel(this)),
      restore_(new QPushButton(tr("Restore"), this)),
      discard_(new QPushButton(tr("Discard"), this)),
      later_(new QPushButton(tr("Decide later"), this)) {
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  restore_->setToolTip(tr("Show the last state of the model; every edit can be undone"));
  discard_->setToolTip(tr("Keep the model as its file has it; the edits stay in the history of the file"));
  later_->setToolTip(tr("Ask again when you open this model"));
  auto* layout =
      makeRow(this, {{label_, 1}}, theme::kGrid, {2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid});
  for (QPushButton* button : {restore_, discard_, later_}) {
    button->setAccessibleName(button->text());
    layout->addWidget(button, 0, Qt::AlignVCenter);
  }
  connect(restore_, &QPushButton::clicked, this, &RecoveryStrip::restoreRequested);
  connect(discard_, &QPushButton::clicked, &recovery_, &RecoveryController::discard);
  connect(later_, &QPushButton::clicked, &recovery_, &RecoveryController::later);
  connect(&recovery_, &RecoveryController::offerChanged, this, &RecoveryStrip::showOffer);
  showOffer();
}

void RecoveryStrip::showOffer() {
  const auto offer = recovery_.offered();
  setVisible(offer.has_value());
  if (!offer) return;
  setColors(theme::warningFill(), theme::warningInk());
  setInk(*label_, theme::warningInk());
  const QString name = shownFileName(offer->document);
  const QString when = offer->last.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
  QString sentence = tr("The workbench ended unexpectedly at %1 with changes of %2 that were not saved (edits: %3).")
                         .arg(when, name)
                         .arg(offer->edits);
  if (recovery_.isBusy()) sentence += QLatin1Char(' ') + tr("Restoring…");
  if (recovery_.others() > 0) sentence += QLatin1Char(' ') + tr("Further ones: %1.").arg(recovery_.others());
  label_->setText(sentence);
  label_->setToolTip(offer->document);
  for (QPushButton* button : {restore_, discard_, later_}) button->setEnabled(!recovery_.isBusy());
}

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
  makeRow(this, {a_, b_}, 0);
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

CompareStrip::CompareStrip(CompareController& compare, QWidget* parent)
    : Card(parent),
      compare_(compare),
      shown_(new ElidedLabel(this)),
      other_(new ElidedLabel(this)),
      end_(new QToolButton(this)) {
  shown_->setFont(theme::headingFont());
  end_->setText(tr("End comparison"));
  end_->setToolTip(tr("Show and feel the open model again (Ctrl+Shift+B)"));
  makeRow(this, {new CompareSwitch(compare_, this), shown_, other_, spring(1), end_}, 2 * theme::kGrid,
          {2 * theme::kGrid, 4, theme::kGrid, 4});
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
                            : tr("%1 is on the screen: %2").arg(letter, name));
  const CompareSide hidden = is_a ? CompareSide::kB : CompareSide::kA;
  other_->setFullText(
      tr("%1: %2").arg(is_a ? QStringLiteral("B") : QStringLiteral("A"), compare_.nameOf(compare_.choice(hidden))));
}

}  // namespace tactus::workbench
