#include <QComboBox>
#include <QDateTime>
#include <QPushButton>

#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_marks.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/layout.h"

namespace tactus::workbench {

MarksCard::MarksCard(FeelMarks& marks, FeelController& feel, QWidget* parent)
    : Card(parent),
      marks_(marks),
      feel_(feel),
      mark_(new QPushButton(tr("Mark this moment"), this)),
      list_(new QComboBox(this)) {
  mark_->setToolTip(tr("Keep the place, the speed, the conditions and the force that the hand feels now (F7)"));
  list_->setAccessibleName(tr("Marked moments"));
  list_->setToolTip(tr("Go to the place, the conditions and the force of a marked moment"));
  list_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list_->setMinimumContentsLength(16);
  list_->setMaxVisibleItems(20);
  makeRow(this, {mark_, {list_, 1}}, theme::kGrid, inset(theme::kGrid));
  connect(mark_, &QPushButton::clicked, &marks_, &FeelMarks::mark);
  connect(list_, &QComboBox::activated, this, [this](int row) {
    list_->setCurrentIndex(-1);  // the same one can be chosen again
    marks_.returnTo(marks_.marks().size() - 1 - static_cast<std::size_t>(row));
  });
  connect(&marks_, &FeelMarks::changed, this, &MarksCard::list);
  connect(&feel_, &FeelController::stateChanged, this, &MarksCard::list);
  list();
}

// Newest first.
void MarksCard::list() {
  const auto& marks = marks_.marks();
  mark_->setEnabled(feel_.isRunning());
  list_->clear();
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const QDateTime when = QDateTime::fromMSecsSinceEpoch(mark->entry.when.utc_ms);
    list_->addItem(marks_.textOf(*mark) + QStringLiteral(" · ") + when.toString(QStringLiteral("yyyy-MM-dd HH:mm")));
  }
  list_->setPlaceholderText(marks.empty() ? tr("No moment is marked yet")
                                          : tr("Return to one of %n mark(s)", nullptr, static_cast<int>(marks.size())));
  list_->setCurrentIndex(-1);
  list_->setEnabled(!marks.empty());
}

}  // namespace tactus::workbench
