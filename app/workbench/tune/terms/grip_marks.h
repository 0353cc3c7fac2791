// The handles of the membership function editor: dots to drag, bold lines for the moving part, and a tag that names it.
// Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/plot/plot_style.h"
#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {

class GripMarks : public QCPLayerable {
  Q_OBJECT

 public:
  /// A dot of the editor.
  struct Handle {
    double x = 0;
    double membership = 0;
    QColor color;
    bool large = false;  ///< of the selected term
    bool locked = false;
    bool moves = false;  ///< moves with the dragged part or the part under the mouse
  };
  /// A line along the moving part of a shape, between two places.
  struct Line {
    double from_x = 0, from_membership = 0;
    double to_x = 0, to_membership = 0;
  };

  /// `layer` must have its own buffer, so that the handles follow the mouse without drawing the shapes again.
  GripMarks(QCustomPlot& plot, const QString& layer);

  void setHandles(std::vector<Handle> handles);
  void setLines(std::vector<Line> lines);
  /// Shows `text` beside the place (x, membership); empty: no tag. `warns`: the tag gives the reason why a part cannot
  /// move.
  void setTag(const QString& text, double x, double membership, bool warns);
  /// The universe on the x axis. The plot area beyond it is shaded.
  void setUniverse(double min, double max);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
  /// The plot area and room for a handle at its edge: of a part of the universe, what lies beside it is hidden.
  QRect clipRect() const override;

 private:
  QPointF pixelOf(double x, double membership) const;
  void drawHandle(QCPPainter& painter, const Handle& handle) const;
  void drawTag(QCPPainter& painter) const;

  std::vector<Handle> handles_;
  std::vector<Line> lines_;
  QString tag_;
  double tag_x_ = 0;
  double tag_membership_ = 0;
  bool tag_warns_ = false;
  double min_ = 0;
  double max_ = 1;
  QFont font_;
};

}  // namespace tactus::workbench
