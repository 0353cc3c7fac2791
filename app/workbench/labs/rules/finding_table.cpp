#include "app/workbench/labs/rules/finding_table.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/finding_words.h"

namespace tactus::workbench {
namespace {

using Kind = elicitation::RuleFinding::Kind;

}  // namespace

FindingTable::FindingTable(QObject* parent)
    : LabTableModel({{tr("Kind")},
                     {tr("At stake"), Qt::AlignRight},
                     {tr("Experts")},
                     {tr("What is found; a click leads to the cell")}},
                    parent) {}

void FindingTable::setFindings(const std::vector<WordedFinding>& findings, const std::string& unit) {
  beginResetModel();
  findings_ = findings;
  unit_ = unit;
  const auto newtons = [this](std::size_t i) { return findings_[i].finding.newtons.value_or(-1); };
  std::map<Kind, std::pair<double, std::size_t>> groups;  // largest newtons and members
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    auto& [largest, members] = groups.try_emplace(findings_[i].finding.kind, -1.0, 0U).first->second;
    largest = std::max(largest, newtons(i));
    ++members;
  }
  std::vector<std::size_t> order(findings_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const Kind kind = findings_[i].finding.kind;
    return std::tuple(-groups.at(kind).first, kind, -newtons(i));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  rows_.clear();
  for (const std::size_t i : order) {
    const bool first = rows_.empty() || findings_[rows_.back().finding].finding.kind != findings_[i].finding.kind;
    rows_.push_back({i, first ? groups.at(findings_[i].finding.kind).second : 0});
  }
  endResetModel();
}

int FindingTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant FindingTable::cell(int row, int column, int role) const {
  const Row& at = rows_[static_cast<std::size_t>(row)];
  const WordedFinding& worded = findings_[at.finding];
  const elicitation::RuleFinding& finding = worded.finding;
  if (role == Qt::ToolTipRole) return worded.sentence;
  if (role == Qt::ForegroundRole && column == kKind) return theme::ink();
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kKind:
      return at.group == 0 ? QString() : QStringLiteral("%1 (%2)").arg(kindText(finding.kind)).arg(at.group);
    case kNewtons:
      if (!finding.newtons) return QStringLiteral("–");
      return (finding.at_least ? QStringLiteral("≥ ") : QString()) + quantityText(*finding.newtons, unit_, 3);
    case kExperts:
      return worded.who;
    default:
      return worded.sentence;
  }
}

}  // namespace tactus::workbench
