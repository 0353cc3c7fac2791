// The findings of the lint as a list: filtered by kind and expert, in the chosen order, and in groups that fold.
#pragma once

#include <QAbstractListModel>
#include <QSet>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/workbench/tune/findings/finding_rows.h"
#include "app/workbench/tune/findings/shown_finding.h"

namespace tactus::workbench {

class FindingsController;

class FindingsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit FindingsModel(const FindingsController& findings, QObject* parent = nullptr);

  /// Filters by kind; nothing: all kinds.
  void setKind(std::optional<elicitation::RuleFinding::Kind> kind);
  /// Filters by the text in ShownFinding::who; empty: all. A finding about two experts passes for each of them.
  void setWho(const QString& who);

  void setOrder(FindingOrder order);
  /// Folds a group or unfolds it; `row` is its heading.
  void fold(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  /// Qt::DisplayRole: the sentence; the whole finding comes from findingAt.
  QVariant data(const QModelIndex& index, int role) const override;

  const FindingRow& rowAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  bool isHeading(int row) const { return rowAt(row).members > 0; }
  /// `S2 · Nasopharynx → Oropharynx: 6 jumps`. `row` is a heading.
  QString titleAt(int row) const;
  /// Index of the finding in row `row` in FindingsController::findings.
  std::size_t indexAt(int row) const { return rowAt(row).finding; }
  const ShownFinding& findingAt(int row) const { return (*all_)[indexAt(row)]; }
  /// The row of a finding with that index, or of the heading of its folded group; -1 if it is filtered out.
  int rowOf(std::size_t index) const;

  /// Whether the rows show the controller's current findings. A hidden list may be old.
  bool isCurrent() const;
  /// Takes the controller's current findings.
  void adopt();

 private:
  bool passes(const ShownFinding& shown, const std::set<std::string>& experts) const;

  const FindingsController& findings_;
  std::optional<elicitation::RuleFinding::Kind> kind_;
  QString who_;
  FindingOrder order_ = FindingOrder::kNewtons;
  QSet<QString> unfolded_;                                ///< keys of groups
  std::shared_ptr<const std::vector<ShownFinding>> all_;  ///< null before the first `adopt`
  std::vector<FindingRow> rows_;
};

}  // namespace tactus::workbench
