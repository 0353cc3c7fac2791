#include "app/workbench/views/placement_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "app/workbench/display_text.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

QString strokesText(unsigned strokes) {
  return strokes == 1 ? PlacementCard::tr("1 stroke") : PlacementCard::tr("%1 strokes").arg(strokes);
}

}  // namespace

PlacementCard::PlacementCard(QWidget* parent)
    : QWidget(parent),
      progress_(new QLabel(this)),
      summary_(new QLabel(this)),
      next_(new QPushButton(tr("New placement"), this)) {
  progress_->setTextFormat(Qt::PlainText);
  progress_->setFont(theme::headingFont());
  summary_->setTextFormat(Qt::PlainText);
  summary_->setWordWrap(true);
  summary_->setFont(theme::smallFont());
  QPalette muted = summary_->palette();
  muted.setColor(QPalette::WindowText, theme::mutedInk());
  summary_->setPalette(muted);
  summary_->setMinimumHeight(2 * QFontMetrics(theme::smallFont()).height());
  summary_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  next_->setToolTip(tr("Take the tube out and begin again"));
  next_->setMinimumWidth(next_->sizeHint().width() + 2 * theme::kGrid);
  next_->setFocusPolicy(Qt::TabFocus);

  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(theme::kGrid);
  layout->setVerticalSpacing(4);
  layout->addWidget(progress_, 0, 0);
  layout->addWidget(next_, 0, 1);
  layout->addWidget(summary_, 1, 0, 1, 2);
  layout->setColumnStretch(0, 1);

  setProgress(0, 0, {});
  setSummary(std::nullopt);
  setRunning(false);
  connect(next_, &QPushButton::clicked, this, &PlacementCard::newPlacementRequested);
}

void PlacementCard::setProgress(unsigned strokes, double depth_mm, const QString& region) {
  QString line = strokesText(strokes);
  line += QStringLiteral(" · ") + quantityText(depth_mm, "mm", 0);
  if (!region.isEmpty()) line += QStringLiteral(" · ") + region;
  if (line != progress_->text()) progress_->setText(line);
}

void PlacementCard::setSummary(const std::optional<PlacementSummary>& summary) {
  if (!summary) {
    summary_->setText(tr("A summary follows when the placement ends."));
    return;
  }
  const QString numbers = tr("%1 s, %2, %3 deep, peak %4, mean %5")
                              .arg(numberText(summary->duration_s, 1), strokesText(summary->strokes),
                                   quantityText(summary->depth_mm, "mm", 0), quantityText(summary->peak_force_n, "N"),
                                   quantityText(summary->mean_force_n, "N"));
  summary_->setText(
      (summary->simulated ? tr("Last placement (simulated device): %1") : tr("Last placement: %1")).arg(numbers));
}

void PlacementCard::setRunning(bool running) { next_->setEnabled(running); }

}  // namespace tactus::workbench
