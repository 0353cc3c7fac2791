#include "app/workbench/understand/here/input_card.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/here/membership_plot.h"

namespace tactus::workbench {
InputCard::InputCard(SceneController& scene, std::size_t input, QWidget* parent)
    : Card(parent),
      scene_(scene),
      input_(input),
      variable_(scene.model()->model.inputs[input]),
      step_(stepOf(variable_)),
      title_(new ElidedLabel(this)),
      number_(new NumberBox(variable_, step_, this)),
      plot_(new MembershipPlot(variable_, this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      terms_(new ElidedLabel(this)) {
  title_->setFont(theme::headingFont());
  title_->setFullText(labelOf(variable_));
  terms_->setFont(theme::smallFont());
  terms_->setIndent(MembershipPlot::kLeftMargin - theme::kGrid);
  slider_->setRange(0, static_cast<int>(std::ceil((variable_.max - variable_.min) / step_ - 1e-9)));
  slider_->setSingleStep(1);
  slider_->setPageStep(10);
  slider_->setAccessibleName(labelOf(variable_));

  auto* head = new QHBoxLayout;
  head->setContentsMargins(theme::kGrid, 0, theme::kGrid, 0);
  head->setSpacing(4);
  head->addWidget(title_, 1);
  head->addWidget(number_);

  // The handle stands below the marker of the plot.
  auto* slider_row = new QHBoxLayout;
  const int half_handle = slider_->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, slider_) / 2;
  slider_row->setContentsMargins(MembershipPlot::kLeftMargin - half_handle, 0,
                                 MembershipPlot::kRightMargin - half_handle, 0);
  slider_row->addWidget(slider_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, theme::kGrid, 4, theme::kGrid);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  layout->addLayout(slider_row);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(0, 0, theme::kGrid - 4, 0);
  foot->addWidget(terms_, 1);
  foot->addWidget(new PlotMenu(
      *plot_, [this] { return table(); }, this));
  layout->addLayout(foot);

  showTerms();

  connect(slider_, &QSlider::valueChanged, this, &InputCard::onSlider);
  connect(number_, &NumberBox::valueChanged, this, &InputCard::onNumber);
  connect(plot_, &MembershipPlot::picked, this, &InputCard::onNumber);
  connect(&scene_, &SceneController::valueChanged, this, &InputCard::onValue);
  connect(&scene_, &SceneController::readingChanged, this, &InputCard::onReading);
  connect(&scene_, &SceneController::xInputChanged, this, &InputCard::showValue);
  connect(&scene_, &SceneController::termsChanged, this, &InputCard::showTerms);
}

void InputCard::showTerms() {
  plot_->setTerms(scene_.terms(variable_));
  showValue();
}

void InputCard::onValue(std::size_t input) {
  if (input == input_) showValue();
}

void InputCard::onReading() {
  if (input_ == scene_.xInput()) showValue();
}

void InputCard::showValue() {
  // The input on the x axis follows the mouse in the curves.
  const double value = input_ == scene_.xInput() ? scene_.readingX() : scene_.value(input_);
  const QSignalBlocker no_slider_signal(slider_);
  const QSignalBlocker no_number_signal(number_);
  slider_->setValue(static_cast<int>(std::lround((value - variable_.min) / step_)));
  number_->setValue(value);
  plot_->setValue(value);
  const QString memberships = membershipText(scene_.terms(variable_), value);
  terms_->setFullText(memberships.isEmpty() ? tr("in no term") : memberships);
}

void InputCard::onSlider(int position) { scene_.setValue(input_, variable_.min + position * step_); }

void InputCard::onNumber(double value) { scene_.setValue(input_, value); }

PlotTable InputCard::table() {
  PlotTable out = captionedTerms(scene_, variable_, termsText(scene_));
  plot_->fillTable(out);
  return out;
}

}  // namespace tactus::workbench
