// "Carry edits over": the edits of an earlier version, one by one with what each moves, to choose from.
#pragma once

#include <QDialog>

#include "app/workbench/base/columns.h"
#include "app/workbench/tune/history/carry_controller.h"

class QLabel;
class QModelIndex;
class QProgressBar;
class QPushButton;
class QTableView;

namespace tactus::workbench {

class PrimaryButton;
class WrappedLabel;

/// Beside the window, so that the curves show the edit under the mouse or the chosen row as a ghost.
class CarryDialog : public QDialog {
  Q_OBJECT

 public:
  explicit CarryDialog(CarryController& carry, QWidget* parent = nullptr);

  /// Shows the edits of the version `tuned`.
  void bringUp(editing::StateId tuned);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  std::vector<Column<CarryRow>> columns();
  QString priceText(const editing::EditImpact& price) const;
  QString headText() const;
  void showRows();
  void showDetail();
  void showBusy();
  void carryOver();
  std::optional<std::size_t> selected() const;

  CarryController& carry_;
  Columns<CarryRow> model_;
  QLabel* title_;
  QLabel* head_;
  QTableView* table_;
  WrappedLabel* detail_;
  QProgressBar* progress_;
  QPushButton* stop_;
  QLabel* sum_;
  QPushButton* all_;
  PrimaryButton* go_;
};

}  // namespace tactus::workbench
