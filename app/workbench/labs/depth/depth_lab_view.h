// Depth from an image on the screen: settings at the left, the image in the middle, the terms that follow at the right.
#pragma once

#include <QWidget>

#include "elicitation/depth/tube_path.h"

class QLabel;

namespace tactus::workbench {

class DepthCanvas;
class DepthLab;
class DepthTermPlot;

class DepthLabView : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit DepthLabView(DepthLab& lab, QWidget* parent = nullptr);

  DepthCanvas& canvas() { return *canvas_; }
  /// Loads the image file `path`; a failure is said.
  void load(const QString& path);
  /// Shows the program's own drawing.
  void showExample();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeTerms();
  void chooseImage();
  void askLength(const elicitation::ImagePoint& one, const elicitation::ImagePoint& other);
  void followImage();
  void followTerms();

  DepthLab& lab_;
  DepthCanvas* canvas_;
  DepthTermPlot* terms_;
  QLabel* numbers_;
};

}  // namespace tactus::workbench
