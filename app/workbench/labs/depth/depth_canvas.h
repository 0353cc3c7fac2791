// The sagittal image with the tube's way and the boundaries of the regions on it (paper, Fig. 4). A click adds a point
// of the way, dragging moves points and boundaries, the wheel zooms, dragging with the right button moves the image.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "elicitation/depth/tube_path.h"

namespace tactus::workbench {

class DepthLab;

class DepthCanvas : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit DepthCanvas(DepthLab& lab, QWidget* parent = nullptr);

  void setImage(const QImage& image);
  const QImage& image() const { return image_; }
  /// The next two clicks are the ends of a line of known length.
  void measureLength();
  bool isMeasuring() const { return measuring_; }
  /// The place of an image's point on the screen, px.
  QPointF onScreen(const elicitation::ImagePoint& point) const;

  QSize sizeHint() const override { return {520, 560}; }
  QSize minimumSizeHint() const override { return {240, 240}; }

 public slots:
  void zoomToAll();

 signals:
  /// Both ends of a line of known length are there.
  void lineMeasured(const tactus::elicitation::ImagePoint& one, const tactus::elicitation::ImagePoint& other);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// A point of the way, or a boundary.
  struct Grip {
    bool boundary;
    std::size_t index;

    bool operator==(const Grip&) const = default;
  };
  elicitation::ImagePoint onImage(const QPointF& place) const;
  std::optional<Grip> gripAt(const QPointF& place) const;
  void addPoint(const QPointF& place);
  void move(const Grip& grip, const QPointF& place);
  void paintPath(QPainter& painter) const;
  void paintBoundaries(QPainter& painter) const;
  QString gripName(const Grip& grip) const;

  DepthLab& lab_;
  QImage image_;
  double zoom_ = 1;     ///< px of the screen for one of the image
  QPointF origin_;      ///< where the image's corner is on the screen
  bool fitted_ = true;  ///< the whole image is shown, also after a change of the size
  std::optional<Grip> held_;
  std::optional<Grip> chosen_;  ///< the point that Del removes
  std::optional<QPointF> pan_;
  bool measuring_ = false;
  std::optional<elicitation::ImagePoint> line_begin_;
  QPointF mouse_;
};

}  // namespace tactus::workbench
