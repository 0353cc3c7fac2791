// Marks over a plot: the reading place, the current value, corners of terms to click.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/plot/plot_style.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

/// Corners of drawn terms that can be clicked: the mouse shows where, and a click tells which one it was.
class VertexPick : public QObject {
  Q_OBJECT

 public:
  struct Vertex {
    std::string term;
    std::size_t point = 0;  ///< index in Term::points
    double x = 0;           ///< in the axes' units
    double membership = 0;
  };

  /// `plot` owns this. `what`: the tool tip of a corner, e.g. `Where does this corner come from?`
  VertexPick(QCustomPlot& plot, const QString& what);

  void setVertices(std::vector<Vertex> vertices) { vertices_ = std::move(vertices); }
  /// The place of a vertex on the plot, px.
  QPointF pixelOf(const Vertex& vertex) const;
  const std::vector<Vertex>& vertices() const { return vertices_; }

 signals:
  void picked(const std::string& term, std::size_t point);

 private:
  std::optional<std::size_t> at(const QPointF& place) const;
  void onMove(QMouseEvent* event);
  void onRelease(QMouseEvent* event);

  QCustomPlot& plot_;
  QString what_;
  std::vector<Vertex> vertices_;
};

/// The current value in a membership plot: a line, and a dot at each membership. Needs QCustomPlot: only plotting code
/// includes this.
class ValueMarker : public QCPLayerable {
  Q_OBJECT

 public:
  explicit ValueMarker(QCustomPlot& plot);

  void set(std::optional<double> value, std::vector<double> memberships);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  std::optional<double> value_;
  std::vector<double> memberships_;
};

/// The reading place in the curve plot: a line, a dot on every curve, and a tag. Needs QCustomPlot: only plotting code
/// includes this.
class ReadingCursor : public QCPLayerable {
  Q_OBJECT

 public:
  struct Dot {
    double force_n = 0;
    QColor color;
  };

  explicit ReadingCursor(QCustomPlot& plot);

  void set(double x, QString tag, std::vector<Dot> dots);
  /// Gives the dots their colors in another look.
  void takeLook();
  /// The other place from which differences are counted: a dashed line; nothing: none.
  void setFrom(std::optional<double> x) { from_ = x; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  class Dots;

  double x_ = 0;
  std::optional<double> from_;
  QString tag_;
  std::vector<Dot> dots_;
  QFont font_;
};

}  // namespace tactus::workbench
