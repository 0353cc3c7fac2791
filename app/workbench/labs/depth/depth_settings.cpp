#include "app/workbench/labs/depth/depth_settings.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/frame/lab_card.h"

namespace tactus::workbench {

QHBoxLayout* pageHead(const QString& name, QWidget* field, QWidget* menu) {
  auto* label = new QLabel(name, field->parentWidget());
  label->setBuddy(field);
  auto* head = makeRow({label, field, spring(1), menu});
  return head;
}

QLabel* mutedWords(const QString& words, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  setMuted(*label);
  return label;
}

namespace {

fuzzy::Variable range(const QString& name, const std::string& unit, double min, double max) {
  fuzzy::Variable out;
  out.id = "setting";
  out.label = name.toStdString();
  out.unit = unit;
  out.min = min;
  out.max = max;
  return out;
}

QLabel* heading(const QString& words, QWidget* parent) {
  auto* label = new QLabel(words, parent);
  label->setFont(theme::headingFont());
  return label;
}

}  // namespace

DepthSettingsPanel::DepthSettingsPanel(DepthLab& lab, QWidget* parent)
    : Card(parent),
      lab_(lab),
      name_(new QLabel(this)),
      mm_per_px_(new NumberBox(range(tr("Millimeters per pixel"), "mm", 0.001, 10), 0.01, this)),
      length_(new QPushButton(tr("Mark a &known length…"), this)),
      scale_(new SettingRow(tr("Anatomical scale"),
                            tr("All depths of the terms times this factor: 0.93 for a small adult, 1.05 for a large "
                               "one. The measurement stays."),
                            {0.8, 1.2, 0.01}, this)),
      example_(new QPushButton(tr("&Show the example"), this)),
      way_(new QLabel(this)),
      problem_(new QLabel(this)) {
  auto* load = new QPushButton(tr("&Load an image…"), this);
  auto* boundaries = new QWidget(this);
  boundaries_ = new QGridLayout(boundaries);
  boundaries_->setContentsMargins(0, 0, 0, 0);
  boundaries_->setHorizontalSpacing(theme::kGrid / 2);
  boundaries_->setVerticalSpacing(theme::kGrid / 2);
  boundaries_->setColumnStretch(0, 1);
  name_->setTextFormat(Qt::PlainText);
  for (QLabel* label : {name_, way_}) setMuted(*label);
  for (QLabel* label : {name_, way_, problem_}) label->setWordWrap(true);
  setInk(*problem_, theme::errorInk());
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, theme::kGrid + 4, 2 * theme::kGrid, 2 * theme::kGrid);
  layout->setHorizontalSpacing(theme::kGrid);
  layout->setVerticalSpacing(theme::kGrid);
  int row = 0;
  layout->addWidget(heading(tr("Image"), this), row++, 0, 1, 2);
  layout->addWidget(load, row++, 0, 1, 2);
  layout->addWidget(example_, row++, 0, 1, 2);
  layout->addWidget(name_, row++, 0, 1, 2);
  layout->addWidget(new QLabel(tr("One pixel is"), this), row, 0);
  layout->addWidget(mm_per_px_, row++, 1, Qt::AlignRight);
  layout->addWidget(length_, row++, 0, 1, 2);
  layout->addWidget(heading(tr("Way"), this), row++, 0, 1, 2);
  layout->addWidget(way_, row++, 0, 1, 2);
  layout->addWidget(heading(tr("Boundaries"), this), row++, 0, 1, 2);
  layout->addWidget(boundaries, row++, 0, 1, 2);
  layout->addWidget(scale_, row++, 0, 1, 2);
  layout->addWidget(problem_, row++, 0, 1, 2);
  layout->setRowStretch(row, 1);
  connect(load, &QPushButton::clicked, this, &DepthSettingsPanel::loadAsked);
  connect(example_, &QPushButton::clicked, this, &DepthSettingsPanel::exampleAsked);
  connect(length_, &QPushButton::clicked, this, &DepthSettingsPanel::lengthAsked);
  connect(mm_per_px_, &QDoubleSpinBox::valueChanged, this, [this] {
    auto wanted = lab_.measurement();
    wanted.mm_per_px = mm_per_px_->exact();
    lab_.show(wanted);
    lab_.commit(tr("scale of the image"));
  });
  connect(scale_, &SettingRow::changed, this, [this](double value) {
    auto wanted = lab_.measurement();
    wanted.scale = value;
    lab_.show(wanted);
    lab_.commit(tr("anatomical scale"));
  });
  connect(&lab_, &DepthLab::depthChanged, this, &DepthSettingsPanel::fillBoundaries);
  connect(&lab_, &DepthLab::measurementChanged, this, &DepthSettingsPanel::refreshState);
  connect(&lab_, &DepthLab::imageChanged, this, &DepthSettingsPanel::refreshState);
  fillBoundaries();
}

void DepthSettingsPanel::fillBoundaries() {
  QWidget* const table = boundaries_->parentWidget();
  qDeleteAll(table->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
  rows_.clear();
  auto* depth_title = new QLabel(tr("at"), table);
  auto* overlap_title = new QLabel(tr("overlap ±"), table);
  for (QLabel* title : {depth_title, overlap_title}) setMuted(*title);
  boundaries_->addWidget(depth_title, 0, 1, Qt::AlignRight);
  boundaries_->addWidget(overlap_title, 0, 2, Qt::AlignRight);
  const auto& terms = lab_.depth().terms;
  for (std::size_t k = 0; k + 1 < terms.size(); ++k) {
    const QString name = tr("%1 | %2").arg(labelOf(terms[k]), labelOf(terms[k + 1]));
    Row row{new QLabel(name, table),
            new NumberBox(range(tr("Depth of %1").arg(name), "mm", lab_.depth().min, lab_.depth().max), 1, table),
            new NumberBox(range(tr("Overlap of %1").arg(name), "mm", 0, 99), 1, table)};
    row.name->setFont(theme::smallFont());
    row.name->setWordWrap(true);
    const int line = static_cast<int>(k) + 1;
    boundaries_->addWidget(row.name, line, 0);
    boundaries_->addWidget(row.depth, line, 1);
    boundaries_->addWidget(row.overlap, line, 2);
    connect(row.depth, &QDoubleSpinBox::valueChanged, this,
            [this, k, row] { setBoundary(k, row.depth->exact(), lab_.measurement().boundaries[k].half_overlap_mm); });
    connect(row.overlap, &QDoubleSpinBox::valueChanged, this,
            [this, k, row] { setBoundary(k, lab_.measurement().boundaries[k].depth_mm, row.overlap->exact()); });
    rows_.push_back(row);
  }
  example_->setVisible(hasExample(*lab_.about()));
  refreshState();
}

void DepthSettingsPanel::setBoundary(std::size_t index, double depth_mm, double half_overlap_mm) {
  auto wanted = lab_.measurement();
  wanted.boundaries[index] = {depth_mm, half_overlap_mm};
  lab_.show(wanted);
  lab_.commit(rows_[index].name->text());
}

void DepthSettingsPanel::refreshState() {
  const auto& measurement = lab_.measurement();
  const bool has_image = measurement.example || !lab_.image().isEmpty();
  name_->setText(has_image ? text(measurement.image)
                           : tr("None yet. A sagittal image (PNG, JPEG, TIFF) through the middle of the body."));
  length_->setEnabled(has_image);
  const QSignalBlocker quiet_scale(mm_per_px_);
  mm_per_px_->setExact(measurement.mm_per_px);
  scale_->setValue(measurement.scale);
  for (std::size_t k = 0; k < rows_.size() && k < measurement.boundaries.size(); ++k) {
    const QSignalBlocker quiet_depth(rows_[k].depth);
    const QSignalBlocker quiet_overlap(rows_[k].overlap);
    rows_[k].depth->setExact(measurement.boundaries[k].depth_mm);
    rows_[k].overlap->setExact(measurement.boundaries[k].half_overlap_mm);
  }
  way_->setText(lab_.path() ? tr("%n point(s), %1 mm from the entry to the end", nullptr,
                                 static_cast<int>(measurement.path.size()))
                                  .arg(numberText(lab_.path()->lengthMm(), 1))
                            : tr("Click along the way on the image, from the entry on. Drag a point to move it, Del "
                                 "removes it; drag a red circle to the boundary of two regions."));
  problem_->setText(lab_.problem());
  problem_->setVisible(!lab_.problem().isEmpty());
}

}  // namespace tactus::workbench
