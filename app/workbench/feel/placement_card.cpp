#include "app/workbench/feel/placement_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"

namespace tactus::workbench {
namespace {

constexpr int kSummaryBeside = 500;  // px at 100 %: below it the summary has a line of its own

QString strokesText(unsigned strokes) { return PlacementCard::tr("%n stroke(s)", nullptr, static_cast<int>(strokes)); }

}  // namespace

PlacementCard::PlacementCard(QWidget* parent)
    : QWidget(parent),
      progress_(new QLabel(this)),
      summary_(new ElidedLabel(this)),
      next_(new QPushButton(tr("New placement"), this)) {
  progress_->setTextFormat(Qt::PlainText);
  progress_->setFont(theme::headingFont());
  summary_->setFont(theme::smallFont());
  setInk(*summary_, theme::mutedInk());
  next_->setToolTip(tr("Take the tube out and begin again"));
  keepFitted(*next_, [this] {
    next_->setMinimumWidth(next_->fontMetrics().horizontalAdvance(next_->text()) + 3 * theme::kGrid);
  });
  next_->setFocusPolicy(Qt::TabFocus);

  layout_ = new QGridLayout(this);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setHorizontalSpacing(theme::kGrid);
  layout_->setVerticalSpacing(2);
  layout_->addWidget(progress_, 0, 0);
  layout_->addWidget(summary_, 0, 1);
  layout_->addWidget(next_, 0, 2);
  layout_->setColumnStretch(1, 1);

  setProgress(0, 0, {});
  setSummary(std::nullopt);
  setRunning(false);
  connect(next_, &QPushButton::clicked, this, &PlacementCard::newPlacementRequested);
}

void PlacementCard::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool below = width() < appearance::scaled(kSummaryBeside);
  if (below == below_) return;
  below_ = below;
  layout_->removeWidget(summary_);
  layout_->addWidget(summary_, below ? 1 : 0, below ? 0 : 1, 1, below ? 3 : 1);
}

void PlacementCard::setProgress(unsigned strokes, double depth_mm, const QString& region) {
  QString line = strokesText(strokes);
  line += QStringLiteral(" · ") + quantityText(depth_mm, "mm", 0);
  if (!region.isEmpty()) line += QStringLiteral(" · ") + region;
  if (line != progress_->text()) progress_->setText(line);
}

void PlacementCard::setSummary(const std::optional<PlacementSummary>& summary) {
  if (!summary) {
    has_summary_ = false;
    summary_->setFullText(tr("A summary follows when the placement ends."));
    return;
  }
  has_summary_ = true;
  const QString numbers = tr("%1 s, %2, %3, peak %4, mean %5")
                              .arg(numberText(summary->duration_s, 1), strokesText(summary->strokes),
                                   quantityText(summary->depth_mm, "mm", 0), quantityText(summary->peak_force_n, "N"),
                                   quantityText(summary->mean_force_n, "N"));
  summary_->setFullText((summary->replay      ? tr("Last replay, SIMULATED: %1")
                         : summary->simulated ? tr("Last placement, SIMULATED: %1")
                                              : tr("Last placement: %1"))
                            .arg(numbers));
}

void PlacementCard::setRunning(bool running) {
  next_->setEnabled(running);
  // Without a current placement the whole line is for the last one.
  progress_->setVisible(running || !has_summary_);
}

}  // namespace tactus::workbench
