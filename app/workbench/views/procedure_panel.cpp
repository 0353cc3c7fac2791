#include "app/workbench/views/procedure_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

void setInk(QLabel* label, const QColor& ink) {
  QPalette colors = label->palette();
  colors.setColor(QPalette::WindowText, ink);
  label->setPalette(colors);
}

}  // namespace

ProcedurePanel::ProcedurePanel(std::vector<ProcedureStep> steps, QWidget* parent)
    : QWidget(parent), steps_(std::move(steps)), text_(new QLabel(this)) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(3);
  grid->setColumnStretch(1, 1);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Row row{new QLabel(QString::number(i + 1), this), new QLabel(steps_[i].title, this)};
    row.number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.number->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00")));
    row.title->setTextFormat(Qt::PlainText);
    grid->addWidget(row.number, static_cast<int>(i), 0);
    grid->addWidget(row.title, static_cast<int>(i), 1);
    rows_.push_back(row);
  }
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  text_->setFont(theme::smallFont());

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(grid);
  layout->addWidget(text_, 1);
  // The longest text has its place, so that nothing moves from step to step.
  text_->setMinimumHeight(6 * QFontMetrics(theme::smallFont()).height());
  setDepth(0);
}

void ProcedurePanel::setDepth(double depth_mm) {
  if (steps_.empty()) return;
  const std::size_t step = stepAt(steps_, depth_mm).value_or(0);
  if (shown_ != step) show(step);
}

void ProcedurePanel::show(std::size_t step) {
  shown_ = step;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    QFont font = this->font();
    font.setBold(i == step);
    for (QLabel* label : {rows_[i].number, rows_[i].title}) {
      label->setFont(font);
      setInk(label, i == step ? theme::accent() : i < step ? theme::ink() : theme::mutedInk());
    }
  }
  text_->setText(steps_[step].text);
}

}  // namespace tactus::workbench
