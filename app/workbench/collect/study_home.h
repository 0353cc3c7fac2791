// The home of a study: its participants, how far each has come, and what to do next.
#pragma once

#include <QStyledItemDelegate>
#include <QWidget>
#include <optional>

#include "app/workbench/base/messages.h"
#include "app/workbench/collect/collect_controller.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QTableView;

namespace tactus::workbench {

/// Draws the cells of the participants' table: a mark and a word for each step, so that no state is told by color
/// alone.
class StepDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

class Card;
class ElidedLabel;
class NotesButton;
class ParticipantTable;
class PrimaryButton;

class StudyHome : public QWidget {
  Q_OBJECT

 public:
  explicit StudyHome(CollectController& collect, QWidget* parent = nullptr);

  /// What is odd in the data of the study.
  void showData(const BuildNotes& notes);
  /// The participant of the selected row, or nothing.
  std::optional<study::RecordId> selected() const;
  void select(const study::RecordId& person);

 signals:
  /// The nurse's screens for `code`; empty: the screens ask for the code.
  void startAsked(const QString& code);
  /// The usability form for a clinical teacher, who gets a code of their own.
  void usabilityAsked();
  void protocolAsked();
  void keyAsked();
  void fillAsked();
  void setupAsked();
  /// The stage in which the answers become a model.
  void answersAsked();
  void recordAsked(const tactus::study::RecordId& person);
  void withdrawAsked(const tactus::study::RecordId& person);

 private:
  QWidget* makeHead();
  QWidget* makeInvitation();
  QWidget* makeFoot();
  void connectAll();
  void refreshState();
  void showSelection();
  bool wantsSetup() const;
  void showHints();
  void showAdded(const study::RecordId& person, const QString& code);

  CollectController& collect_;
  ParticipantTable* table_;
  ElidedLabel* name_;
  QLabel* summary_;
  NotesButton* data_;
  QPushButton* protocol_;
  QPushButton* add_;
  QPushButton* usability_;
  PrimaryButton* start_;
  Card* hint_;
  QLabel* hint_text_;
  QPushButton* hint_act_;
  QStackedWidget* pages_;  ///< the table, or the invitation where it is empty
  QTableView* view_;
  QLabel* chosen_;
  QPushButton* record_;
  QPushButton* withdraw_;
  std::optional<study::RecordId> newest_;  ///< added just now; its code is to be handed over
};

}  // namespace tactus::workbench
