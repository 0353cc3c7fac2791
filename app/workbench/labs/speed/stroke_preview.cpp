#include "app/workbench/labs/speed/stroke_preview.h"

#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/labs/speed/trace_row.h"

namespace tactus::workbench {

StrokePreview::StrokePreview(LabData& lab_data, QWidget* parent)
    : QWidget(parent), traces_(lab_data), row_(new TraceRow(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(row_);
  row_->setReadOnly();
  connect(&traces_, &StrokeTraces::arrived, this, &StrokePreview::follow);
}

void StrokePreview::showStroke(const elicitation::StrokeKey& stroke) {
  stroke_ = stroke;
  follow();
}

void StrokePreview::follow() {
  if (!stroke_) return;
  const auto set = traces_.strokes(stroke_->participant, stroke_->level);
  const QString title =
      QStringLiteral("%1 · %2").arg(harmless(text(stroke_->participant)), harmless(text(stroke_->level)));
  row_->show(title, theme::accent(), set, TraceRow::topOf(TraceRow::highestOf(set.get())));
  row_->setChosen(stroke_->stroke);
}

}  // namespace tactus::workbench
