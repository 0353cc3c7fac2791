// Withdrawal of a participant: what it deletes, said beforehand; the code, typed to confirm; what was done.
#pragma once

#include <QDialog>

#include "app/workbench/collect/collect_controller.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace tactus::workbench {

class WithdrawalDialog : public QDialog {
  Q_OBJECT

 public:
  /// `collect` outlives this. Asks for the preview at once.
  WithdrawalDialog(CollectController& collect, const study::RecordId& person, QWidget* parent = nullptr);

  /// What is deleted is counted.
  bool isCounted() const { return counted_; }

 private:
  void build();
  void showPreview(const store::WithdrawalPreview& preview);
  void showState();
  void fit();
  bool isConfirmed() const;

  CollectController& collect_;
  const study::RecordId person_;
  const QString code_;
  QLabel* title_;
  QLabel* text_;
  QGridLayout* counts_;
  QLabel* stays_;
  QLabel* ask_;
  QLineEdit* typed_;
  QLabel* trouble_;
  QPushButton* keep_;
  QPushButton* withdraw_;
  bool counted_ = false;
};

}  // namespace tactus::workbench
