#include "app/workbench/kit/notes_popup.h"

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

void showNotesPopup(QWidget& parent, const QPoint& corner, const QVector<NoteGroup>& groups) {
  auto* popup = new QFrame(&parent, Qt::Popup);
  popup->setObjectName(QStringLiteral("notes"));
  popup->setAttribute(Qt::WA_DeleteOnClose);
  popup->setFrameShape(QFrame::StyledPanel);
  popup->setBackgroundRole(QPalette::Base);
  auto* list = new QWidget;
  auto* lines = new QVBoxLayout(list);
  lines->setContentsMargins(0, 0, theme::kGrid, 0);
  lines->setSpacing(theme::kGrid);
  for (const NoteGroup& group : groups) {
    if (group.sentences.isEmpty()) continue;
    if (lines->count() > 0) lines->addSpacing(theme::kGrid);
    auto* head = sentence(group.heading, list);
    head->setFont(theme::headingFont());
    lines->addWidget(head);
    for (const QString& one : group.sentences) lines->addWidget(sentence(one, list));
  }
  lines->addStretch(1);
  auto* scroll = new QScrollArea(popup);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setWidget(list);
  // One background, that of the popup.
  scroll->viewport()->setAutoFillBackground(false);
  list->setAutoFillBackground(false);
  auto* layout = new QVBoxLayout(popup);
  layout->addWidget(scroll);
  popup->setFixedWidth(kWidth);
  const QMargins margins = layout->contentsMargins();
  const int inner = kWidth - margins.left() - margins.right() - 2 * popup->frameWidth();
  const int high = list->heightForWidth(inner) + margins.top() + margins.bottom() + 2 * popup->frameWidth();
  const QRect room = parent.screen()->availableGeometry();
  popup->setFixedHeight(std::min({high, kHighest, room.height()}));
  QPoint place = corner;
  place.setX(std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - popup->width())));
  place.setY(std::clamp(place.y(), room.top(), std::max(room.top(), room.bottom() - popup->height())));
  popup->move(place);
  popup->show();
  scroll->setFocus();  // for the arrow keys
}

}  // namespace tactus::workbench
