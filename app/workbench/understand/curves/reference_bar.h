// The bar below the curves: the difference between the model and each reference curve, and a button to remove the
// curve.
#pragma once

#include <QWidget>

class QComboBox;
class QGridLayout;
class QLabel;

namespace tactus::workbench {

class ReferenceController;
class SceneController;

class ReferenceBar : public QWidget {
  Q_OBJECT

 public:
  ReferenceBar(ReferenceController& references, const SceneController& scene, QWidget* parent = nullptr);

  /// Shows the current differences.
  void showDifferences();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void build();
  void colorNames();
  void listExperts();

  ReferenceController& references_;
  const SceneController& scene_;
  QWidget* rows_ = nullptr;
  QComboBox* against_;
  QList<QLabel*> names_;
  QList<class ElidedLabel*> texts_;
};

}  // namespace tactus::workbench
