#include "app/workbench/labs/rules/finding_table.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

using elicitation::RuleFinding;
using Kind = RuleFinding::Kind;

QString kindText(Kind kind) {
  switch (kind) {
    case Kind::kHole:
      return FindingTable::tr("No rule fires");
    case Kind::kAbstentionJump:
      return FindingTable::tr("An expert falls silent");
    case Kind::kForceStep:
      return FindingTable::tr("Step of the force");
    case Kind::kRegionWithoutRule:
      return FindingTable::tr("Region without a rule");
    case Kind::kMissingItem:
      return FindingTable::tr("Item without an answer");
    case Kind::kConflict:
      return FindingTable::tr("Two answers to one item");
    case Kind::kExpertsApart:
      return FindingTable::tr("Experts far apart");
    case Kind::kAgainstDeclaration:
      return FindingTable::tr("Against the declared direction");
    case Kind::kLevelJump:
      return FindingTable::tr("Neighboring answers far apart");
    case Kind::kDirectionChange:
      return FindingTable::tr("Against the expert's own direction");
    case Kind::kDisagreement:
      return FindingTable::tr("Experts disagree on a direction");
    case Kind::kRedundantRule:
      return FindingTable::tr("Redundant rule");
    case Kind::kUnreachableRule:
      return FindingTable::tr("Rule that never fires");
    case Kind::kUnreachableTerm:
      return FindingTable::tr("Term out of reach");
    case Kind::kUnusedTerm:
      return FindingTable::tr("Term without a rule");
  }
  return {};
}

QString expertsText(const RuleFinding& finding) {
  if (finding.experts.empty()) return FindingTable::tr("Mean");
  QStringList names;
  for (const std::string& one : finding.experts) names << harmless(text(one));
  return names.join(QStringLiteral(", "));
}

}  // namespace

void FindingTable::setFindings(const std::vector<RuleFinding>& findings, const std::string& unit) {
  beginResetModel();
  findings_ = findings;
  unit_ = unit;
  const auto newtons = [this](std::size_t i) { return findings_[i].newtons.value_or(-1); };
  std::map<Kind, std::pair<double, std::size_t>> groups;  // largest newtons and members
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    auto& [largest, members] = groups.try_emplace(findings_[i].kind, -1.0, 0U).first->second;
    largest = std::max(largest, newtons(i));
    ++members;
  }
  std::vector<std::size_t> order(findings_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const Kind kind = findings_[i].kind;
    return std::tuple(-groups.at(kind).first, kind, -newtons(i));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  rows_.clear();
  for (const std::size_t i : order) {
    const bool first = rows_.empty() || findings_[rows_.back().finding].kind != findings_[i].kind;
    rows_.push_back({i, first ? groups.at(findings_[i].kind).second : 0});
  }
  endResetModel();
}

int FindingTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant FindingTable::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const RuleFinding& finding = findings_[row.finding];
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((index.column() == kNewtons ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole) return text(finding.text);
  if (role == Qt::ForegroundRole && index.column() == kKind) return theme::ink();
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kKind:
      return row.group == 0 ? QString() : QStringLiteral("%1 (%2)").arg(kindText(finding.kind)).arg(row.group);
    case kNewtons:
      if (!finding.newtons) return QStringLiteral("–");
      return (finding.at_least ? QStringLiteral("≥ ") : QString()) + quantityText(*finding.newtons, unit_, 3);
    case kExperts:
      return expertsText(finding);
    default:
      return text(finding.text);
  }
}

QVariant FindingTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((section == kNewtons ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kKind:
      return tr("Kind");
    case kNewtons:
      return tr("At stake");
    case kExperts:
      return tr("Experts");
    default:
      return tr("What is found; a click leads to the cell");
  }
}

}  // namespace tactus::workbench
