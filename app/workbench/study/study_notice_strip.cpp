#include "app/workbench/study/study_notice_strip.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

StudyNoticeStrip::StudyNoticeStrip(StudyConnection& study, QWidget* parent)
    : Card(parent), study_(study), lines_(new QVBoxLayout(this)) {
  lines_->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  lines_->setSpacing(theme::kGrid);
  setColors(theme::warningFill(), theme::warningFill());
  hide();
  connect(&study_, &StudyConnection::noticesChanged, this, &StudyNoticeStrip::fill);
  // Another opening is another matter.
  connect(&study_, &StudyConnection::opened, this, [this] {
    closed_.clear();
    unfolded_ = false;
    fill();
  });
}

void StudyNoticeStrip::showAll() {
  closed_.clear();
  unfolded_ = true;
  fill();
}

void StudyNoticeStrip::fill() {
  while (QLayoutItem* item = lines_->takeAt(0)) {
    // A button of the line may be what led here.
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  shown_.clear();
  std::vector<StudyNotice> open;
  for (const StudyNotice& notice : study_.notices().now) {
    if (!closed_.contains(notice.sentence)) open.push_back(notice);
  }
  const std::size_t lines = unfolded_ ? open.size() : std::min<std::size_t>(open.size(), 1);
  for (std::size_t i = 0; i < lines; ++i) addLine(open[i], static_cast<int>(open.size() - lines));
  setVisible(!shown_.isEmpty());
}

void StudyNoticeStrip::addLine(const StudyNotice& notice, int more) {
  shown_ << notice.sentence;
  auto* line = new QWidget(this);
  auto* label = new QLabel(notice.sentence, line);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  setInk(*label, theme::warningInk());
  auto* layout = makeRow(line, {{label, 1}});
  if (notice.can_be_finished) {
    auto* finish = new QPushButton(study_.isErasing() ? tr("Erasing…") : tr("Finish the erasure"), line);
    finish->setEnabled(!study_.isErasing());
    finish->setToolTip(tr("Writes the file of the study anew, without what was removed"));
    connect(finish, &QPushButton::clicked, &study_, &StudyConnection::finishErasure);
    layout->addWidget(finish, 0, Qt::AlignVCenter);
  }
  if (more > 0) {
    auto* unfold = new QPushButton(tr("Show %n more", nullptr, more), line);
    connect(unfold, &QPushButton::clicked, this, [this] {
      unfolded_ = true;
      fill();
    });
    layout->addWidget(unfold, 0, Qt::AlignVCenter);
  }
  auto* close = new QToolButton(line);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message; the menu Study shows it again"));
  close->setAccessibleName(tr("Close this message"));
  close->setPalette(label->palette());
  connect(close, &QToolButton::clicked, this, [this, sentence = notice.sentence] {
    closed_ << sentence;
    fill();
  });
  layout->addWidget(close, 0, Qt::AlignVCenter);
  lines_->addWidget(line);
  line->show();  // at once: a layout alone would show it only with the next event
}

}  // namespace tactus::workbench
