// The strokes of one participant at one level, one after another (paper, Fig. 6), with the marks between which a stroke
// counts. A mark follows the mouse; what is let go is a correction.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "app/workbench/labs/speed/speed_lab.h"
#include "elicitation/tracing/sources.h"

class QPainter;

namespace tactus::workbench {

class TraceRow : public QWidget {
  Q_OBJECT

 public:
  explicit TraceRow(QWidget* parent = nullptr);

  /// `set` may be null while it is read. `top_mm_s`: the upper end of the axis, the same for all rows in sight.
  void show(const QString& title, const QColor& color, std::shared_ptr<const StrokeSet> set, double top_mm_s);
  bool hasStrokes() const { return set_ && !set_->strokes.empty(); }
  /// The largest speed of `set`; 0 for none.
  static double highestOf(const StrokeSet* set);
  /// The upper end of an axis for speeds up to `highest_mm_s`: whole fifties.
  static double topOf(double highest_mm_s);
  /// Frames the stroke with this number; empty: none.
  void setChosen(std::optional<int> number);
  /// From now on nothing is corrected or chosen here.
  void setReadOnly() { read_only_ = true; }
  /// The place of a mark of stroke `index` on the screen, px: of its begin, or its end.
  QPointF markPlace(std::size_t index, bool begin) const;

  QSize sizeHint() const override { return {640, 130}; }
  QSize minimumSizeHint() const override { return {320, 96}; }

 signals:
  /// The person clicked a stroke.
  void strokeChosen(const tactus::study::StrokeRecord& record);
  /// The person moved a mark: the stroke with the other samples between its marks.
  void marked(const tactus::study::StrokeRecord& before, const tactus::study::StrokeRecord& wanted);
  /// The person left a stroke out, or took it in again.
  void judged(const tactus::study::StrokeRecord& before, const tactus::study::StrokeRecord& wanted);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Mark {
    std::size_t stroke;
    bool begin;

    bool operator==(const Mark&) const = default;
  };
  QRectF area() const;
  double scale() const;                   ///< px per second
  double left(std::size_t stroke) const;  ///< px, where its recording begins
  double y(double speed_mm_s) const;
  std::optional<Mark> markAt(const QPointF& place) const;
  std::optional<std::size_t> strokeAt(const QPointF& place) const;
  /// The stroke as it would be with the mark at `place`.
  study::StrokeRecord movedTo(const Mark& mark, double place) const;
  const study::StrokeRecord& shownRecord(std::size_t stroke) const;
  void paintAxis(QPainter& painter) const;
  void paintStroke(QPainter& painter, std::size_t index) const;
  void paintTrace(QPainter& painter, std::size_t index) const;

  QString title_;
  QColor color_;
  std::shared_ptr<const StrokeSet> set_;
  double top_mm_s_ = 100;
  std::optional<int> chosen_;  ///< the number of a stroke
  bool read_only_ = false;
  std::optional<Mark> held_;
  std::optional<study::StrokeRecord> moved_;  ///< the stroke of `held_` as it is shown meanwhile
};

// The raw trace of one stroke among those of its level, for looking at: nothing can be corrected here.

class TraceRow;

class StrokePreview : public QWidget {
  Q_OBJECT

 public:
  /// `lab_data` outlives this.
  explicit StrokePreview(LabData& lab_data, QWidget* parent = nullptr);

  void showStroke(const elicitation::StrokeKey& stroke);
  const TraceRow& row() const { return *row_; }

 private:
  void refreshState();

  StrokeTraces traces_;
  std::optional<elicitation::StrokeKey> stroke_;
  TraceRow* row_;
};

}  // namespace tactus::workbench
