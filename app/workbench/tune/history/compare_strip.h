// The strip above the panels that names the version shown and felt during a comparison; otherwise hidden.
#pragma once

#include <QWidget>

#include "app/workbench/kit/cards.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

class CompareController;
class ElidedLabel;
class RecoveryController;

// Offers the work that a crash left behind: restore, discard, or later.

class RecoveryStrip : public Card {
  Q_OBJECT

 public:
  explicit RecoveryStrip(RecoveryController& recovery, QWidget* parent = nullptr);

 signals:
  void restoreRequested();

 private:
  void showOffer();

  RecoveryController& recovery_;
  QLabel* label_;
  QPushButton* restore_;
  QPushButton* discard_;
  QPushButton* later_;
};

// The switch between A and B. One button is pressed during a comparison, none otherwise.

enum class CompareSide;

class CompareSwitch : public QWidget {
  Q_OBJECT

 public:
  explicit CompareSwitch(CompareController& compare, QWidget* parent = nullptr);

 private:
  void showSide();
  QToolButton* addButton(const QString& letter, CompareSide side);

  CompareController& compare_;
  QToolButton* a_;
  QToolButton* b_;
};

class CompareStrip : public Card {
  Q_OBJECT

 public:
  explicit CompareStrip(CompareController& compare, QWidget* parent = nullptr);

  /// Whether the shown model is also felt on a device.
  void setFelt(bool felt);

 private:
  void showState();

  CompareController& compare_;
  ElidedLabel* shown_;
  ElidedLabel* other_;
  QToolButton* end_;
  bool felt_ = false;
};

}  // namespace tactus::workbench
