#include "app/workbench/tune/terms/term_sliders.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/editing/edit_text.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/tune/terms/vertex_slider.h"

namespace tactus::workbench {
namespace {

constexpr int kWidestTitle = 14 * theme::kGrid;  // px
constexpr int kRoomyHeight = 480;                // px at 100 %, of the editor

}  // namespace

TermSliders::TermSliders(TermController& terms, QWidget* parent)
    : QWidget(parent), terms_(terms), layout_(new QHBoxLayout(this)), title_(new ElidedLabel(this)) {
  QFont font = theme::smallFont();
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  keepFitted(*title_, [this] {
    const int whole = title_->fontMetrics().horizontalAdvance(QStringLiteral("Laryngopharynx")) + 4;
    title_->setFixedWidth(std::min(whole, kWidestTitle));
  });
  layout_->setContentsMargins(6, 0, 0, 0);
  layout_->setSpacing(theme::kGrid);
  layout_->addWidget(title_);
  connect(&terms_, &TermController::listChanged, this, &TermSliders::follow);
  connect(&terms_, &TermController::termsChanged, this, &TermSliders::follow);
  connect(&terms_, &TermController::selectionChanged, this, &TermSliders::follow);
  connect(&terms_, &TermController::locksChanged, this, &TermSliders::follow);
}

void TermSliders::showEvent(QShowEvent* event) {
  // Hidden, it followed nothing.
  follow();
  QWidget::showEvent(event);
}

void TermSliders::fitInto(int height) { setVisible(height >= appearance::scaled(kRoomyHeight)); }

void TermSliders::follow() {
  if (!isVisible() || !terms_.isOpen() || terms_.terms().empty()) return;
  if (const auto selected = terms_.selected()) term_ = selected->term;
  term_ = std::min(term_, terms_.terms().size() - 1);
  const fuzzy::Term& term = terms_.terms()[term_];
  if (parts_.size() != term.points.size() || shape_ != term.shape) build(term);
  show(term);
}

void TermSliders::build(const fuzzy::Term& term) {
  // One of them may be in the middle of a signal of its own.
  for (const Part& part : parts_) {
    part.cell->hide();
    part.cell->deleteLater();
  }
  parts_.clear();
  shape_ = term.shape;
  for (std::size_t p = 0; p < term.points.size(); ++p) {
    Part part{new QWidget(this), nullptr, nullptr};
    part.name = new ElidedLabel(part.cell);
    part.name->setFont(theme::smallFont());
    part.slider = new VertexSlider(part.cell);
    auto* column = new QVBoxLayout(part.cell);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(part.name);
    column->addWidget(part.slider);
    layout_->addWidget(part.cell, 1);
    const auto grip = [this, p] { return Grip{term_, Grip::Part::kVertex, p, false}; };
    connect(part.slider, &VertexSlider::moveBegun, this, [this, grip] {
      terms_.select(grip());
      terms_.beginMove(grip());
    });
    connect(part.slider, &VertexSlider::moved, &terms_, &TermController::moveBy);
    connect(part.slider, &VertexSlider::moveEnded, &terms_, &TermController::endMove);
    connect(part.slider, &VertexSlider::moveCancelled, &terms_, &TermController::cancelMove);
    connect(part.slider, &VertexSlider::stepped, this, [this, grip](int count, bool coarse) {
      terms_.select(grip());
      terms_.step(count, coarse);
    });
    connect(part.slider, &VertexSlider::stepsEnded, &terms_, &TermController::endSteps);
    parts_.push_back(part);
  }
}

void TermSliders::show(const fuzzy::Term& term) {
  title_->setFullText(labelOf(term));
  const fuzzy::Variable& variable = terms_.variable();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const QString name = text(editing::pointName(term.shape, p));
    QString sentence = name;
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    parts_[p].name->setFullText(sentence);
    parts_[p].slider->setAccessibleName(tr("%1 of %2").arg(sentence, labelOf(term)));
    parts_[p].slider->setToolTip(tr("Move the %1 from %2: drag, or use the arrow keys, with Shift farther")
                                     .arg(name, placeText(variable, term.points[p])));
    const bool width = term.shape == fuzzy::Shape::kGaussian && p == 1;
    parts_[p].slider->setEnds(width ? 0 : variable.min, width ? variable.max - variable.min : variable.max);
    parts_[p].slider->setEnabled(!terms_.isLocked(term.id, p));
    parts_[p].slider->setPlace(term.points[p]);
  }
}

}  // namespace tactus::workbench
