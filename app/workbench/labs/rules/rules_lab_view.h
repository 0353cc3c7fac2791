// The rules lab on the screen: the grids, and below them the chosen cell, the agreement and the usability scale.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/frame/lab_table_model.h"
#include "app/workbench/labs/rules/expert_grids.h"
#include "app/workbench/labs/rules/rules_lab.h"

class QLabel;
class QTabWidget;
class QTableView;

namespace tactus::workbench {

/// What each expert says and would feel in the chosen cell, as an item model.
class CellTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kExpert, kWord, kFelt, kFromMean, kWithout, kSource };
  static constexpr int kOrderRole = Qt::UserRole;  ///< what a column is sorted by

  /// `lab` outlives this.
  explicit CellTable(const RulesLab& lab, QObject* parent = nullptr);

  /// Shows the chosen cell of the lab.
  void follow();
  /// Shows what the rules of the chosen cell move.
  void followInfluences();

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;
  QVariant orderOf(std::size_t row, int column) const;
  QString withoutText(std::size_t row) const;

  struct Row {
    QString expert;
    std::size_t number = 0;
    QString word;
    std::optional<std::size_t> term;
    std::optional<double> felt_n;
    QString source;
  };

  const RulesLab& lab_;
  std::vector<Row> rows_;
  std::optional<double> mean_n_;  ///< of the felt forces
};

/// What the differences in the chosen cell cost, in two or three sentences; empty if no cell is chosen.
QString cellSummary(const RulesLab& lab);

/// The findings about the experts' rules as an item model: grouped by kind, the group with the most newtons first.
class FindingTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kKind, kNewtons, kExperts, kSentence };

  explicit FindingTable(QObject* parent = nullptr);

  /// `unit`: of the force.
  void setFindings(const std::vector<WordedFinding>& findings, const std::string& unit);
  /// The finding of a row, as an index of what was set.
  std::size_t findingAt(int row) const { return rows_[static_cast<std::size_t>(row)].finding; }

 private:
  int rows() const override;
  QVariant cell(int row, int column, int role) const override;

  struct Row {
    std::size_t finding = 0;
    std::size_t group = 0;  ///< findings of the group, in its first row; else 0
  };

  std::vector<WordedFinding> findings_;
  std::string unit_;
  std::vector<Row> rows_;
};

class AgreementTable;
class CellTable;
class ElidedLabel;
class FindingTable;
class GridsView;
class RulesLab;
class UsabilityTable;

class RulesLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit RulesLabView(RulesLab& lab, QWidget* parent = nullptr);

  GridsView& grids() { return *grids_; }
  QTabWidget& details() { return *details_; }
  const FindingTable& findings() const { return *findings_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeCell();
  QWidget* makeUsability();
  QWidget* makeFindings();
  void follow();
  void followCell();

  RulesLab& lab_;
  GridsView* grids_;
  QLabel* spread_;
  CellTable* cell_;
  QTableView* experts_ = nullptr;  ///< of the chosen cell
  QLabel* cell_title_;
  QLabel* cell_summary_;
  FindingTable* findings_;
  ElidedLabel* findings_note_;
  AgreementTable* agreement_;
  UsabilityTable* usability_;
  ElidedLabel* usability_note_;
  QTabWidget* details_;
};

}  // namespace tactus::workbench
