#include "app/workbench/tune/findings/finding_rows.h"

#include <QCoreApplication>
#include <QHash>
#include <algorithm>
#include <optional>

namespace tactus::workbench {
namespace {

using Kind = elicitation::RuleFinding::Kind;

struct FindingRowsText {
  Q_DECLARE_TR_FUNCTIONS(FindingRowsText)
};

QString countText(Kind kind, int n) {
  switch (kind) {
    case Kind::kHole:
      return FindingRowsText::tr("%n hole(s)", nullptr, n);
    case Kind::kAbstentionJump:
      return FindingRowsText::tr("%n jump(s) of the mean", nullptr, n);
    case Kind::kForceStep:
      return FindingRowsText::tr("%n step(s) of the force", nullptr, n);
    case Kind::kRegionWithoutRule:
      return FindingRowsText::tr("%n region(s) without a rule", nullptr, n);
    case Kind::kMissingItem:
      return FindingRowsText::tr("%n missing answer(s)", nullptr, n);
    case Kind::kConflict:
      return FindingRowsText::tr("%n conflict(s)", nullptr, n);
    case Kind::kExpertsApart:
      return FindingRowsText::tr("apart at %n place(s)", nullptr, n);
    case Kind::kAgainstDeclaration:
      return FindingRowsText::tr("%n step(s) against the declaration", nullptr, n);
    case Kind::kLevelJump:
      return FindingRowsText::tr("%n jump(s)", nullptr, n);
    case Kind::kDirectionChange:
      return FindingRowsText::tr("%n change(s) of direction", nullptr, n);
    case Kind::kDisagreement:
      return FindingRowsText::tr("%n disagreement(s)", nullptr, n);
    case Kind::kRedundantRule:
      return FindingRowsText::tr("%n redundant rule(s)", nullptr, n);
    case Kind::kUnreachableRule:
      return FindingRowsText::tr("%n rule(s) that never fire", nullptr, n);
    case Kind::kUnreachableTerm:
      return FindingRowsText::tr("%n unreachable term(s)", nullptr, n);
    case Kind::kUnusedTerm:
      return FindingRowsText::tr("%n unused term(s)", nullptr, n);
  }
  return {};
}

std::optional<double> mostNewtons(const std::vector<ShownFinding>& all, const std::vector<std::size_t>& group) {
  std::optional<double> most;
  for (const std::size_t finding : group) most = std::max(most, all[finding].finding.newtons);
  return most;
}

void sort(std::vector<std::size_t>& passing, const std::vector<ShownFinding>& all, FindingOrder order) {
  // Findings that are equal in the order stay in that of the newtons; those without a place come last.
  if (order == FindingOrder::kExpert) {
    std::stable_sort(passing.begin(), passing.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].who < all[b].who; });
  }
  if (order == FindingOrder::kPlace) {
    std::stable_sort(passing.begin(), passing.end(), [&](std::size_t a, std::size_t b) {
      const auto& one = all[a].along;
      const auto& other = all[b].along;
      return one && other ? *one < *other : one.has_value() && !other.has_value();
    });
  }
}

}  // namespace

QString groupKey(const ShownFinding& shown) {
  return QStringLiteral("%1\n%2\n%3\n%4")
      .arg(static_cast<int>(shown.finding.kind))
      .arg(static_cast<int>(shown.acceptance))
      .arg(shown.who, shown.step);
}

QString groupTitle(const ShownFinding& shown, std::size_t count) {
  const QString what = countText(shown.finding.kind, static_cast<int>(count));
  return shown.step.isEmpty() ? FindingRowsText::tr("%1: %2").arg(shown.who, what)
                              : FindingRowsText::tr("%1 · %2: %3").arg(shown.who, shown.step, what);
}

std::vector<FindingRow> findingRows(const std::vector<ShownFinding>& all, std::vector<std::size_t> passing,
                                    FindingOrder order, const QSet<QString>& unfolded) {
  sort(passing, all, order);
  QHash<QString, std::vector<std::size_t>> groups;
  for (const std::size_t finding : passing) groups[groupKey(all[finding])].push_back(finding);
  std::vector<FindingRow> rows;
  for (const std::size_t finding : passing) {
    const QString key = groupKey(all[finding]);
    const std::vector<std::size_t>& group = groups[key];
    if (group.size() < kSmallestGroup) {
      rows.push_back({finding});
    } else if (group.front() == finding) {
      const bool open = unfolded.contains(key);
      rows.push_back({finding, group.size(), false, open, mostNewtons(all, group)});
      if (!open) continue;
      for (const std::size_t member : group) rows.push_back({member, 0, true});
    }
  }
  return rows;
}

}  // namespace tactus::workbench
