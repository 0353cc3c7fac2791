// The rules lab on the screen: the grids, and below them the chosen cell, the agreement and the usability scale.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/rules/expert_grids.h"
#include "app/workbench/labs/rules/rules_lab.h"

class QLabel;
class QTabWidget;
class QTableView;

namespace tactus::workbench {

/// What the differences in the chosen cell cost, in two or three sentences; empty if no cell is chosen.
QString cellSummary(const RulesLab& lab);

/// What an expert says and would feel in the chosen cell.
struct CellRow {
  std::size_t index = 0;   ///< of the expert
  std::size_t number = 0;  ///< of the color
  QString expert;
  QString word;
  std::optional<std::size_t> term;
  std::optional<double> felt_n;
  std::optional<double> from_mean_n;
  QString source;
};

/// A finding about the experts' rules, grouped by kind.
struct RuleFindingRow {
  std::size_t index = 0;  ///< in RulesLab::findings
  QString kind;           ///< with the findings of the group, in its first row; else empty
  QString newtons, who, sentence;
};

class ElidedLabel;
class GridsView;

class RulesLabView : public LabView {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit RulesLabView(RulesLab& lab, QWidget* parent = nullptr);

  GridsView& grids() { return *grids_; }
  QTabWidget& details() { return *details_; }

 private:
  QWidget* makeCell();
  QWidget* makeUsability();
  QWidget* makeFindings();
  void refreshState();
  void followCell();

  RulesLab& lab_;
  GridsView* grids_;
  QLabel* spread_;
  Columns<CellRow>* cell_;
  QTableView* experts_ = nullptr;  ///< of the chosen cell
  QLabel* cell_title_;
  QLabel* cell_summary_;
  Columns<RuleFindingRow>* findings_;
  ElidedLabel* findings_note_;
  Columns<AgreementRow>* agreement_;
  Columns<UsabilityRow>* usability_;
  ElidedLabel* usability_note_;
  QTabWidget* details_;
};

}  // namespace tactus::workbench
