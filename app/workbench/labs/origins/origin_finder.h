// Answers where a number comes from, and how far each record behind it moves the averaged force. Both are computed on
// another thread; the influences come one after another.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/record_influence.h"
#include "elicitation/tracing/sources.h"

namespace tactus::workbench {

// Where a number of a model comes from: the trials and answers of the study behind it, as rows for the screen.

/// Vertex `point` of a term of the shared list. `shown`: its value where it was asked about; empty: in the study's
/// model.
struct VertexQuestion {
  std::string variable;
  std::string term;
  std::size_t point = 0;
  std::optional<double> shown = {};
};

/// The votes at a force, for one word or for all of them (empty).
struct VoteQuestion {
  double force_n = 0;
  std::string word;
};

/// A rule of an expert, found by its conditions: an edited model counts its rules in another way.
struct RuleQuestion {
  std::string expert;
  fuzzy::Rule rule;
};

/// The averaged force at a point. `shown_n`: as it was asked about.
struct ForceQuestion {
  std::vector<double> inputs;
  std::optional<double> shown_n = {};
};

using OriginQuestion = std::variant<VertexQuestion, VoteQuestion, RuleQuestion, ForceQuestion>;

/// One record behind the number.
struct OriginRecord {
  enum class Kind { kStroke, kJudgement, kAnswer, kGivenRule };

  Kind kind = Kind::kStroke;
  elicitation::StrokeKey stroke;                    ///< of kStroke
  std::size_t index = 0;                            ///< in Study::judgements, answers or rules
  std::optional<elicitation::RulePlace> rule = {};  ///< that an answer or a given rule became
  QString participant;
  QString what;  ///< `fast, stroke 2`, `0.4 N, step 4`, `item 12`
  QString says;  ///< `mean 54 mm/s`, `Large`
};

struct Origin {
  QString title;      ///< the number: `Speed, Medium: left foot 51.5 mm/s`
  QStringList notes;  ///< sentences: other values on the screen, parts without records, simulated data
  std::vector<OriginRecord> records;
};

/// `built` was made from `study` with `settings`. Thread: any.
Origin originOf(const OriginQuestion& question, const elicitation::BuiltModel& built, const LabStudy& study,
                const elicitation::BuildSettings& settings);

/// What the averaged force would be without a record of an Origin. Thread: any.
base::Result<elicitation::RecordInfluence> influenceOf(const OriginRecord& record, const elicitation::BuiltModel& built,
                                                       const LabStudy& study,
                                                       const elicitation::BuildSettings& settings);

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
  const Origin* origin() const { return origin_.value().get(); }
  /// Why there is no answer; empty if there is one, or it is on its way.
  QString failure() const;
  /// What record `row` moves; nothing while it is not known.
  Influence influence(std::size_t row) const { return row < influences_.size() ? influences_[row] : Influence(); }
  /// Compares this record next.
  void askInfluence(std::size_t row);
  /// The sentence about what a record moves; empty while it is not known.
  QString influenceSentence(std::size_t row) const;
  bool isBusy() const { return origin_.isBusy() || moved_.isBusy() || model_.isBusy(); }

 signals:
  /// `origin` or `failure` changed.
  void changed();
  void influenceChanged(std::size_t row);

 private:
  struct Asked {
    OriginQuestion question;
    BuiltStudy built;
  };
  struct Moved {
    std::size_t row = 0;
    base::Result<elicitation::RecordInfluence> influence;
  };
  struct Compared {
    std::size_t row = 0;
    std::shared_ptr<const Origin> origin;
    std::shared_ptr<const Asked> of;
  };
  void setAsked(std::optional<OriginQuestion> question, const QString& not_of_study);
  std::optional<std::size_t> nextRow();

  LabData& data_;
  LabModel& model_;
  std::optional<OriginQuestion> question_;
  QString not_of_study_;
  std::vector<Influence> influences_;
  std::optional<std::size_t> wanted_;  ///< the record to compare next
  Computed<Asked, Origin> origin_;
  Computed<Compared, Moved> moved_;  ///< one after another
};

}  // namespace tactus::workbench
