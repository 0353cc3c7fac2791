#include "app/workbench/understand/here/output_card.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/here/membership_plot.h"

namespace tactus::workbench {

OutputCard::OutputCard(SceneController& scene, QWidget* parent)
    : Card(parent),
      scene_(scene),
      variable_(scene.model()->model.output),
      title_(new ElidedLabel(this)),
      number_(new QLabel(this)),
      plot_(new MembershipPlot(variable_, this)),
      terms_(new ElidedLabel(this)) {
  number_->setTextFormat(Qt::PlainText);
  title_->setFont(theme::headingFont());
  title_->setFullText(labelOf(variable_));
  terms_->setFont(theme::smallFont());
  terms_->setIndent(MembershipPlot::kLeftMargin - theme::kGrid);

  auto* head = new QHBoxLayout;
  head->setContentsMargins(theme::kGrid, 0, theme::kGrid, 0);
  head->addWidget(title_, 1);
  head->addWidget(number_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, theme::kGrid, 4, theme::kGrid);
  layout->setSpacing(4);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  // The plot stands in line with those of the inputs, which have a slider below.
  number_->setMinimumHeight(QDoubleSpinBox().sizeHint().height());
  layout->addSpacing(QSlider(Qt::Horizontal).sizeHint().height() + layout->spacing());
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(0, 0, theme::kGrid - 4, 0);
  foot->addWidget(terms_, 1);
  foot->addWidget(new PlotMenu(
      *plot_, [this] { return table(); }, this));
  layout->addLayout(foot);

  plot_->setTerms(scene_.terms(variable_));
  auto* reading = new Refresh(this, [this] { showReading(); });
  reading->request();
  connect(&scene_, &SceneController::readingChanged, reading, &Refresh::request);
  connect(&scene_, &SceneController::termsChanged, reading, &Refresh::request);
  connect(&scene_, &SceneController::termsChanged, this, &OutputCard::showTerms);
}

void OutputCard::showTerms() { plot_->setTerms(scene_.terms(variable_)); }

void OutputCard::showReading() {
  const Reading& reading = scene_.reading();
  if (!reading.mean.fired) {
    number_->setText(tr("no rule fires"));
    terms_->setFullText({});
    plot_->setValue(std::nullopt);
    return;
  }
  const double mean_n = reading.mean.force_n;
  number_->setText(tr("mean %1").arg(forceText(mean_n, variable_.unit)));
  terms_->setFullText(membershipText(scene_.terms(variable_), mean_n));
  plot_->setValue(mean_n);
}

PlotTable OutputCard::table() {
  PlotTable out = captionedTerms(scene_, variable_, termsText(scene_));
  plot_->fillTable(out);
  return out;
}

}  // namespace tactus::workbench
