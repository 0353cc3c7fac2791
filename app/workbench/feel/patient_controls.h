// The conditions that a nurse can change during the placement: lubrication and neck flexion.
#pragma once

#include <QWidget>
#include <cstddef>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class FeelController;
class SceneController;

class PatientControls : public QWidget {
  Q_OBJECT

 public:
  PatientControls(SceneController& scene, FeelController& feel, QWidget* parent = nullptr);

 private:
  void build();
  void showValues();
  void onValue(std::size_t input);

  SceneController& scene_;
  FeelController& feel_;
  QLabel* lubrication_;
  QWidget* terms_;  ///< one button per term of the lubrication
  QHBoxLayout* terms_layout_;
  QButtonGroup* term_buttons_;
  QPushButton* neck_;
};

}  // namespace tactus::workbench
