#include "app/workbench/labs/speed/cluster_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <array>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/labs/speed/subject_title.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_colors.h"

namespace tactus::workbench {
namespace {

constexpr int kCurvePoints = 160;
constexpr double kFoot = 0.06;  // where the intervals lie
constexpr std::array<Qt::PenStyle, 3> kDashes = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};

QColor lineOf(const fuzzy::Variable& speed, std::size_t cluster) {
  return cluster < speed.terms.size() ? termLine(speed, speed.terms, cluster) : theme::mutedInk();
}

}  // namespace

ClusterPlot::ClusterPlot(QWidget* parent)
    : QWidget(parent), title_(new ElidedLabel(this)), warnings_(new QLabel(this)), plot_(makePlot(this)) {
  title_->setFont(theme::headingFont());
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setFont(theme::smallFont());
  setInk(*warnings_, theme::warningInk());
  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(title_, 1);
  head->addWidget(warnings_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  setMinimumSize(200, 130);
  fuzzy::Variable membership;
  membership.min = 0;
  membership.max = 1;
  styleAxis(*plot_->xAxis, membership);
  styleAxis(*plot_->yAxis, membership);
  plot_->yAxis->setRange(0, 1.06);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(0.5);
  plot_->yAxis->setTicker(ticker);
  plot_->xAxis->grid()->setVisible(false);
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
}

void ClusterPlot::show(const SpeedSubject& subject, const fuzzy::Variable& speed, std::size_t number,
                       const std::vector<elicitation::Interval>& intervals) {
  const elicitation::ParticipantSpeeds& speeds = subject.speeds;
  heading_ = subjectTitle(subject);
  title_->setFullText(heading_, subjectName(subject));
  setInk(*title_, theme::readableText(theme::expert(number)));
  const int warnings = static_cast<int>(speeds.diagnostics.warnings.size());
  warnings_->setVisible(warnings > 0 || !subject.failure.empty());
  warnings_->setText(subject.failure.empty() ? tr("▲ %n warning(s)", nullptr, warnings) : tr("▲ no clusters"));
  QStringList lines;
  if (!subject.failure.empty()) lines << text(subject.failure);
  for (const std::string& warning : speeds.diagnostics.warnings) lines << text(warning);
  warnings_->setToolTip(lines.join(QLatin1Char('\n')));
  setAccessibleName(tr("Clusters of %1").arg(text(speeds.participant)));

  plot_->clearPlottables();
  plot_->clearItems();
  fuzzy::Variable axis;
  axis.min = 0;
  axis.max = subject.end_mm_s;
  styleAxis(*plot_->xAxis, axis);
  plot_->xAxis->setLabel(tr("Speed (mm/s)"));
  plot_->xAxis->grid()->setVisible(false);
  addHistogram(subject);
  addCentres(subject, speed, intervals);
  redraw(*plot_);
}

void ClusterPlot::addHistogram(const SpeedSubject& subject) {
  QColor fill = theme::mutedInk();
  fill.setAlphaF(0.22F);
  QVector<double> x;
  QVector<double> height;
  const double width_mm_s = subject.end_mm_s / static_cast<double>(std::max<std::size_t>(1, subject.histogram.size()));
  for (std::size_t i = 0; i < subject.histogram.size(); ++i) {
    for (const std::size_t edge : {i, i + 1}) {
      x << static_cast<double>(edge) * width_mm_s;
      height << subject.histogram[i];
    }
  }
  QCPGraph& bars = addShape(*plot_, Qt::transparent, 0, 0);
  bars.setPen(Qt::NoPen);
  bars.setBrush(theme::onCard(fill));
  bars.setData(x, height, true);
}

void ClusterPlot::addCentres(const SpeedSubject& subject, const fuzzy::Variable& speed,
                             const std::vector<elicitation::Interval>& intervals) {
  const std::vector<double>& centres = subject.speeds.centres;
  if (centres.empty()) return;
  std::vector<QVector<double>> memberships(centres.size());
  QVector<double> x;
  std::vector<double> at(centres.size());
  for (int i = 0; i <= kCurvePoints; ++i) {
    x << subject.end_mm_s * i / kCurvePoints;
    elicitation::fcmMemberships(x.back(), centres, subject.speeds.m, at);
    for (std::size_t k = 0; k < centres.size(); ++k) memberships[k] << at[k];
  }
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const QColor color = lineOf(speed, k);
    QCPGraph& curve = addShape(*plot_, color, 2, 0);
    curve.setPen(QPen(color, 2, kDashes[k % kDashes.size()]));
    curve.setData(x, memberships[k], true);
    QCPGraph& rule = addShape(*plot_, color, 1, 0);
    rule.setPen(QPen(color, 1, Qt::DotLine));
    rule.setData({centres[k], centres[k]}, {0.0, 1.0}, true);
    if (k >= intervals.size()) continue;
    QCPGraph& interval = addShape(*plot_, theme::ink(), 2, 0);
    interval.setData({intervals[k].low, intervals[k].high}, {kFoot, kFoot}, true);
    interval.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, theme::ink(), 4));
  }
}

void ClusterPlot::paint(QCPPainter& painter, const QSize& size) {
  painter.setFont(theme::headingFont());
  painter.setPen(theme::ink());
  const int head = painter.fontMetrics().height() + 4;
  painter.drawText(QRect(theme::kGrid, 0, size.width(), head), Qt::AlignLeft | Qt::AlignVCenter, heading_);
  painter.translate(0, head);
  paintPlot(*plot_, painter, size - QSize(0, head), {});
  painter.translate(0, -head);
}

}  // namespace tactus::workbench
