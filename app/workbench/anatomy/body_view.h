// The picture of the body with the tool on its way, whatever the procedure: what each screen asks of it, and which view
// draws it.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/procedure/procedure.h"

class QPainter;

namespace tactus::workbench::anatomy {

/// A part of the way, mm.
struct WayRange {
  double from_mm = 0;
  double to_mm = 0;
  double middleMm() const { return (from_mm + to_mm) / 2; }
  bool operator==(const WayRange&) const = default;
};

/// Where the region with the id `region` lies: from the middle of its overlap with the one before to that with the
/// next, in the first set of regions that has it. Nothing for an unknown id.
std::optional<WayRange> rangeOf(const procedure::Procedure& procedure, const std::string& region);

/// Whether a picture of the body shows the words of `input` as poses.
bool showsPose(const procedure::Procedure& procedure, const std::string& input);

// What every view draws alike.

inline constexpr QColor kLit(0xFF, 0xC2, 0x47);
inline constexpr QColor kLitEdge(0x6B, 0x45, 0x00);

/// The tool through `points`, px, `width` wide and at least as wide as is seen, with its tip, of at least the radius
/// `least_tip`, at the last one.
void drawTool(QPainter& painter, const std::vector<QPointF>& points, double width, double least_tip = 7);

inline constexpr double kPlatePadding = 0.4;  // of a line

/// A name to show in a picture.
struct PlateName {
  QString text;
  QPointF at;            ///< what it names, px
  bool on_left = false;  ///< the edge of the picture at which it stands
  bool lit = false;      ///< bold
  double least_y = 0;    ///< px, the plate stands no higher
  double most_y = 1e9;   ///< px, its top stands no lower
};

/// Draws the names on plates into `area`, each with a line to its place, at their edges, in the order of their places,
/// without overlap, in the font of `painter`.
void drawPlates(QPainter& painter, const QRectF& area, std::vector<PlateName> names);

/// A part of the way to light: amber, a dark outline and its name.
struct LitRange {
  double from_mm = 0;
  double to_mm = 0;
  QString name;
  bool operator==(const LitRange&) const = default;
};

struct RegionName {
  QString id;
  QString name;
  bool operator==(const RegionName&) const = default;
};

/// The names are in the font of the widget.
class BodyView : public QWidget {
  Q_OBJECT

 public:
  BodyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent);

  const procedure::Procedure& about() const { return *about_; }

  /// The body as the condition has it, at once, or within a second if `gently`; the usual pose if no picture shows it.
  virtual void setPose(const study::ItemCondition& condition, bool gently = false) = 0;
  /// The condition that is shown; empty for the usual pose.
  virtual study::ItemCondition pose() const { return {}; }
  /// The other way round, for left hands. Names are never mirrored.
  virtual void setMirrored(bool mirrored) = 0;
  /// Depth of the tip, mm; nothing: no tool. It is drawn with the next frame, never by itself.
  virtual void setDepth(std::optional<double> depth_mm) = 0;
  /// Lights any part of the way.
  virtual void light(const std::optional<LitRange>& range) = 0;
  /// Lights the region, with its name, and brings it near; an empty or unknown id: none.
  virtual void lightRegion(const QString& id) = 0;
  /// The names of all regions are shown.
  virtual void showNames() = 0;
  /// The whole body, with the tool at the end of its way.
  virtual void showWhole() = 0;

  /// The tip is in the middle of the region.
  void showTipIn(const QString& region);
  /// In the language of the screen, in the order of the way. To be given before they are shown.
  virtual void setRegionNames(std::vector<RegionName> names);

 protected:
  const std::vector<RegionName>& regionNames() const { return names_; }
  QString nameOf(const QString& region) const;
  /// No pixel tells the depths apart.
  static bool isSame(const std::optional<double>& depth_mm, const std::optional<double>& other_mm);

 private:
  std::shared_ptr<const procedure::Procedure> about_;
  std::vector<RegionName> names_;
};

/// A force that is felt, as pictures show it.
struct FeltForce {
  QString text;  ///< number and word
  QColor color;  ///< of the word
  bool operator==(const FeltForce&) const = default;
};

/// The body in three dimensions: from the side, from the front, and as the user turns it. Nothing is computed before it
/// is painted.
class SolidView : public QWidget {
  Q_OBJECT

 public:
  explicit SolidView(QWidget* parent);
  ~SolidView() override;

  /// Why there is no such view of the procedure, in one sentence; empty if there is one.
  static QString missing(const procedure::Procedure* about);

  void setAbout(std::shared_ptr<const procedure::Procedure> about);
  void setPose(const study::ItemCondition& condition);
  /// Depth of the tip, mm.
  void setDepth(double depth_mm);
  /// Lights a part of the way.
  void light(const std::optional<LitRange>& range);
  void setFelt(const std::optional<FeltForce>& felt);

  QSize sizeHint() const override { return {320, 400}; }
  QSize minimumSizeHint() const override { return {120, 112}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  class Scene;

  void turn(double yaw_deg, double pitch_deg);
  void turnBack();
  void drawNotes(QPainter& painter) const;

  std::shared_ptr<const procedure::Procedure> about_;
  study::ItemCondition pose_;
  std::unique_ptr<Scene> scene_;  ///< none before the first painting
  double depth_mm_ = 0;
  std::optional<LitRange> lit_;
  std::optional<FeltForce> felt_;
  QPointF dragged_from_;
};

/// The body from another side, beside a picture of it: another view of a pack.
class InsetView : public QWidget {
  Q_OBJECT

 public:
  /// `svg`: the file.
  explicit InsetView(QByteArray svg, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {160, 240}; }
  QSize minimumSizeHint() const override { return {64, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QByteArray svg_;
  QPixmap drawing_;  ///< at the current size
};

/// The view of the procedure: its pictures; a plain bar of regions if it has none.
BodyView* makeBodyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent);

}  // namespace tactus::workbench::anatomy
