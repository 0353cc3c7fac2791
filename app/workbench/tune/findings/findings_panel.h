// The panel of the lint's findings: largest force first, with filters and one-click fixes.
#pragma once

#include "app/workbench/kit/cards.h"
#include "app/workbench/tune/findings/findings_model.h"

class QComboBox;
class QLabel;
class QListView;
class QStackedWidget;

namespace tactus::workbench {

class ElidedLabel;
class FindingDelegate;
class FindingsController;

class FindingsPanel : public Card {
  Q_OBJECT

 public:
  explicit FindingsPanel(FindingsController& findings, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void adopt();
  void fillFilters();
  void showChosen();
  void showState();
  void fold(int row);
  QString stateText() const;
  QString emptyText() const;
  QString rangeText() const;

  FindingsController& findings_;
  FindingsModel model_;
  FindingDelegate* delegate_;
  QComboBox* kind_;
  QComboBox* who_;
  QComboBox* order_;
  ElidedLabel* state_;
  QListView* list_;
  QLabel* empty_;
  QStackedWidget* body_;
  ElidedLabel* range_;
};

}  // namespace tactus::workbench
