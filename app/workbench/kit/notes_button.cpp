#include "app/workbench/kit/notes_button.h"

#include <QFrame>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kWidth = 56 * theme::kGrid;    // px
constexpr int kHighest = 48 * theme::kGrid;  // px; more notes are scrolled

QLabel* sentence(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

NotesButton::NotesButton(QWidget* parent) : QToolButton(parent) {
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  hide();
  connect(this, &QToolButton::clicked, this, &NotesButton::showNotes);
}

void NotesButton::setNotes(const QString& title, const QStringList& notes) {
  title_ = title;
  notes_ = notes;
  setText(notes.size() == 1 ? tr("1 note") : tr("%1 notes").arg(notes.size()));
  setToolTip(tr("What the build from the answers says about this"));
  setAccessibleName(title + QStringLiteral(": ") + text());
  setVisible(!notes.isEmpty());
}

void NotesButton::showNotes() {
  auto* popup = new QFrame(this, Qt::Popup);
  popup->setAttribute(Qt::WA_DeleteOnClose);
  popup->setFrameShape(QFrame::StyledPanel);
  popup->setBackgroundRole(QPalette::Base);
  auto* head = sentence(title_, popup);
  head->setFont(theme::headingFont());
  auto* list = new QWidget;
  auto* lines = new QVBoxLayout(list);
  lines->setContentsMargins(0, 0, theme::kGrid, 0);
  lines->setSpacing(theme::kGrid);
  for (const QString& note : notes_) lines->addWidget(sentence(note, list));
  auto* scroll = new QScrollArea(popup);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setWidget(list);
  auto* layout = new QVBoxLayout(popup);
  layout->addWidget(head);
  layout->addWidget(scroll);
  popup->setFixedWidth(kWidth);
  const int high = list->heightForWidth(kWidth - 4 * theme::kGrid) + head->sizeHint().height() + 6 * theme::kGrid;
  popup->setFixedHeight(std::clamp(high, 8 * theme::kGrid, kHighest));
  const QRect room = screen()->availableGeometry();
  QPoint place = mapToGlobal(QPoint(0, height() + 4));
  place.setX(std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - popup->width())));
  place.setY(std::min(place.y(), std::max(room.top(), room.bottom() - popup->height())));
  popup->move(place);
  popup->show();
}

}  // namespace tactus::workbench
