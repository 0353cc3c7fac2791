#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"

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
  next_->setToolTip(tr("Take the tool out and begin again"));
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

namespace {

constexpr int kLines = 5;            // at most
constexpr int kNarrowestText = 120;  // px: narrower before it has its place
constexpr int kCompactLines = 3;

}  // namespace

ProcedurePanel::ProcedurePanel(QWidget* parent)
    : QWidget(parent), list_(new QWidget(this)), head_(new ElidedLabel(this)), text_(new WrappedLabel(this)) {
  auto* grid = new QGridLayout(list_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  text_->setFont(theme::smallFont());

  makeColumn(this, {list_, head_, {text_, 1}}, 4);
  head_->setFont(theme::headingFont());
  setInk(*head_, theme::accent());
  setDetail(Detail::kList);
  keepFitted(*text_, [this] { fitText(); });
}

void ProcedurePanel::setSteps(std::vector<ProcedureStep> steps) {
  for (const Row& row : std::exchange(rows_, {})) {
    delete row.number;
    delete row.title;
  }
  steps_ = std::move(steps);
  shown_.reset();
  setVisible(!steps_.empty());
  auto* grid = static_cast<QGridLayout*>(list_->layout());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Row row{new QLabel(QString::number(i + 1), list_), new QLabel(steps_[i].title, list_)};
    row.number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    keepFitted(*row.number, [number = row.number] {
      number->setMinimumWidth(number->fontMetrics().horizontalAdvance(QStringLiteral("00")));
    });
    row.title->setTextFormat(Qt::PlainText);
    grid->addWidget(row.number, static_cast<int>(i), 0);
    grid->addWidget(row.title, static_cast<int>(i), 1);
    rows_.push_back(row);
  }
  fitText();
  setDepth(depth_mm_);
}

void ProcedurePanel::setDetail(Detail room) {
  const bool listed = room == Detail::kList;
  list_->setVisible(listed);
  head_->setVisible(!listed);
  text_->setVisible(room != Detail::kHeading);
  lines_ = listed ? kLines : kCompactLines;
  fitText();
}

// The longest text has its place, so that nothing moves from step to step.
void ProcedurePanel::fitText() {
  const QFontMetrics metrics = text_->fontMetrics();
  int least = lines_ * metrics.height();
  for (const ProcedureStep& step : steps_) {
    const QRect room(0, 0, std::max(text_->width(), kNarrowestText), kLines * metrics.height());
    least = std::max(least, std::min(room.height(), metrics.boundingRect(room, Qt::TextWordWrap, step.text).height()));
  }
  text_->setMinimumHeight(least);
}

void ProcedurePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitText();
}

void ProcedurePanel::setDepth(double depth_mm) {
  depth_mm_ = depth_mm;
  if (steps_.empty()) return;
  const std::size_t step = stepAt(steps_, depth_mm).value_or(0);
  if (shown_ != step) show(step);
}

void ProcedurePanel::show(std::size_t step) {
  shown_ = step;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    QFont font = this->font();
    font.setBold(i == step);
    for (QLabel* label : {rows_[i].number, rows_[i].title}) {
      label->setFont(font);
      setInk(*label, i == step ? theme::accent() : i < step ? theme::ink() : theme::mutedInk());
    }
  }
  head_->setFullText(tr("%1 of %2: %3").arg(step + 1).arg(steps_.size()).arg(steps_[step].title));
  text_->setText(steps_[step].text);
  head_->setHint(steps_[step].text);
  text_->setToolTip(steps_[step].text);
}

}  // namespace tactus::workbench
