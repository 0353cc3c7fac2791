// Marked moments of feeling a model: each keeps the place of the tip, its speed, the conditions, the force and the
// version of the model; a return brings all of that back.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/study/record_id.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

class FeelController;
class FeelStore;
class SceneController;
class StudyConnection;

/// Thread: gui.
class FeelMarks : public QObject {
  Q_OBJECT

 public:
  FeelMarks(FeelController& feel, SceneController& scene, StudyConnection& study, FeelStore& store,
            QObject* parent = nullptr);

  /// Those of the open study and of this run of the program, oldest first.
  const std::vector<study::FeelMark>& marks() const { return marks_; }
  /// `132 mm · 0.42 N · NGT averaged`.
  QString textOf(const study::FeelMark& mark) const;

 public slots:
  /// Marks what the hand feels now. Without a study the mark ends with the program. Refused while the hand does not
  /// hold the tube.
  void mark();
  /// Moves the operating point and the conditions to a mark; while the device runs, the tube too.
  void returnTo(std::size_t index);

 signals:
  /// Other marks.
  void changed();
  void said(const QString& sentence);
  /// Back at a mark, whose model gave another force than the one on the screen. `version`: the one that was felt, if
  /// the study keeps it.
  void differs(const QString& sentence, const std::optional<tactus::study::RecordId>& version);

 private:
  void readStudy();

  FeelController& feel_;
  SceneController& scene_;
  StudyConnection& study_;
  FeelStore& store_;
  study::RecordIds ids_;
  std::vector<study::FeelMark> marks_;
};

}  // namespace tactus::workbench
