// A chart as a value, and the widget that shows it: axes, lines, bands, bars, marks and texts, each drawn over those
// before it, and the legend of its picture.
#pragma once

#include <QBrush>
#include <QMargins>
#include <QPen>
#include <QPointF>
#include <QSize>
#include <QString>
#include <QVector>
#include <QWidget>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCPAxis;
class QCustomPlot;

namespace tactus::workbench {

struct ChartAxis {
  fuzzy::Variable universe = {};
  QString label = {};
  std::optional<std::pair<double, double>> range = std::nullopt;  ///< what is in sight; nothing: the universe
  bool round_ticks = false;  ///< at round numbers alone, without the ends of the universe
  double step = 0;           ///< between ticks; 0: as many as there is room for
  bool grid = true;
};

/// From 0 to 1, and a little above: lines at 1 stay whole. Without a label.
ChartAxis membershipAxis(double top = 1.06);

/// Gives `axis` the look, range, ticks, label and grid of `wanted`.
void styleAxis(QCPAxis& axis, const ChartAxis& wanted);

struct ChartDots {
  enum class Shape { kNone, kDisc, kCircle, kSquare };

  Shape shape = Shape::kNone;
  double size_px = 0;
  std::optional<QPen> pen = std::nullopt;  ///< nothing: that of the line
  QBrush fill = Qt::NoBrush;               ///< of a circle or a square
};

/// A line, dots, or both, in the units of the axes. y NaN: the line ends, and another one begins.
struct ChartLine {
  QVector<double> x;
  QVector<double> y;
  QPen pen = QPen(Qt::NoPen);
  ChartDots dots = {};
  QBrush fill = Qt::NoBrush;     ///< down to 0
  bool is_function_of_x = true;  ///< otherwise x may go back, and the fill is what the line encloses
};

/// A line of `width` px with a fill below it in the same color.
ChartLine filledLine(const QVector<double>& x, const QVector<double>& y, const QColor& color, double width,
                     float fill_alpha);

/// What lies between two lines.
struct ChartBand {
  QVector<double> x;
  QVector<double> low;
  QVector<double> high;
  QBrush fill;
};

/// A rectangle in the units of the axes.
struct ChartBar {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  QBrush fill;
};

/// A straight line over the whole chart, at a value of x (vertical) or of y.
struct ChartRule {
  Qt::Orientation direction = Qt::Vertical;
  double at = 0;
  QPen pen;
};

/// Small words, with `side` of them at a place.
struct ChartText {
  QString words;
  QPointF at;
  Qt::Alignment side;
  QColor ink;
  QMargins room = {};  ///< px, around the words
};

struct Chart {
  ChartAxis x;
  ChartAxis y;
  std::vector<std::variant<ChartLine, ChartBand, ChartBar, ChartRule, ChartText>> parts = {};
  std::vector<LegendEntry> legend = {};
};

class ChartView : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  /// Empty: neither axes nor lines. `picture`: the size of its picture, px, without legend.
  explicit ChartView(QWidget* parent = nullptr, QSize picture = {1000, 560});

  void setChart(Chart chart);
  void clear();
  const Chart& chart() const { return chart_; }

  /// For marks that follow the mouse.
  QCustomPlot& plot() { return *plot_; }

  QSize pictureSize() const override { return picture_; }
  std::vector<LegendEntry> legend() const override { return chart_.legend; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  void add(const ChartLine& line);
  void add(const ChartBand& band);
  void add(const ChartBar& bar);
  void add(const ChartRule& rule);
  void add(const ChartText& text);

  const QSize picture_;
  QCustomPlot* plot_;
  Chart chart_;
};

}  // namespace tactus::workbench
