#include "app/workbench/kit/notes.h"

#include <QCoreApplication>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "core/base/error.h"

namespace tactus::workbench {

MessageBanner::MessageBanner(QWidget* parent)
    : Card(parent),
      label_(new QLabel(this)),
      buttons_{new QPushButton(this), new QPushButton(this)},
      close_(new QToolButton(this)) {
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setText(QStringLiteral("✕"));
  close_->setAutoRaise(true);
  close_->setToolTip(tr("Close this message"));
  close_->setAccessibleName(tr("Close this message"));

  auto* layout =
      makeRow(this, {{label_, 1}}, theme::kGrid, {2 * theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2});
  for (QPushButton* button : buttons_) layout->addWidget(button, 0, Qt::AlignVCenter);
  layout->addWidget(close_, 0, Qt::AlignVCenter);
  hide();

  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  for (int i = 0; i < 2; ++i) {
    connect(buttons_[i], &QPushButton::clicked, this, [this, i] {
      hide();
      // The act may show the next message.
      if (const auto run = acts_[i].run) run();
    });
  }
}

void MessageBanner::showRemedy(const QString& sentence, MessageAct act, const QObject* from, MessageAct other) {
  show(sentence, theme::errorInk(), theme::errorFill(), theme::errorFill(), std::move(act), std::move(other));
  from_ = from;
}

void MessageBanner::takeBack(const QObject& from) {
  if (from_ == &from) hide();
}

void MessageBanner::showOffer(const QString& sentence, MessageAct act, MessageAct other) {
  show(sentence, theme::ink(), theme::card(), theme::accent(), std::move(act), std::move(other));
}

void MessageBanner::showNote(const QString& sentence) { show(sentence, theme::ink(), theme::card(), theme::accent()); }

QString MessageBanner::message() const { return label_->text(); }

void MessageBanner::show(const QString& sentence, const QColor& ink, const QColor& fill, const QColor& edge,
                         MessageAct act, MessageAct other) {
  from_ = nullptr;
  QPalette colors = label_->palette();
  colors.setColor(QPalette::WindowText, ink);
  label_->setPalette(colors);
  close_->setPalette(colors);
  label_->setText(text(base::plainLines(sentence.toStdString())));
  acts_[0] = std::move(act);
  acts_[1] = std::move(other);
  for (int i = 0; i < 2; ++i) {
    buttons_[i]->setText(acts_[i].text);
    buttons_[i]->setVisible(!acts_[i].text.isEmpty());
  }
  setColors(fill, edge);
  setVisible(true);
}

namespace {

// A panel that was taken out of the window is a window of its own, below the main one all the same.
MessagePlace* placeAround(QWidget& view) {
  for (QWidget* widget = &view; widget; widget = widget->parentWidget()) {
    if (auto* place = dynamic_cast<MessagePlace*>(widget)) return place;
  }
  return nullptr;
}

}  // namespace

void sayError(QWidget& from, const QString& sentence, MessageAct act) {
  if (MessagePlace* place = placeAround(from)) place->showError(sentence, std::move(act), from);
}

void takeBackError(QWidget& from) {
  if (MessagePlace* place = placeAround(from)) place->takeBackError(from);
}

void sayDone(QWidget& from, const QString& sentence) {
  takeBackError(from);
  if (MessagePlace* place = placeAround(from)) place->say(sentence);
}

NotesButton::NotesButton(QWidget* parent) : QToolButton(parent) {
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  hide();
  connect(this, &QToolButton::clicked, this, &NotesButton::showNotes);
}

QString NotesButton::counted(qsizetype notes) { return tr("%n note(s)", nullptr, static_cast<int>(notes)); }

void NotesButton::setNotes(const QString& words, const QVector<NoteGroup>& groups, bool warns) {
  if (words == text() && groups == groups_ && warns == warns_) return;
  groups_ = groups;
  warns_ = warns;
  setText(words);
  QStringList headings;
  for (const NoteGroup& group : groups) {
    if (!group.sentences.isEmpty()) headings << group.heading;
  }
  setToolTip(headings.join(QStringLiteral(" · ")));
  setAccessibleName(words);
  setAccessibleDescription(toolTip());
  QPalette colors;
  if (warns) colors.setColor(QPalette::ButtonText, theme::warningInk());
  setPalette(colors);
  setVisible(!headings.isEmpty());
}

bool NotesButton::hasNotes() const {
  return std::any_of(groups_.begin(), groups_.end(), [](const NoteGroup& one) { return !one.sentences.isEmpty(); });
}

void NotesButton::showNotes() { showNotesPopup(*this, mapToGlobal(QPoint(0, height() + 4)), groups_); }

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
  auto* lines = makeColumn(list, {}, theme::kGrid, {0, 0, theme::kGrid, 0});
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

namespace {

struct NoteGroups {
  Q_DECLARE_TR_FUNCTIONS(NoteGroups)
};

QStringList sentencesOf(const std::vector<BuildNote>& notes) {
  QStringList out;
  for (const BuildNote& note : notes) out << note.sentence;
  return out;
}

QStringList sentencesAbout(const std::vector<BuildNote>& notes, const std::string& variable) {
  QStringList out;
  for (const BuildNote& note : notes) {
    if (note.subject == variable) out << note.sentence;
  }
  return out;
}

}  // namespace

NoteGroup dataGroup(const BuildNotes& notes) {
  return {NoteGroups::tr("Look at the data first"), sentencesOf(notes.data)};
}

NoteGroup buildGroup(const BuildNotes& notes) {
  return {NoteGroups::tr("Notes of the build"), sentencesOf(notes.build)};
}

QVector<NoteGroup> groupsAbout(const BuildNotes& notes, const fuzzy::Variable& variable) {
  const QString label = labelOf(variable);
  return {{NoteGroups::tr("Look at the data first: %1").arg(label), sentencesAbout(notes.data, variable.id)},
          {NoteGroups::tr("Notes of the build: %1").arg(label), sentencesAbout(notes.build, variable.id)}};
}

QVector<NoteGroup> noticeGroups(const StudyNotices& notices) {
  QStringList now;
  for (const StudyNotice& notice : notices.now) now << notice.sentence;
  return {{NoteGroups::tr("What happened to the study"), now},
          {NoteGroups::tr("Found when it was opened earlier"), notices.before}};
}

qsizetype countOf(const QVector<NoteGroup>& groups) {
  qsizetype count = 0;
  for (const NoteGroup& group : groups) count += group.sentences.size();
  return count;
}

}  // namespace tactus::workbench
