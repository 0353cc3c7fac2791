// Corners of drawn terms that can be clicked: the mouse shows where, and a click tells which one it was.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>
#include <string>
#include <vector>

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

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

}  // namespace tactus::workbench
