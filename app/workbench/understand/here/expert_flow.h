// How the forces of the experts lead to the mean: one line per expert with the set of its rules, the centroid of the
// set, and the expert's share in the mean.
#pragma once

#include <QWidget>

namespace tactus::workbench {

class SceneController;

/// Shows the explanation of the scene; it copies nothing, so that hundreds of experts cost only what is in sight.
class ExpertFlow : public QWidget {
  Q_OBJECT

 public:
  explicit ExpertFlow(const SceneController& scene, QWidget* parent = nullptr);

  /// The explanation changed.
  void follow();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The user clicked the line of `expert`.
  void chosen(std::size_t expert);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void paintLine(QPainter& painter, std::size_t expert) const;
  QString strongestRule(std::size_t expert) const;

  std::size_t count() const;

  const SceneController& scene_;
};

}  // namespace tactus::workbench
