// What happened to the model: every state with what it did to the force, by whom and when, branches included; names for
// states, sign-offs by experts, and the comparison of any two. A click returns to a state; nothing is ever lost.
#pragma once

#include "app/workbench/kit/card.h"

class QComboBox;
class QLineEdit;
class QListView;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

class AuthorName;
class CompareController;
class EditController;
class HistoryModel;
class Refresh;
class SceneController;

class HistoryPanel : public Card {
  Q_OBJECT

 public:
  HistoryPanel(EditController& edits, CompareController& compare, SceneController& scene, AuthorName& author,
               QWidget* parent = nullptr);

 public slots:
  /// Puts the cursor where the current state is named, signed off, or where the author stands.
  void askSnapshot();
  void askSignOff();
  void askAuthor();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showParts();
  void showSide(bool shown);
  QWidget* makeSide(CompareController& compare, SceneController& scene);
  void list();
  void listExperts();
  void takeSnapshot();
  void takeSignOff();
  void openMenu(const QPoint& at);

  EditController& edits_;
  CompareController& compare_;
  AuthorName& author_;
  HistoryModel* model_;
  QListView* view_;
  QWidget* versions_;
  QWidget* side_;
  QToolButton* switch_;  ///< between the two, where there is no room for both
  bool side_asked_ = false;
  QLineEdit* snapshot_;
  QPushButton* name_it_;
  QComboBox* expert_;
  QPushButton* sign_off_;
  QLineEdit* author_field_;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
