// A panel of the window, and its place in the default layout of a stage.
#pragma once

#include <QDockWidget>

namespace tactus::workbench {

/// What PanelArea::addPanel returns: layouts name a panel by it.
class Panel : public QDockWidget {
  Q_OBJECT

 public:
  using QDockWidget::QDockWidget;

  /// Shows the panel before others in the same place.
  void reveal();

 protected:
  bool focusNextPrevChild(bool next) override;
};

/// Places in a layout build on those before them: `right(map, 44, curves)` needs a place of `curves` first.
struct PanelPlace {
  enum class How { kFirst, kRight, kBelow, kTab };

  /// Takes the whole area.
  static PanelPlace first(Panel& panel) { return {&panel, How::kFirst, nullptr, 100}; }
  /// Takes the right `percent` of the place of `beside`.
  static PanelPlace right(Panel& panel, int percent, Panel& beside) { return {&panel, How::kRight, &beside, percent}; }
  /// Takes the lower `percent` of the place of `above`.
  static PanelPlace below(Panel& panel, int percent, Panel& above) { return {&panel, How::kBelow, &above, percent}; }
  /// A tab behind `before`.
  static PanelPlace behind(Panel& panel, Panel& before) { return {&panel, How::kTab, &before, 100}; }

  Panel* panel;
  How how;
  Panel* beside;  ///< null for kFirst
  int percent;    ///< of the place of `beside`
};

}  // namespace tactus::workbench
