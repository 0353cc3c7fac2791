#include "app/workbench/labs/speed/number_page.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/plot/plot_style.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

QString fixed(double value, int decimals) { return text(base::formatFixed(value, decimals)); }

QString fixed(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : QStringLiteral("–");
}

LabColumn measure(const QString& title, const QString& tip) { return {title, Qt::AlignHCenter, tip}; }

std::vector<LabColumn> columnsOf(const fuzzy::Variable& speed) {
  std::vector<LabColumn> out = {{SpeedTable::tr("Participant")}};
  for (const fuzzy::Term& level : speed.terms) {
    out.push_back({SpeedTable::tr("%1\nmean (SD)").arg(labelOf(level)), Qt::AlignHCenter});
  }
  out.push_back(
      measure(SpeedTable::tr("Accuracy"),
              SpeedTable::tr("Share of the samples whose cluster is that of the level asked for. Warns below 0.6.")));
  out.push_back(
      measure(SpeedTable::tr("Rand\nindex"),
              SpeedTable::tr("Agreement of clusters and levels beyond chance; 1 is perfect. Warns below 0.3.")));
  out.push_back(measure(SpeedTable::tr("Separation\nd′"),
                        SpeedTable::tr("Difference of neighboring levels in standard deviations. Warns below 1.")));
  out.push_back(
      measure(SpeedTable::tr("Trend\np"),
              SpeedTable::tr("Whether the means of the strokes rise with the level: Jonckheere-Terpstra, one-sided.")));
  out.push_back(
      measure(SpeedTable::tr("Silhouette"), SpeedTable::tr("Fuzzy silhouette: near 1 the clusters are apart.")));
  out.push_back(measure(SpeedTable::tr("Xie-Beni"), SpeedTable::tr("Xie-Beni index: smaller is better.")));
  out.push_back(measure(SpeedTable::tr("Warnings"), SpeedTable::tr("Point at a row to read its warnings.")));
  return out;
}

}  // namespace

void SpeedTable::show(std::shared_ptr<const SpeedResult> result) {
  const bool same_shape = result && result_ && result->subjects.size() == result_->subjects.size() &&
                          result->speed.terms.size() == result_->speed.terms.size();
  if (same_shape) {
    result_ = std::move(result);
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    return;
  }
  beginResetModel();
  result_ = std::move(result);
  setColumns(result_ ? columnsOf(result_->speed) : std::vector<LabColumn>());
  endResetModel();
}

std::size_t SpeedTable::levels() const { return result_ ? result_->speed.terms.size() : 0; }

QVariant SpeedTable::cell(int row, int column, int role) const {
  const SpeedSubject& subject = *result_->subjects[static_cast<std::size_t>(row)];
  const int measure = column - 1 - static_cast<int>(levels());
  const auto& warnings = subject.speeds.diagnostics.warnings;
  if (role == Qt::ToolTipRole) {
    QStringList lines;
    if (!subject.failure.empty()) lines << text(subject.failure);
    for (const std::string& warning : warnings) lines << text(warning);
    return lines.join(QLatin1Char('\n'));
  }
  if (role == Qt::ForegroundRole && measure == kWarnings && !warnings.empty()) return theme::warningInk();
  if (role != Qt::DisplayRole) return {};
  if (column == 0) {
    const QString who = text(subject.speeds.participant);
    return subject.speeds.simulated ? tr("%1 (simulated)").arg(who) : who;
  }
  if (!subject.checked) return QStringLiteral("…");
  if (measure >= 0) return measureText(subject, measure);
  const auto level = static_cast<std::size_t>(column - 1);
  const auto& found = subject.speeds.diagnostics.levels;
  if (level >= found.size() || found[level].samples == 0) return QStringLiteral("–");
  return tr("%1 (%2)").arg(fixed(found[level].mean_mm_s, 1), fixed(found[level].sd_mm_s, 1));
}

QString SpeedTable::measureText(const SpeedSubject& subject, int measure) const {
  const elicitation::LevelDiagnostics& found = subject.speeds.diagnostics;
  const bool compared = !found.confusion.counts.empty();
  switch (measure) {
    case kAccuracy: return compared ? fixed(found.confusion.accuracy, 2) : QStringLiteral("–");
    case kRand: return compared ? fixed(found.confusion.adjusted_rand_index, 2) : QStringLiteral("–");
    case kSeparation: {
      QStringList all;
      for (const auto& one : found.separations) all << fixed(one, 2);
      return all.isEmpty() ? QStringLiteral("–") : all.join(QStringLiteral(" · "));
    }
    case kTrend:
      if (!found.trend) return QStringLiteral("–");
      return found.trend->p < 0.001 ? QStringLiteral("< 0.001") : fixed(found.trend->p, 3);
    case kSilhouette: return fixed(subject.speeds.validity.fuzzy_silhouette, 2);
    case kXieBeni: return fixed(subject.speeds.validity.xie_beni, 3);
    default: return found.warnings.empty() ? QStringLiteral("–") : tr("▲ %1").arg(found.warnings.size());
  }
}

ObjectivePlot::ObjectivePlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(220, 140);
  setAccessibleName(tr("Objective against iteration"));
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
}

void ObjectivePlot::show(const SpeedResult& result, const std::vector<ObjectiveTrace>& traces, std::size_t first) {
  plot_->clearPlottables();
  const std::vector<std::size_t> numbers = subjectNumbers(result);
  fuzzy::Variable iterations;
  iterations.max = 1;
  double highest = 1;
  for (std::size_t i = 0; i < traces.size() && first + i < numbers.size(); ++i) {
    const std::vector<double>& objective = traces[i].objective;
    if (objective.empty() || !(objective.back() > 0)) continue;
    QVector<double> x;
    QVector<double> y;
    for (std::size_t k = 0; k < objective.size(); ++k) {
      x << static_cast<double>(k);
      y << objective[k] / objective.back();
    }
    iterations.max = std::max(iterations.max, x.back());
    highest = std::max(highest, y.front());
    QCPGraph& line = addShape(*plot_, theme::expert(numbers[first + i]), 1.8, 0);
    line.setData(x, y, true);
    line.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4));
  }
  styleAxis(*plot_->xAxis, iterations);
  styleAxis(*plot_->yAxis, iterations);
  plot_->xAxis->setLabel(tr("Iteration of the textbook"));
  plot_->yAxis->setLabel(tr("J / its minimum"));
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
  plot_->yAxis->setRange(1 - 0.05 * (highest - 1 + 0.01), 1 + 1.08 * (highest - 1 + 0.01));
  redraw(*plot_);
}

namespace {

constexpr int kMostShortRows = 8;
constexpr qsizetype kMostWarnings = 30;  // lines; more are not read

/// A card with a heading and `content`.
Card* titled(const QString& title, QWidget* content, QWidget* parent) {
  auto* card = new Card(parent);
  auto* heading = new QLabel(title, card);
  heading->setFont(theme::headingFont());
  auto* layout = new QVBoxLayout(card);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid / 2);
  layout->addWidget(heading);
  layout->addWidget(content, 1);
  return card;
}

}  // namespace

NumberPage::NumberPage(SpeedLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      table_(new SpeedTable(this)),
      view_(makeLabTable(*table_, -1, tr("Table 1: speeds of each participant at each level"), this)),
      warnings_(new QLabel(this)),
      objective_(new ObjectivePlot(this)) {
  view_->verticalHeader()->setDefaultSectionSize(4 * theme::kGrid);
  warnings_->setTextFormat(Qt::PlainText);
  warnings_->setWordWrap(true);
  warnings_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  warnings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(warnings_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->viewport()->setAutoFillBackground(false);
  warnings_->setAutoFillBackground(false);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(titled(tr("Table 1: insertion speed in mm/s, and how clusters and levels agree"), view_, this), 0,
                    0, 1, 2);
  layout->addWidget(titled(tr("Warnings"), scroll, this), 1, 0);
  layout->addWidget(titled(tr("Objective against iteration"), objective_, this), 1, 1);
  layout->setRowStretch(1, 1);
  layout->setColumnStretch(0, 3);
  layout->setColumnStretch(1, 2);
  auto* refresh = new Refresh(this, [this] { follow(); });
  connect(&lab_, &SpeedLab::resultChanged, refresh, &Refresh::request);
  connect(&lab_, &SpeedLab::pageChanged, refresh, &Refresh::request);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) lab_.setPage(static_cast<std::size_t>(current.row()) / SpeedLab::kPerPage);
  });
  refresh->request();
}

QString NumberPage::warningText() const {
  const SpeedResult& result = *lab_.result();
  QStringList lines;
  if (!result.failure.empty()) lines << text(result.failure);
  bool checked = true;
  for (const auto& subject : result.subjects) {
    checked = checked && (subject->checked || !subject->failure.empty());
    if (subject->speeds.clusters) {
      for (const std::string& warning : subject->speeds.clusters->warnings) {
        lines << text(subject->speeds.participant) + QStringLiteral(": ") + text(warning);
      }
    }
    for (const std::string& warning : subject->speeds.diagnostics.warnings) lines << text(warning);
  }
  for (const std::string& sentence : result.same_terms) lines << text(sentence);
  if (lines.isEmpty()) return checked ? tr("None: clusters and levels agree.") : tr("Still looking…");
  const qsizetype more = lines.size() - kMostWarnings;
  if (more > 0) {
    lines = lines.mid(0, kMostWarnings);
    lines << tr("and %n more; point at a row of the table to read its own", nullptr, static_cast<int>(more));
  }
  for (QString& line : lines) line.prepend(QStringLiteral("▲ "));
  return lines.join(QLatin1Char('\n'));
}

void NumberPage::follow() {
  const auto& result = lab_.result();
  table_->show(result);
  // A few rows take no more room than they need.
  const int rows = table_->rowCount();
  const int height =
      view_->horizontalHeader()->sizeHint().height() + 4 + rows * view_->verticalHeader()->defaultSectionSize();
  view_->setMaximumHeight(rows > kMostShortRows ? QWIDGETSIZE_MAX : height);
  if (!result) {
    warnings_->clear();
    return;
  }
  warnings_->setText(warningText());
  objective_->show(*result, lab_.objectives(), lab_.shown().first);
}

}  // namespace tactus::workbench
