// The speed lab on the screen: settings at the left; recordings, clusters and terms, numbers behind tabs.
#pragma once

#include <QWidget>

class QLabel;
class QTabWidget;
class QToolButton;

namespace tactus::workbench {

class Corrections;
class SpeedLab;
class StrokePage;

class SpeedLabView : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive this.
  SpeedLabView(SpeedLab& lab, Corrections& corrections, QWidget* parent = nullptr);

  /// The pages, for pictures of them.
  QTabWidget& pages() { return *pages_; }
  StrokePage& strokes() { return *strokes_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makePager();
  void follow();

  SpeedLab& lab_;
  StrokePage* strokes_;
  QTabWidget* pages_;
  QToolButton* back_;
  QToolButton* on_;
  QLabel* place_;
  QLabel* nothing_;
};

}  // namespace tactus::workbench
