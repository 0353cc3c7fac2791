#include "app/workbench/labs/depth/depth_term_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_term_plot.h"
#include "app/workbench/labs/depth/page_parts.h"
#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {
namespace {

using elicitation::DepthsFrom;

constexpr int kTemplateItem = 0;
constexpr int kMeasuredItem = 1;

PlotTable termTable(const DepthLab& lab) {
  PlotTable table;
  table.file = QStringLiteral("depth-terms");
  table.caption << DepthTermPage::tr("Terms of the insertion depth, measured on %1").arg(text(lab.measurement().image))
                << DepthTermPage::tr("one pixel is %1 mm · anatomical scale %2")
                       .arg(numberText(lab.measurement().mm_per_px, 4), numberText(lab.measurement().scale));
  table.columns = {"term", "a_mm", "b_mm", "c_mm", "d_mm"};
  for (const fuzzy::Term& term : lab.terms().terms) {
    table.rows.push_back({term.id, term.points[0], term.points[1], term.points[2], term.points[3]});
  }
  return table;
}

}  // namespace

DepthTermPage::DepthTermPage(DepthLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      choice_(new QComboBox(this)),
      plot_(new DepthTermPlot(this)),
      numbers_(mutedWords({}, this)) {
  setObjectName(QStringLiteral("terms"));
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  choice_->addItem(tr("Template"));
  choice_->addItem(tr("Measured here"));
  choice_->setToolTip(tr("Choose which depths the study's model has, here, in the report and in the bench."));
  auto* menu = new PlotMenu(
      *plot_, [this] { return termTable(lab_); }, this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, theme::kGrid, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(pageHead(tr("De&pths of the model"), choice_, menu));
  layout->addWidget(plot_, 3);
  layout->addWidget(numbers_);
  layout->addStretch(1);
  connect(choice_, &QComboBox::activated, this, [this](int item) {
    lab_.setDepthsFrom(item == kMeasuredItem ? DepthsFrom::kMeasured : DepthsFrom::kTemplate);
  });
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthTermPage::follow);
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthTermPage::followChoice);
  connect(&lab_, &DepthLab::depthsFromChanged, this, &DepthTermPage::followChoice);
  follow();
  followChoice();
}

void DepthTermPage::follow() {
  plot_->show(lab_.terms());
  QStringList lines;
  for (const fuzzy::Term& term : lab_.terms().terms) {
    QStringList points;
    for (const double point : term.points) points << numberText(point, 1);
    lines << tr("%1: %2 mm").arg(labelOf(term), points.join(QStringLiteral(" · ")));
  }
  numbers_->setText(lines.join(QLatin1Char('\n')));
}

void DepthTermPage::followChoice() {
  const bool measured = lab_.isMeasured();
  const QString image = harmless(text(lab_.measurement().image));
  choice_->setItemText(kMeasuredItem,
                       measured && !image.isEmpty() ? tr("Measured: %1").arg(image) : tr("Measured here"));
  QStandardItem* const item = qobject_cast<QStandardItemModel*>(choice_->model())->item(kMeasuredItem);
  item->setEnabled(measured);
  item->setToolTip(measured ? QString() : tr("Nothing is measured yet: load an image, or set a boundary."));
  choice_->setCurrentIndex(lab_.depthsFrom() == DepthsFrom::kMeasured ? kMeasuredItem : kTemplateItem);
}

}  // namespace tactus::workbench
