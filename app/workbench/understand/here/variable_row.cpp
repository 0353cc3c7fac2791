#include "app/workbench/understand/here/variable_row.h"

#include <QHBoxLayout>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/here/input_card.h"
#include "app/workbench/understand/here/output_card.h"

namespace tactus::workbench {
namespace {

constexpr int kNarrowestCard = 158;  // px; five of them fit beside the forces in a window of 1280 px, and large ones
                                     // below the curves alone
constexpr int kHeight = 224;         // px

// Cards with many terms get more room for their names, but not in proportion.
int stretchOf(const fuzzy::Variable& variable) {
  return static_cast<int>(100 * std::sqrt(static_cast<double>(std::max<std::size_t>(4, variable.terms.size()))));
}

void keepReadable(QWidget& card) {
  keepFitted(card, [&card] { card.setMinimumWidth(std::max(kNarrowestCard, card.minimumSizeHint().width())); });
}

}  // namespace

VariableRow::VariableRow(SceneController& scene, QWidget* parent) : QScrollArea(parent), scene_(scene) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  connect(&scene_, &SceneController::modelChanged, this, &VariableRow::build);
}

QSize VariableRow::sizeHint() const {
  const bool scrolls = widget() && widget()->minimumSizeHint().width() > width();
  return {4 * appearance::scaled(kNarrowestCard), kHeight + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0)};
}

// One card at least; the others are scrolled to.
QSize VariableRow::minimumSizeHint() const { return {appearance::scaled(kNarrowestCard), sizeHint().height()}; }

void VariableRow::build() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    auto* card = new InputCard(scene_, i, row);
    keepReadable(*card);
    layout->addWidget(card, stretchOf(model.inputs[i]));
  }
  auto* output = new OutputCard(scene_, row);
  keepReadable(*output);
  layout->addWidget(output, stretchOf(model.output));
  setWidget(row);
}

}  // namespace tactus::workbench
