// Anatomical landmarks at an edge of a plot with a depth axis: a bar or a tick, and a name, or in a low plot a number;
// the mouse over it tells the rest. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <span>
#include <vector>

#include "app/workbench/plot/landmarks.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class LandmarkMarks : public QCPLayerable {
  Q_OBJECT

 public:
  enum class Place {
    kInside,  ///< at the lower edge, inside the plot area
    kAbove,   ///< above the plot, which leaves height() px for them
    kUnder,   ///< below the upper edge, inside the plot area
    kBeside,  ///< along the left axis if that is the depth axis, inside the plot area
  };

  LandmarkMarks(QCustomPlot& plot, Place place);

  /// Shows the landmarks for the axis of `variable`, with the events of its model; none if it is not the depth.
  void setVariable(const fuzzy::Variable& variable, std::span<const fuzzy::TubeEvent> events = {});
  enum class Text {
    kNames,    ///< but numbers in a low plot, unless the place is kAbove
    kNumbers,  ///< for low plots
    kNone,     ///< for small plots
  };
  void setText(Text text) { text_ = text; }
  /// One line per landmark with its place and its source; empty without landmarks.
  QString explanation() const;
  /// Height of the bars and the rows of names, px; 0 without landmarks.
  int height() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  QString numberOf(const Landmark& mark) const;
  QString lineOf(const Landmark& mark) const;
  QString linesAt(QPointF place) const;
  void drawBeside(QCPPainter& painter) const;
  std::vector<Landmark> inSight(const QCPAxis& axis) const;

  Place place_;
  Text text_ = Text::kNames;
  std::vector<Landmark> landmarks_;
  QFont font_;
};

}  // namespace tactus::workbench
