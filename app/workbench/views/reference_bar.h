// Below the curves: how far the model is from each reference curve, and the button that takes one away.
#pragma once

#include <QWidget>

class QComboBox;
class QGridLayout;

namespace tactus::workbench {

class ReferenceController;
class SceneController;

class ReferenceBar : public QWidget {
  Q_OBJECT

 public:
  ReferenceBar(ReferenceController& references, const SceneController& scene, QWidget* parent = nullptr);

  /// Shows the differences as they are now.
  void showDifferences();

 private:
  void build();
  void listExperts();

  ReferenceController& references_;
  const SceneController& scene_;
  QWidget* rows_ = nullptr;
  QComboBox* against_;
  QList<class ElidedLabel*> texts_;
};

}  // namespace tactus::workbench
