// The panel with the one button of the stage Deliver: makes the bundle, shows how far it is, and what each file
// promises.
#pragma once

#include "app/workbench/deliver/bundle_maker.h"
#include "app/workbench/kit/cards.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTableView;

namespace tactus::workbench {

class ElidedLabel;
class ReadinessController;
class ReadinessSign;

class BundlePanel : public Card {
  Q_OBJECT

 public:
  BundlePanel(BundleMaker& maker, const ReadinessController& readiness, QWidget* parent = nullptr);

  /// Another way to deliver, below the bundle.
  void addBelow(QWidget* row);

 signals:
  /// The user wants a bundle; the receiver asks for the folder.
  void wanted();
  /// The user wants to read another bundle back; the receiver asks for its folder.
  void readBackWanted();

 private:
  QWidget* makeContents();
  QWidget* makeWork();
  QWidget* makeResult();
  void showState();
  void showResult();
  QString waitsFor() const;
  QString workText() const;
  void openFolder();
  void act();

  BundleMaker& maker_;
  const ReadinessController& readiness_;
  Columns<DeliveredFile> files_{deliveredColumns()};
  QPushButton* make_;
  QLabel* waits_for_;
  QStackedWidget* body_;
  QWidget* contents_ = nullptr;  ///< what a bundle holds, before the first one
  QWidget* work_ = nullptr;      ///< the work in progress
  QWidget* result_ = nullptr;
  QLabel* doing_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  ReadinessSign* sign_ = nullptr;
  QLabel* said_ = nullptr;
  ElidedLabel* folder_ = nullptr;
  QLabel* fingerprint_ = nullptr;
  QLabel* notes_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* act_ = nullptr;  ///< what helps where something went wrong
  QTableView* table_ = nullptr;
};

}  // namespace tactus::workbench
