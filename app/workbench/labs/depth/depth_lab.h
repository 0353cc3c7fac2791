// Depth from an image without widgets: the measurement of the open study, its image, and the terms that follow. Each
// change is stored as a new record; so is an undo.
#pragma once

#include <QByteArray>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/labs/data/lab_data.h"
#include "core/procedure/procedure.h"
#include "core/study/session_records.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {

/// Thread: gui.
class DepthLab : public UndoSource {
  Q_OBJECT

 public:
  /// `data` outlives this. `author`: who stores a change.
  DepthLab(LabData& data, std::function<QString()> author, QObject* parent = nullptr);

  /// Reads the stored measurement when the lab is seen first.
  void setSeen(bool seen);
  const elicitation::DepthMeasurement& measurement() const { return now_.measurement; }
  /// The bytes of the image's file; empty for none, and for the example.
  const QByteArray& image() const { return *now_.image; }
  /// The way of the study's procedure, with all its regions.
  const fuzzy::Variable& depth() const { return depth_; }
  /// The path through the points; nothing while there are fewer than two.
  const std::optional<elicitation::TubePath>& path() const { return path_; }
  /// The depth with its terms; the last possible ones if `problem` says why there are none.
  const fuzzy::Variable& terms() const { return terms_; }
  const QString& problem() const { return problem_; }
  bool isOpen() const { return data_.connection().isOpen(); }
  const session::ProcedurePtr& about() const { return data_.connection().procedure(); }
  /// Whether the study is about nasogastric tubes, for which there are formulas of the bedside.
  bool isOfPaper() const { return about() == procedure::defaultProcedure(); }
  /// Which depths the study's model has. `setDepthsFrom` is a setting of the labs, not of the measurement.
  elicitation::DepthsFrom depthsFrom() const { return data_.settings().depths; }
  void setDepthsFrom(elicitation::DepthsFrom from);
  /// There is a measurement that a model can have.
  bool isMeasured() const { return data_.settings().measured_depths.has_value() && problem_.isEmpty(); }

  /// Shows `measurement` without storing it: a gesture in progress.
  void show(const elicitation::DepthMeasurement& measurement);
  /// Stores what is shown as the next state; `what`: the change for the undo's text. Does nothing without a change.
  void commit(const QString& what);
  /// Takes another image; the way and the boundaries begin anew. `mm_per_px`: its scale where it is known.
  void setImage(const QByteArray& bytes, const QString& name, std::optional<double> mm_per_px = std::nullopt);
  /// The picture of the procedure, with the way in it.
  void setExample(double mm_per_px, std::vector<elicitation::ImagePoint> path);

  bool canUndo() const override { return done_ > 0; }
  bool canRedo() const override { return done_ + 1 < states_.size(); }
  QString undoText() const override { return canUndo() ? states_[done_].what : QString(); }
  QString redoText() const override { return canRedo() ? states_[done_ + 1].what : QString(); }

 public slots:
  void undo() override;
  void redo() override;

 signals:
  /// `depth` is that of another procedure; the measurement is empty then.
  void depthChanged();
  void measurementChanged();
  /// `depthsFrom` or `isMeasured` changed.
  void depthsFromChanged();
  /// Another image, or none.
  void imageChanged();
  /// One sentence: what was not read or not stored, and why; `act` helps.
  void refused(const QString& sentence, const tactus::workbench::MessageAct& act);
  /// It is read or stored now: what was refused before is out of date.
  void done();

 private:
  struct State {
    elicitation::DepthMeasurement measurement;
    std::shared_ptr<const QByteArray> image = std::make_shared<const QByteArray>();
    QString what{};
  };
  void read();
  void begin(State state);
  /// An empty measurement of the way of the study's procedure.
  void beginAnew();
  void go(std::size_t state);
  void refreshState();
  void store();
  void add(State next);

  LabData& data_;
  std::function<QString()> author_;
  fuzzy::Variable depth_;
  fuzzy::Variable terms_;
  std::optional<elicitation::TubePath> path_;
  QString problem_;
  State now_;
  std::vector<State> states_;  ///< at least one
  std::size_t done_ = 0;
  std::int64_t last_ms_ = 0;  ///< of the last record: the next one is later
  bool is_read_ = false;
  bool seen_ = false;
  /// The record that holds an image of this run of the program, with the image. Of the study's thread alone.
  struct Kept {
    std::shared_ptr<const QByteArray> image;
    study::RecordId record;
  };
  std::shared_ptr<std::vector<Kept>> kept_ = std::make_shared<std::vector<Kept>>();
};

}  // namespace tactus::workbench
