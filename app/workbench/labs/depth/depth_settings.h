// The settings of a depth measurement: image, scale, boundaries with their overlaps, anatomical scale.
#pragma once

#include <QString>
#include <vector>

#include "app/workbench/kit/cards.h"

class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QGridLayout;
class QPushButton;
class QWidget;

namespace tactus::workbench {

// What the pages beside the image have in common: a field with its name and the plot's menu, and words below.

/// `name` and `field` at the left, `menu` at the right. The name's mnemonic leads to the field.
QHBoxLayout* pageHead(const QString& name, QWidget* field, QWidget* menu);

/// Muted words on as many lines as they need.
QLabel* mutedWords(const QString& words, QWidget* parent);

class DepthLab;
class NumberBox;
class SettingRow;

class DepthSettingsPanel : public Card {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit DepthSettingsPanel(DepthLab& lab, QWidget* parent = nullptr);

 signals:
  void loadAsked();
  void exampleAsked();
  void lengthAsked();

 private:
  /// The rows of the boundaries between the regions of the way.
  void fillBoundaries();
  void refreshState();
  void setBoundary(std::size_t index, double depth_mm, double half_overlap_mm);

  DepthLab& lab_;
  QLabel* name_;
  NumberBox* mm_per_px_;
  QPushButton* length_;
  SettingRow* scale_;
  struct Row {
    QLabel* name;
    NumberBox* depth;
    NumberBox* overlap;
  };
  std::vector<Row> rows_;
  QPushButton* example_;
  QGridLayout* boundaries_;
  QLabel* way_;
  QLabel* problem_;
};

}  // namespace tactus::workbench
