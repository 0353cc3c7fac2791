// The speed lab on the screen: settings at the left; recordings, clusters and terms, numbers behind tabs.
#pragma once

#include <QWidget>

#include "elicitation/tracing/sources.h"

class QLabel;
class QTabWidget;
class QToolButton;

namespace tactus::workbench {

class Corrections;
class LabModel;
class SpeedLab;
class SpeedTermPlot;
class StrokePage;

class SpeedLabView : public QWidget {
  Q_OBJECT

 public:
  /// All outlive this.
  SpeedLabView(SpeedLab& lab, LabModel& model, Corrections& corrections, QWidget* parent = nullptr);

  /// Turns to the strokes, with this one chosen.
  void showStroke(const elicitation::StrokeKey& stroke);
  SpeedTermPlot& terms() { return *terms_; }

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
  SpeedTermPlot* terms_;
  StrokePage* strokes_;
  QTabWidget* pages_;
  QToolButton* back_;
  QToolButton* on_;
  QLabel* place_;
  QLabel* nothing_;
};

}  // namespace tactus::workbench
