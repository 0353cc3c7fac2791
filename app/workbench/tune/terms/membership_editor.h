// The membership function editor: the terms of one variable, moved by mouse and keys or typed as numbers.
#pragma once

#include <string>

#include "app/workbench/base/messages.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QTabBar;
class QTimer;
class QToolButton;

namespace tactus::workbench {

class EditController;
class ElidedLabel;
class GhostController;
class MembershipEditorPlot;
class NotesButton;
class SceneController;
class TermController;
class TermSliders;
class TermTable;

class MembershipEditor : public Card {
  Q_OBJECT

 public:
  /// Draws the shapes that `ghost` has as "before" as thin outlines.
  MembershipEditor(EditController& edits, TermController& terms, SceneController& scene, const GhostController& ghost,
                   QWidget* parent = nullptr);

  /// What is odd in the data, and what the build from the answers says: shown beside the terms that it is about.
  void setNotes(BuildNotes notes);
  /// Whether there are records behind the vertices: a study is open.
  void setOriginsKnown(bool known);

 signals:
  /// The user asks where the selected vertex comes from: `point` of a term of the shown list.
  void originAsked(const std::string& variable, const std::string& term, std::size_t point);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildPlace();
  void connectAll();
  void showModel();
  void nameVariables();
  void showExperts();
  void showList();
  void showTerms();
  void showGhost();
  void showModes();
  void showScope();
  void showNotes();
  void askScope();
  void showLocks();
  void showSelection();
  void showValue();
  void showRefusal(const QString& sentence);
  void showHint();
  void askAdd();
  void askOrigin(std::size_t term, std::size_t point);
  PlotTable table();

  EditController& edits_;
  TermController& terms_;
  SceneController& scene_;
  const GhostController& ghost_;
  QTabBar* variables_;
  QComboBox* whose_;
  QCheckBox* own_;
  QLabel* scope_;
  QToolButton* for_one_;
  QToolButton* for_all_;
  QCheckBox* keeps_sum_;
  QToolButton* add_;
  NotesButton* notes_button_;
  QToolButton* origin_;
  BuildNotes notes_;
  MembershipEditorPlot* plot_;
  ElidedLabel* hint_;
  QTimer* hint_time_;
  TermSliders* sliders_;
  TermTable* table_;
  bool filling_ = false;
};

}  // namespace tactus::workbench
