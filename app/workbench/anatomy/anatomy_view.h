// Head, throat, chest and stomach from the side with the tube at its depth: the picture of the bench and of the nurse's
// screens. Its font is that of the widget.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <QVariantAnimation>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/anatomy/anatomy.h"
#include "app/workbench/anatomy/anatomy_drawing.h"

class QPainter;

namespace tactus::workbench::anatomy {

// Names beside a picture, each on a plate with a line to its place.

/// A name to show in a picture.
struct PlateName {
  QString text;
  QPointF at;            ///< what it names, px
  bool on_left = false;  ///< the edge of the picture at which it stands
  bool lit = false;      ///< bold
  double least_y = 0;    ///< px, the plate stands no higher
};

/// Draws the plates into `area` at their edges, in the order of their places, without overlap, in the font of
/// `painter`.
void drawPlates(QPainter& painter, const QRectF& area, std::vector<PlateName> names);

/// A part of the path to light: amber, a dark outline and its name.
struct LitRange {
  double from_mm = 0;
  double to_mm = 0;
  QString name;
  bool operator==(const LitRange&) const = default;
};

/// A name at a structure.
struct NamedStructure {
  Structure structure;
  QString name;
};

class AnatomyView : public QWidget {
  Q_OBJECT

 public:
  explicit AnatomyView(QWidget* parent = nullptr);

  Posture posture() const { return posture_; }
  /// The neck takes `posture` at once, or within a second if `gently`.
  void setPosture(Posture posture, bool gently = false);
  void setFraming(Framing framing);
  /// Head to the right, for left hands. Names are never mirrored.
  void setMirrored(bool mirrored);
  /// Depth of the tip, mm; nothing: no tube. The tube is drawn with the next frame, never by itself.
  void setDepth(std::optional<double> depth_mm);
  /// Lights `region`; its name is in the language of the screen.
  void light(Region region, const QString& name);
  /// Lights any part of the path.
  void light(const std::optional<LitRange>& range);
  void setNames(std::vector<NamedStructure> names);

  QSize sizeHint() const override { return {320, 400}; }
  QSize minimumSizeHint() const override { return {120, 112}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double flexionDeg() const;
  QTransform toWidget() const;
  QPainterPath litPath() const;
  void drawPicture(QPainter& painter);
  void drawTube(QPainter& painter, const QTransform& to_widget) const;
  std::vector<PlateName> plateNames(const QTransform& to_widget) const;
  double radius() const;

  AnatomyDrawing drawing_;
  TubeWay way_{0};
  Posture posture_ = Posture::kUpright;
  Posture posture_before_ = Posture::kUpright;
  double turned_ = 1;  ///< how much of the turn from the posture before is done, [0, 1]
  QVariantAnimation turn_;
  Framing framing_ = Framing::kHeadAndNeck;
  bool mirrored_ = false;
  std::optional<double> depth_mm_;
  std::optional<LitRange> lit_;
  QPainterPath lit_path_;  ///< mm
  std::vector<NamedStructure> names_;
};

}  // namespace tactus::workbench::anatomy
