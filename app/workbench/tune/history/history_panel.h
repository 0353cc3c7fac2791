// The history of the model: every state, branches included, with its effect on the force, its author and its time. The
// user can name states, record sign-offs by experts, compare any two states, and return to a state with a click. No
// state is ever lost.
#pragma once

#include <QStyledItemDelegate>
#include <QWidget>

#include "app/editing/edit_history.h"
#include "app/workbench/kit/cards.h"

class QComboBox;
class QLineEdit;
class QListView;
class QPushButton;
class QToolButton;
class QLabel;

namespace tactus::workbench {

class AuthorName;
class CompareController;
class EditController;
class HistoryModel;
class Refresh;
class SceneController;
class StatisticHelp;
enum class CompareSide;

// The card to choose two versions of the model, see how far their forces differ and where, and switch between them.

class CompareCard : public QWidget {
  Q_OBJECT

 public:
  CompareCard(CompareController& compare, SceneController& scene, QWidget* parent = nullptr);

 signals:
  /// A and B are to be felt without knowing which is which.
  void feelBlindRequested();
  /// The stroke that tells A from B is wanted.
  void tellRequested();

 private:
  void list();
  void fill(QComboBox& box, CompareSide side);
  void choose(const QComboBox& box, CompareSide side);
  void showResult();
  void showChanges();
  void goThere();

  CompareController& compare_;
  SceneController& scene_;
  QComboBox* a_;
  QComboBox* b_;
  QLabel* result_;
  StatisticHelp* help_;
  QLabel* place_;
  QPushButton* go_;
  QPushButton* blind_;
  QPushButton* tell_;
  QLabel* changes_;  ///< what differs between the models, a line each
  Refresh* refresh_list_;
  Refresh* refresh_result_;
};

// Paints a row of the history: its place in the tree, the change, the effect on the force, and its badges.

class HistoryDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit HistoryDelegate(const HistoryModel& model, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintTree(QPainter& painter, const QRect& area, int row) const;
  int paintBadges(QPainter& painter, const QRect& line, const QModelIndex& index) const;

  const HistoryModel& model_;
};

class HistoryPanel : public Card {
  Q_OBJECT

 public:
  HistoryPanel(EditController& edits, CompareController& compare, SceneController& scene, AuthorName& author,
               QWidget* parent = nullptr);

 public slots:
  /// Puts the keyboard focus into the field for a snapshot's name, for a sign-off, or for the author.
  void askSnapshot();
  void askSignOff();
  void askAuthor();

 signals:
  /// The user went to this state, which is the current one now.
  void visited(tactus::editing::StateId state);
  /// The user wants to look at the edits of this state on the open model.
  void carryAsked(tactus::editing::StateId state);
  /// A and B of the comparison are to be felt without knowing which is which.
  void feelBlindRequested();
  /// The stroke that tells A from B of the comparison is wanted.
  void tellRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showParts();
  void showSide(bool shown);
  QWidget* makeSide(CompareController& compare, SceneController& scene);
  void list();
  void visit(const QModelIndex& index);
  void listExperts();
  void takeSnapshot();
  void takeSignOff();
  void showFelt();
  void openMenu(const QPoint& at);

  EditController& edits_;
  CompareController& compare_;
  AuthorName& author_;
  HistoryModel* model_;
  QListView* view_;
  QWidget* versions_;
  QWidget* side_;
  QToolButton* switch_;  ///< switches between the two if the panel is too small for both
  bool side_asked_ = false;
  QLineEdit* snapshot_;
  QPushButton* name_it_;
  QComboBox* expert_;
  QPushButton* sign_off_;
  QLineEdit* author_field_;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
