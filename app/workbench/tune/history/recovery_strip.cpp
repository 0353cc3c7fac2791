#include "app/workbench/tune/history/recovery_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
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
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(label_, 1);
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

}  // namespace tactus::workbench
