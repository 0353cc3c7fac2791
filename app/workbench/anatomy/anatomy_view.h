// Head, throat, chest and stomach from the side with the tube at its depth: the picture of the default procedure on the
// bench and on the nurse's screens.
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
#include "app/workbench/anatomy/body_view.h"

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
  double most_y = 1e9;   ///< px, its top stands no lower
};

/// Draws the plates into `area` at their edges, in the order of their places, without overlap, in the font of
/// `painter`.
void drawPlates(QPainter& painter, const QRectF& area, std::vector<PlateName> names);

/// A name at a structure.
struct NamedStructure {
  Structure structure;
  QString name;
};

class AnatomyView : public BodyView {
  Q_OBJECT

 public:
  explicit AnatomyView(QWidget* parent = nullptr);
  AnatomyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent);

  Posture posture() const { return posture_; }
  /// The neck takes `posture` at once, or within a second if `gently`.
  void setPosture(Posture posture, bool gently = false);
  void setFraming(Framing framing);
  /// Lights `region`; its name is in the language of the screen.
  void light(Region region, const QString& name);
  void setNames(std::vector<NamedStructure> names);

  void setPose(const study::ItemCondition& condition) override;
  /// Head to the right.
  void setMirrored(bool mirrored) override;
  void setDepth(std::optional<double> depth_mm) override;
  void light(const std::optional<LitRange>& range) override;
  void lightRegion(const QString& id) override;
  void showNames() override;
  /// With the tube in the stomach.
  void showWhole() override;

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
