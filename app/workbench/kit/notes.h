// Notes and messages: their groups, the button, the popup, the banner.
#pragma once

#include <QString>
#include <QStringList>
#include <QToolButton>
#include <QVector>

#include "app/workbench/base/messages.h"
#include "app/workbench/kit/cards.h"
#include "core/fuzzy/force_model.h"

class QLabel;
class QObject;
class QPoint;
class QPushButton;
class QToolButton;
class QWidget;

namespace tactus::workbench {

/// A message above the panels that does not block the window: what did not happen and why, the button that helps, and a
/// close button.
class MessageBanner : public Card {
  Q_OBJECT

 public:
  explicit MessageBanner(QWidget* parent = nullptr);

  /// An error with a button for what helps, or two, which end the message: no error is without one. `from` can take it
  /// back.
  void showRemedy(const QString& sentence, MessageAct act, const QObject* from = nullptr, MessageAct other = {});
  /// Closes the error of `from`, if it is still shown.
  void takeBack(const QObject& from);
  void showNote(const QString& sentence);
  /// A note with a button for what can be done, or two.
  void showOffer(const QString& sentence, MessageAct act, MessageAct other = {});
  QString message() const;

 private:
  void show(const QString& sentence, const QColor& ink, const QColor& fill, const QColor& edge, MessageAct act = {},
            MessageAct other = {});

  QLabel* label_;
  QPushButton* buttons_[2];
  QToolButton* close_;
  MessageAct acts_[2];             ///< of the buttons
  const QObject* from_ = nullptr;  ///< who can take the message back; only compared
};

// Messages from a view to the user, wherever the view is in the window.

/// A window that shows messages. Views reach the window around them with `sayError` and `sayDone`.
class MessagePlace {
 public:
  virtual ~MessagePlace() = default;
  /// What did not happen, and why, with a button for what helps. The message stays until the user closes it or `from`
  /// takes it back.
  virtual void showError(const QString& sentence, MessageAct act, const QObject& from) = 0;
  /// Closes the error of `from`, if it is still shown.
  virtual void takeBackError(const QObject& from) = 0;
  /// A completed action. The strip shows it for some seconds.
  virtual void say(const QString& sentence) = 0;
};

/// Calls `showError` of the window around `from`; does nothing without one.
void sayError(QWidget& from, const QString& sentence, MessageAct act = {});
/// `from` succeeded or tries anew: its error is out of date. Does nothing without a window around it.
void takeBackError(QWidget& from);
/// Calls `say` of the window around `from`, whose error ends with it; does nothing without one.
void sayDone(QWidget& from, const QString& sentence);

/// Sentences in groups under headings, shown over the window until a click elsewhere or Esc; longer lists are scrolled.
struct NoteGroup {
  QString heading;  ///< above the sentences
  QStringList sentences;

  bool operator==(const NoteGroup&) const = default;
};

/// Groups without sentences are left out. `corner`: where its upper left corner shall be, in global coordinates; it is
/// kept on the screen of `parent`.
void showNotesPopup(QWidget& parent, const QPoint& corner, const QVector<NoteGroup>& groups);

// What there is to say about a study and its model, as groups for a NotesButton.

/// What is odd in the data.
NoteGroup dataGroup(const BuildNotes& notes);
/// What the build says.
NoteGroup buildGroup(const BuildNotes& notes);
/// Of both, what is about the terms of `variable`.
QVector<NoteGroup> groupsAbout(const BuildNotes& notes, const fuzzy::Variable& variable);
/// What happened to a study: the notices of this opening and the incidents of earlier openings.
QVector<NoteGroup> noticeGroups(const StudyNotices& notices);

/// All sentences in `groups`.
qsizetype countOf(const QVector<NoteGroup>& groups);

/// A button that shows the number of notes and opens their list below itself.
class NotesButton : public QToolButton {
  Q_OBJECT

 public:
  explicit NotesButton(QWidget* parent = nullptr);

  /// Shows `groups` under `words`, the text of the button, in the ink of warnings where `warns`. Without a sentence in
  /// them the button is hidden.
  void setNotes(const QString& words, const QVector<NoteGroup>& groups, bool warns = false);
  /// `1 note`, `12 notes`: what the words can be.
  static QString counted(qsizetype notes);
  const QVector<NoteGroup>& notes() const { return groups_; }
  /// Whether there is a sentence in them.
  bool hasNotes() const;

 private:
  void showNotes();

  QVector<NoteGroup> groups_;
  bool warns_ = false;
};

}  // namespace tactus::workbench
