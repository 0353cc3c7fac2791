// The rows in which the findings are listed: in a chosen order, and findings of one kind about the same thing as a
// group that folds:
//   S2 · Nasopharynx → Oropharynx: 6 jumps
#pragma once

#include <QSet>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/workbench/tune/findings/shown_finding.h"

namespace tactus::workbench {

enum class FindingOrder { kNewtons, kExpert, kPlace };

/// So many findings about one thing make a group; fewer are read as fast one by one.
inline constexpr std::size_t kSmallestGroup = 3;

struct FindingRow {
  std::size_t finding = 0;             ///< index; of a heading: its first finding
  std::size_t members = 0;             ///< of a heading: how many findings it stands for; 0 for a finding
  bool in_group = false;               ///< a finding below its heading
  bool unfolded = false;               ///< of a heading
  std::optional<double> newtons = {};  ///< of a heading: the largest of its findings
};

/// What a finding has in common with those of its group.
QString groupKey(const ShownFinding& shown);
/// The heading of a group of `count` findings like `shown`.
QString groupTitle(const ShownFinding& shown, std::size_t count);

/// `passing`: the indices in `all` to list, in the order of the newtons. `unfolded`: the keys of groups whose findings
/// are listed below their heading.
std::vector<FindingRow> findingRows(const std::vector<ShownFinding>& all, std::vector<std::size_t> passing,
                                    FindingOrder order, const QSet<QString>& unfolded);

}  // namespace tactus::workbench
