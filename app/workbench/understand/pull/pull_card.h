// The card beside a curve that is pulled: where the force should go, how far one edit reaches, and the edits to choose
// from.
#pragma once

#include <QPoint>
#include <QPointer>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "app/workbench/understand/pull/pull_controller.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tactus::workbench {

class NumberBox;

/// Lives as long as the user chooses: of one model, one input on the x axis.
class PullCard : public Card {
  Q_OBJECT

 public:
  /// `references`: the curves that the force can be pulled to. `window` holds the card above all else.
  PullCard(PullController& pull, std::vector<PullWish> references, QWidget& window);

  /// To the right of `place`, or to its left, whichever has more room: px of the window.
  void moveBeside(QPoint place);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makePointRow();
  QWidget* makeBandRow();
  QWidget* makePinRow();
  void showPins();
  NumberBox* addBox(const fuzzy::Variable& variable);
  void onKindChosen(int index);
  void onNumberTyped();
  void adoptAnswer();
  void showWish();
  void listOffers();
  void showOffers();
  void fit();
  void makeEdit();

  PullController& pull_;
  std::vector<PullWish> references_;
  QWidget& window_;
  QPoint beside_;
  QComboBox* who_;
  QComboBox* kind_;
  QLabel* now_;
  NumberBox* wanted_ = nullptr;
  NumberBox* from_ = nullptr;
  NumberBox* to_ = nullptr;
  NumberBox* low_ = nullptr;
  NumberBox* high_ = nullptr;
  QWidget* point_row_;
  QWidget* band_row_;
  QLabel* sentence_;
  QVBoxLayout* offers_;
  QButtonGroup* choice_;
  QCheckBox* all_;
  QLabel* hint_;     ///< what the mean does not offer
  QLabel* warning_;  ///< locks and approvals
  QWidget* pin_row_;
  QLabel* pins_;
  QPushButton* take_;
  const PullAnswer* listed_ = nullptr;  ///< the answer in the list; only compared
};

}  // namespace tactus::workbench
