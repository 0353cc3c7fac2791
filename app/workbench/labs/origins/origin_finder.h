// Answers where a number comes from, and how far each record behind it moves the averaged force. Both are computed on
// another thread; the influences come one after another.
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/labs/data/lab_model.h"
#include "app/workbench/labs/origins/origin.h"

namespace tactus::workbench {

/// Thread: gui.
class OriginFinder : public QObject {
  Q_OBJECT

 public:
  using Influence = std::optional<base::Result<elicitation::RecordInfluence>>;
  /// So many records are compared without being asked for; each takes the time of a comparison of two models.
  static constexpr std::size_t kMostUnasked = 64;

  /// Both outlive this.
  OriginFinder(LabData& data, LabModel& model, QObject* parent = nullptr);

  /// Asks about a number. `not_of_study`: one sentence where the number does not belong to a model of the open study;
  /// then there are no records. Until `close`, the answer follows the study and the settings.
  void ask(OriginQuestion question, const QString& not_of_study = {});
  void close();
  bool isAsked() const { return question_.has_value(); }

  /// Null while it is computed, or if nothing is asked.
  const Origin* origin() const { return origin_.get(); }
  const std::shared_ptr<const Origin>& sharedOrigin() const { return origin_; }
  /// Why there is no answer; empty if there is one, or it is on its way.
  QString failure() const;
  /// What record `row` moves; nothing while it is not known.
  Influence influence(std::size_t row) const { return row < influences_.size() ? influences_[row] : Influence(); }
  /// Compares this record next.
  void askInfluence(std::size_t row);
  /// The sentence about what a record moves; empty while it is not known.
  QString influenceSentence(std::size_t row) const;
  bool isBusy() const { return work_.isBusy() || influence_work_.isBusy() || model_.work().isBusy(); }

 signals:
  /// `origin` or `failure` changed.
  void changed();
  void influenceChanged(std::size_t row);

 private:
  void find();
  void compareNext();

  LabData& data_;
  LabModel& model_;
  std::optional<OriginQuestion> question_;
  QString not_of_study_;
  std::shared_ptr<const Origin> origin_;
  std::shared_ptr<const elicitation::BuiltModel> of_;  ///< what `origin_` was made from, with the next two
  std::shared_ptr<const LabStudy> study_;
  elicitation::BuildSettings settings_;
  std::vector<Influence> influences_;
  std::optional<std::size_t> wanted_;  ///< the record to compare next
  Background work_;
  Background influence_work_;
};

}  // namespace tactus::workbench
