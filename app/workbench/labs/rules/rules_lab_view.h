// The rules lab on the screen: the grids, and below them the chosen cell, the agreement and the usability scale.
#pragma once

#include <QWidget>

class QLabel;
class QTabWidget;
class QTableView;

namespace tactus::workbench {

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
