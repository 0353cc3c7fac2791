// Sliders for the vertices of the selected term, as in the paper. They follow the plot and the numbers.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "core/fuzzy/force_model.h"

class QHBoxLayout;

namespace tactus::workbench {

class ElidedLabel;
class TermController;
class VertexSlider;

class TermSliders : public QWidget {
  Q_OBJECT

 public:
  explicit TermSliders(TermController& terms, QWidget* parent = nullptr);
  /// Leaves its room to the plot in an editor of `height` px that is low for the size of the text: the plot, its keys
  /// and the table move a vertex too.
  void fitInto(int height);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Part {
    QWidget* cell;
    ElidedLabel* name;
    VertexSlider* slider;
  };
  void follow();
  void build(const fuzzy::Term& term);
  void show(const fuzzy::Term& term);

  TermController& terms_;
  QHBoxLayout* layout_;
  ElidedLabel* title_;
  std::vector<Part> parts_;
  std::size_t term_ = 0;  ///< index in the list; the first term if none is selected
  fuzzy::Shape shape_ = fuzzy::Shape::kTrapezoid;
};

}  // namespace tactus::workbench
