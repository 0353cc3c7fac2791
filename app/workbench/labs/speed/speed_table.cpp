#include "app/workbench/labs/speed/speed_table.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
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
    case kAccuracy:
      return compared ? fixed(found.confusion.accuracy, 2) : QStringLiteral("–");
    case kRand:
      return compared ? fixed(found.confusion.adjusted_rand_index, 2) : QStringLiteral("–");
    case kSeparation: {
      QStringList all;
      for (const auto& one : found.separations) all << fixed(one, 2);
      return all.isEmpty() ? QStringLiteral("–") : all.join(QStringLiteral(" · "));
    }
    case kTrend:
      if (!found.trend) return QStringLiteral("–");
      return found.trend->p < 0.001 ? QStringLiteral("< 0.001") : fixed(found.trend->p, 3);
    case kSilhouette:
      return fixed(subject.speeds.validity.fuzzy_silhouette, 2);
    case kXieBeni:
      return fixed(subject.speeds.validity.xie_beni, 3);
    default:
      return found.warnings.empty() ? QStringLiteral("–") : tr("▲ %1").arg(found.warnings.size());
  }
}

}  // namespace tactus::workbench
