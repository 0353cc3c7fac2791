// What the views of a procedure that came as a pack have in common: what is lit, how deep the tip is, the ground.
#pragma once

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

inline constexpr double kEdgePx = 2.2;  // around the lit region

class PackView : public BodyView {
 public:
  using BodyView::BodyView;

  void setMirrored(bool mirrored) override { change(mirrored_, mirrored); }
  void setDepth(std::optional<double> depth_mm) override {
    if (isSame(depth_mm, depth_mm_)) return;
    depth_mm_ = depth_mm;
    update();
  }
  void light(const std::optional<LitRange>& range) override {
    if (lit_ == range) return;
    lit_ = range;
    forgetLit();
    update();
  }
  void lightRegion(const QString& id) override {
    const auto range = rangeOf(about(), id.toStdString());
    light(range ? std::optional(LitRange{range->from_mm, range->to_mm, nameOf(id)}) : std::nullopt);
  }
  void showNames() override { change(names_shown_, true); }
  void setRegionNames(std::vector<RegionName> names) override {
    if (names == regionNames()) return;
    forget();
    BodyView::setRegionNames(std::move(names));
  }
  void showWhole() override {
    change(whole_, true);
    const auto& terms = about().wayInput().terms;
    showTipIn(QString::fromStdString(terms.back().id));
  }

  QSize sizeHint() const override { return {320, 400}; }
  QSize minimumSizeHint() const override { return {120, 112}; }

 protected:
  /// Another thing than the depth is drawn.
  virtual void forget() {}
  /// Another part is lit.
  virtual void forgetLit() {}

  template <class Value>
  void change(Value& kept, const Value& value) {
    if (kept == value) return;
    kept = value;
    forget();
    update();
  }
  void resizeEvent(QResizeEvent* /*event*/) override { forget(); }
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::FontChange) forget();
    BodyView::changeEvent(event);
  }

  /// The ground of every picture, to whose shape the painter is cut.
  void begin(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath corners;
    corners.addRoundedRect(rect(), theme::kCornerRadius, theme::kCornerRadius);
    painter.setClipPath(corners);
    painter.fillRect(rect(), theme::card());
  }
  double toolPx() const {
    constexpr double kShare = 0.013;  // of the shorter side
    constexpr double kMostPx = 10;
    return std::min(kMostPx, kShare * std::min(width(), height()));
  }

  bool mirrored_ = false;
  bool names_shown_ = false;
  bool whole_ = false;  ///< not only what lies around the regions
  std::optional<double> depth_mm_;
  std::optional<LitRange> lit_;
};

/// Of a procedure with pictures.
BodyView* makePictureView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent);
/// Of one without.
BodyView* makeBarView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent);

}  // namespace tactus::workbench::anatomy
