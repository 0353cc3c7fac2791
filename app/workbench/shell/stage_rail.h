// The rail on the left: Collect, Understand, Tune, Agree, Deliver.
#pragma once

#include <QMap>
#include <QWidget>
#include <optional>

#include "app/workbench/shell/stage.h"

namespace tactus::workbench {

class StageButton;

class StageRail : public QWidget {
  Q_OBJECT

 public:
  explicit StageRail(QWidget* parent = nullptr);

  /// `stage` has a screen; the others are not shown.
  void show(Stage stage);
  /// Whether `stage` can be entered now.
  void setReady(Stage stage, bool ready);
  /// Marks the stage on the screen; nothing: none is, as in the Feel layout.
  void setStage(std::optional<Stage> stage);
  /// True: a narrow rail.
  void setCompact(bool compact);

 signals:
  /// The user chose `stage`, which can be entered.
  void chosen(tactus::workbench::Stage stage);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fitWidth();

  QMap<Stage, StageButton*> buttons_;
  bool compact_ = false;
};

}  // namespace tactus::workbench
