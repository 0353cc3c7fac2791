#include "app/workbench/labs/speed/number_page.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/plot/chart.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

QString fixed(double value, int decimals) { return text(base::formatFixed(value, decimals)); }

QString fixed(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : QStringLiteral("–");
}

using SubjectRow = std::shared_ptr<const SpeedSubject>;

const QString kNoNumber = QStringLiteral("–");

// The numbers come once they are computed.
CellOf<SubjectRow> whenChecked(std::function<QString(const elicitation::ParticipantSpeeds&)> text) {
  return [text = std::move(text)](const SubjectRow& row) {
    return row->checked ? text(row->speeds) : QStringLiteral("…");
  };
}

Column<SubjectRow> measure(const QString& head, const QString& tip,
                           std::function<QString(const elicitation::ParticipantSpeeds&)> text) {
  return {head, whenChecked(std::move(text)), Qt::AlignHCenter, tip};
}

QString warningsOf(const SubjectRow& row) {
  QStringList lines;
  if (!row->failure.empty()) lines << text(row->failure);
  for (const std::string& warning : row->speeds.diagnostics.warnings) lines << text(warning);
  return lines.join(QLatin1Char('\n'));
}

/// Table 1 of the paper, live, with what the clusters say of each participant: a row for each participant and a column
/// for each level's mean and SD, then the agreement of clusters and levels.
std::vector<Column<SubjectRow>> speedColumns(const fuzzy::Variable& speed) {
  using Speeds = const elicitation::ParticipantSpeeds&;
  std::vector<Column<SubjectRow>> out;
  out.push_back({NumberPage::tr("Participant"), [](const SubjectRow& row) {
                   const QString who = text(row->speeds.participant);
                   return row->speeds.simulated ? NumberPage::tr("%1 (simulated)").arg(who) : who;
                 }});
  for (std::size_t i = 0; i < speed.terms.size(); ++i) {
    out.push_back(measure(NumberPage::tr("%1\nmean (SD)").arg(labelOf(speed.terms[i])), {}, [i](Speeds one) {
      const auto& found = one.diagnostics.levels;
      if (i >= found.size() || found[i].samples == 0) return kNoNumber;
      return NumberPage::tr("%1 (%2)").arg(fixed(found[i].mean_mm_s, 1), fixed(found[i].sd_mm_s, 1));
    }));
  }
  const auto compared = [](Speeds one, double elicitation::LevelConfusion::*value) {
    const auto& confusion = one.diagnostics.confusion;
    return confusion.counts.empty() ? kNoNumber : fixed(confusion.*value, 2);
  };
  out.push_back(
      measure(NumberPage::tr("Accuracy"),
              NumberPage::tr("Share of the samples whose cluster is that of the level asked for. Warns below 0.6."),
              [compared](Speeds one) { return compared(one, &elicitation::LevelConfusion::accuracy); }));
  out.push_back(
      measure(NumberPage::tr("Rand\nindex"),
              NumberPage::tr("Agreement of clusters and levels beyond chance; 1 is perfect. Warns below 0.3."),
              [compared](Speeds one) { return compared(one, &elicitation::LevelConfusion::adjusted_rand_index); }));
  out.push_back(measure(NumberPage::tr("Separation\nd′"),
                        NumberPage::tr("Difference of neighboring levels in standard deviations. Warns below 1."),
                        [](Speeds one) {
                          QStringList all;
                          for (const auto& each : one.diagnostics.separations) all << fixed(each, 2);
                          return all.isEmpty() ? kNoNumber : all.join(QStringLiteral(" · "));
                        }));
  out.push_back(
      measure(NumberPage::tr("Trend\np"),
              NumberPage::tr("Whether the means of the strokes rise with the level: Jonckheere-Terpstra, one-sided."),
              [](Speeds one) {
                const auto& trend = one.diagnostics.trend;
                if (!trend) return kNoNumber;
                return trend->p < 0.001 ? QStringLiteral("< 0.001") : fixed(trend->p, 3);
              }));
  out.push_back(measure(NumberPage::tr("Silhouette"),
                        NumberPage::tr("Fuzzy silhouette: near 1 the clusters are apart."),
                        [](Speeds one) { return fixed(one.validity.fuzzy_silhouette, 2); }));
  out.push_back(measure(NumberPage::tr("Xie-Beni"), NumberPage::tr("Xie-Beni index: smaller is better."),
                        [](Speeds one) { return fixed(one.validity.xie_beni, 3); }));
  out.push_back(
      measure(NumberPage::tr("Warnings"), NumberPage::tr("Point at a row to read its warnings."), [](Speeds one) {
        const auto& warnings = one.diagnostics.warnings;
        return warnings.empty() ? kNoNumber : NumberPage::tr("▲ %1").arg(warnings.size());
      }));
  out.back().roles[Qt::ForegroundRole] = [](const SubjectRow& row) {
    return row->speeds.diagnostics.warnings.empty() ? QVariant() : theme::warningInk();
  };
  return withRole<SubjectRow>(std::move(out), Qt::ToolTipRole, &warningsOf);
}

/// The objective J against the iteration. `traces` belong to the participants from `first` on.
Chart objectiveChart(const SpeedResult& result, const std::vector<ObjectiveTrace>& traces, std::size_t first) {
  const std::vector<std::size_t> numbers = subjectNumbers(result);
  fuzzy::Variable iterations;
  iterations.max = 1;
  double highest = 1;
  Chart chart;
  for (std::size_t i = 0; i < traces.size() && first + i < numbers.size(); ++i) {
    const std::vector<double>& objective = traces[i].objective;
    if (objective.empty() || !(objective.back() > 0)) continue;
    const QColor color = theme::expert(numbers[first + i]);
    ChartLine line{{}, {}, QPen(color, 1.8), {ChartDots::Shape::kDisc, 4}};
    for (std::size_t k = 0; k < objective.size(); ++k) {
      line.x << static_cast<double>(k);
      line.y << objective[k] / objective.back();
    }
    iterations.max = std::max(iterations.max, line.x.back());
    highest = std::max(highest, line.y.front());
    chart.parts.emplace_back(line);
  }
  chart.x = {.universe = iterations, .label = NumberPage::tr("Iteration of the textbook")};
  chart.y = {.universe = iterations, .label = NumberPage::tr("J / its minimum"), .round_ticks = true};
  chart.y.range = {1 - 0.05 * (highest - 1 + 0.01), 1 + 1.08 * (highest - 1 + 0.01)};
  return chart;
}

constexpr int kMostShortRows = 8;
constexpr qsizetype kMostWarnings = 30;  // lines; more are not read

/// A card with a heading and `content`.
Card* titled(const QString& title, QWidget* content, QWidget* parent) {
  auto* card = new Card(parent);
  auto* heading = new QLabel(title, card);
  heading->setFont(theme::headingFont());
  makeColumn(card, {heading, {content, 1}}, theme::kGrid / 2,
             {theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid});
  return card;
}

}  // namespace

NumberPage::NumberPage(SpeedLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      table_(new Columns<SubjectRow>(this)),
      view_(makeLabTable(*table_, -1, tr("Table 1: speeds of each participant at each level"), this)),
      warnings_(new QLabel(this)),
      objective_(new ChartView(this)) {
  objective_->setMinimumSize(220, 140);
  objective_->setAccessibleName(tr("Objective against iteration"));
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
  auto* refresh = new Refresh(this, [this] { refreshState(); });
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

void NumberPage::refreshState() {
  const auto& result = lab_.result();
  const int columns = table_->columnCount();
  auto heads = result ? speedColumns(result->speed) : std::vector<Column<SubjectRow>>();
  auto subjects = result ? result->subjects : std::vector<SubjectRow>();
  if (columns == static_cast<int>(heads.size())) {
    table_->updateRows(std::move(subjects));
  } else {
    table_->setTable(std::move(heads), std::move(subjects));
  }
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
  objective_->setChart(objectiveChart(*result, lab_.objectives(), lab_.shown().first));
}

}  // namespace tactus::workbench
