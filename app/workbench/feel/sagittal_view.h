// A schematic of nose, throat, esophagus and stomach with the tube at its depth. The region of the tip is highlighted.
// The regions are those of the model's depth terms.
#pragma once

#include <QVariantAnimation>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/feel/depth_regions.h"

namespace tactus::workbench {

class SagittalView : public QWidget {
  Q_OBJECT

 public:
  explicit SagittalView(QWidget* parent = nullptr);

  void setRegions(std::vector<DepthRegion> regions);
  /// Depth of the tip, mm.
  void setDepth(double depth_mm);
  /// The region of the tip; empty in front of the nose and outside all regions.
  QString regionText() const;
  /// Moves the head within one second, as the force changes.
  void setNeckFlexed(bool flexed);

  QSize sizeHint() const override { return {260, 300}; }
  QSize minimumSizeHint() const override { return {180, 112}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Label {
    QPointF at;  ///< on the passage
    double y = 0;
    QString text;
    bool lit = false;
  };
  double labelWidth() const;
  std::vector<Label> labels(const QTransform& to_widget, double line, double top, double bottom) const;
  void drawPassage(QPainter& painter, double from_mm, double to_mm, const QColor& color) const;
  std::optional<std::size_t> litRegion() const;
  void drawTube(QPainter& painter) const;

  std::vector<DepthRegion> regions_;
  double depth_mm_ = 0;
  std::optional<bool> flexed_;
  double flexion_ = 0;  ///< as drawn, [0, 1]
  QVariantAnimation turn_;
};

}  // namespace tactus::workbench
