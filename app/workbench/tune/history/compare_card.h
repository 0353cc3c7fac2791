// The card to choose two versions of the model, see how far their forces differ and where, and switch between them.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class CompareController;
class Refresh;
class SceneController;
class StatisticHelp;
enum class CompareSide;

class CompareCard : public QWidget {
  Q_OBJECT

 public:
  CompareCard(CompareController& compare, SceneController& scene, QWidget* parent = nullptr);

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
  QLabel* changes_;  ///< what differs between the models, a line each
  Refresh* refresh_list_;
  Refresh* refresh_result_;
};

}  // namespace tactus::workbench
