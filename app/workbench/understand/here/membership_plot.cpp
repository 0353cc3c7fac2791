#include "app/workbench/understand/here/membership_plot.h"

#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_colors.h"
#include "app/workbench/plot/term_labels.h"
#include "app/workbench/plot/term_outline.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/plot/plot_marks.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

constexpr int kLabelRows = 2;

std::vector<std::string> numbers(const std::vector<double>& points) {
  std::vector<std::string> texts;
  texts.reserve(points.size());
  for (const double point : points) texts.push_back(base::formatNumber(point));
  return texts;
}

// One line per term with its exact points.
QString pointsText(const std::vector<fuzzy::Term>& terms) {
  QStringList lines;
  for (const fuzzy::Term& term : terms) {
    lines << labelOf(term) + QStringLiteral(": ") + text(base::joined(numbers(term.points), ", "));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

MembershipPlot::MembershipPlot(const fuzzy::Variable& variable, QWidget* parent)
    : QWidget(parent), variable_(variable), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumHeight(112);
  setAccessibleName(tr("Terms of %1").arg(labelOf(variable_)));

  labels_ = new TermLabels(*plot_, kLabelRows);
  styleAxis(*plot_->xAxis, variable);
  styleAxis(*plot_->yAxis, variable);
  plot_->yAxis->setRange(0, 1.06);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(1);
  plot_->yAxis->setTicker(ticker);
  plot_->xAxis->grid()->setVisible(false);
  plot_->xAxis->setTickLabelPadding(2);
  plot_->xAxis->setLabelPadding(0);
  // A ratio has no unit to write, but its axis stands as high as the others.
  const QString unit = unitText(variable.unit);
  plot_->xAxis->setLabel(unit.isEmpty() ? QStringLiteral(" ") : unit);
  plot_->axisRect()->setAutoMargins(QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(kLeftMargin, labels_->height(), kRightMargin, 0));

  auto* landmarks = new LandmarkMarks(*plot_, LandmarkMarks::Place::kInside);
  landmarks->setVariable(variable);
  landmarks->setText(LandmarkMarks::Text::kNone);
  marker_ = new ValueMarker(*plot_);

  connect(plot_, &QCustomPlot::mousePress, this, &MembershipPlot::onMouse);
  connect(plot_, &QCustomPlot::mouseMove, this, &MembershipPlot::onMouse);
}

void MembershipPlot::setTerms(const std::vector<fuzzy::Term>& terms) {
  if (terms == terms_ && plot_->graphCount() > 0) return;
  terms_ = terms;
  plot_->clearGraphs();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const TermOutline outline = outlineOf(terms[i], variable_.min, variable_.max);
    addShape(*plot_, termLine(variable_, terms, i), 1.5, 0.2F).setData(outline.x, outline.membership, true);
  }
  labels_->setTerms(variable_, terms);
  setToolTip(pointsText(terms));
  updateMarker();
  redraw(*plot_);
}

void MembershipPlot::setValue(std::optional<double> value) {
  if (value == value_) return;
  value_ = value;
  updateMarker();
  redraw(*plot_);
}

// As many numbers as stand apart.
void MembershipPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr double kRoom = 1.35;  // of the widest number, with the gap to the next
  const double each = kRoom * QFontMetrics(plot_->xAxis->tickLabelFont()).horizontalAdvance(numberText(variable_.max));
  int count = 4;
  while (count > 1 && static_cast<double>(universeTicks(variable_.min, variable_.max, count).size()) * each >
                          width() - kLeftMargin - kRightMargin) {
    --count;
  }
  plot_->xAxis->ticker()->setTickCount(count);
}

void MembershipPlot::onMouse(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton)) return;
  emit picked(placeOf(variable_, plot_->xAxis->pixelToCoord(event->position().x())));
}

void MembershipPlot::updateMarker() {
  std::vector<double> memberships;
  for (const fuzzy::Term& term : terms_) {
    const double membership = value_ ? fuzzy::MembershipFunction::of(term)(*value_) : 0;
    if (membership > 0) memberships.push_back(membership);
  }
  marker_->set(value_, std::move(memberships));
}

void MembershipPlot::fillTable(PlotTable& table) const { workbench::fillTable(table, variable_, terms_); }

void MembershipPlot::paintPicture(QCPPainter& painter, const QSize& size) {
  paintPlot(*plot_, painter, size, {marker_});
}

}  // namespace tactus::workbench
