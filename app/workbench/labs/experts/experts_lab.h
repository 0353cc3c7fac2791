// The experts' lab without widgets: the averaged model with its experts, what their weights change, and who pulls
// where.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/base/columns.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/model/expert_weights_compared.h"
#include "elicitation/uncertainty/force_bands.h"
#include "elicitation/uncertainty/own_words.h"

namespace tactus::workbench {

// How far the averaged force can be trusted along the curve: one of the bands "again", "others", "next" and "words"
// (elicitation/uncertainty/force_bands.h), made in batches in the background and refined while it is shown.

/// The force along one input under the own words of one participant.
struct OwnWordCurve {
  std::string participant;
  std::vector<std::optional<double>> forces_n;  ///< one per point of the band
};

/// A band along one input.
struct ShownBand {
  elicitation::BandKind kind = elicitation::BandKind::kOthers;
  std::vector<double> x;
  elicitation::ForceBand band;
  std::size_t done = 0;  ///< replicates
  std::size_t planned = 0;
  std::vector<OwnWordCurve> own_words;  ///< of the band "words": what it is made of
};

/// Thread: gui.
class BandLab : public QObject {
  Q_OBJECT

 public:
  explicit BandLab(QObject* parent = nullptr);

  /// What a band is made of.
  struct Curve {
    BuiltStudy built;
    std::size_t x_input = 0;
    std::vector<double> values;  ///< one per input
  };
  /// The curve around which the band lies; nothing: no model.
  void setCurve(std::optional<Curve> curve);
  /// Nothing: no band.
  void choose(std::optional<elicitation::BandKind> kind);
  const std::optional<elicitation::BandKind>& chosen() const { return chosen_; }
  /// The band so far; null while there is none.
  const ShownBand* shown() const { return band_.value().get(); }
  /// Why there is no band; empty if there is one, or none was chosen.
  const QString& failure() const { return band_.failure(); }
  /// Computes while it is held and one is chosen.
  Computation& work() { return band_; }

 signals:
  /// `shown` or `failure` changed.
  void changed();

 private:
  struct Order {
    Curve curve;
    elicitation::BandKind kind;
  };
  using Answer = Computed<Order, ShownBand>::Answer;
  static Answer compute(const Order& order, const RunOf<ShownBand>& run);
  std::optional<Order> order() const;

  std::optional<Curve> curve_;
  std::optional<elicitation::BandKind> chosen_;
  Computed<Order, ShownBand> band_;
};

/// `Again`, `Others`, `Next`, `Own words`, with what each means.
QString bandName(elicitation::BandKind kind);
QString bandMeaning(elicitation::BandKind kind);
/// What the band says and leaves out, for below the curve.
QString bandText(const ShownBand& shown);

/// One choice of weights beside equal ones.
struct ComparedWeights {
  elicitation::WeightPolicy policy = elicitation::WeightPolicy::kEqual;
  QString unavailable;  ///< why the study's data do not allow it; empty if they do
  std::vector<double> weights;
  analysis::ForceDifference from_equal;
  QString where;  ///< the place of the largest difference
};

/// Thread: gui.
class ExpertsLab : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  ExpertsLab(LabData& data, LabModel& model, QObject* parent = nullptr);

  /// The averaged model and what led to it; null if there is none.
  const std::shared_ptr<const elicitation::BuiltModel>& built() const { return built_; }
  /// Why there is no model; empty if there is one.
  const QString& failure() const { return model_.failure(); }
  const elicitation::WeightSettings& weights() const { return data_.settings().weights; }
  /// Each policy beside equal weights, as far as it is computed.
  const std::vector<ComparedWeights>& compared() const;
  Computation& work() { return compared_; }
  /// What the experts' words and what their rules do to the disagreement; computed while it is held.
  Computed<BuiltStudy, elicitation::WordsAndRules>& wordsAndRules() { return words_and_rules_; }
  /// The band around the averaged force along these curves.
  BandLab& bands() { return bands_; }
  const LabData& data() const { return data_; }

  /// Uses `policy` for the model. With kTable the experts keep the weights that they have.
  void setPolicy(elicitation::WeightPolicy policy);
  /// Gives one expert a weight >= 0 of the user's own; the others keep theirs. Not the last weight above 0.
  void setWeight(const std::string& expert, double weight);

  /// The inputs of the curve, one value each; that of the depth is not used.
  const std::vector<double>& values() const { return values_; }
  void setValue(std::size_t input, double value);
  /// The same by the id of the input. Ignored while there is no model, if it has no such input or not this value.
  void setValueOf(const std::string& input, double value);
  /// The input of the x axis: the depth.
  std::size_t xInput() const { return x_input_; }
  /// Along the depth at `values`; empty without a model.
  const figures::ForceCurves& curves() const;

  /// Computes while wanted.
  void setWanted(bool wanted);

 signals:
  /// The model, or what is compared, is another.
  void changed();
  void curvesChanged();
  void valueChanged(std::size_t input);

 private:
  /// The curve of the values through the model; nothing: no model.
  std::optional<BandLab::Curve> curve() const;
  void takeModel();

  LabData& data_;
  LabModel& model_;
  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::vector<double> values_;
  std::size_t x_input_ = 0;
  BandLab bands_;
  Computed<BuiltStudy, std::vector<ComparedWeights>> compared_;
  Computed<BandLab::Curve, figures::ForceCurves> curves_;
  Computed<BuiltStudy, elicitation::WordsAndRules> words_and_rules_;
};

/// One sentence: how far the experts lie apart, and what their words and their rules alone make of it.
QString wordsAndRulesText(const elicitation::WordsAndRules& found);

/// The distance of each expert from the mean along the curves, one list per expert; NaN where the expert abstains.
std::vector<std::vector<double>> pullsOf(const figures::ForceCurves& curves);

/// What an expert is apart from each one: root mean square in N where both have a rule, and where it is most.
struct DistanceRow {
  QString expert;
  std::vector<QString> distances, tips;  ///< empty from itself
};

/// Shows the distances between each two experts of `built`; null: none.
void showDistances(Columns<DistanceRow>& table, const elicitation::BuiltModel* built);

/// A weight policy beside equal weights, in newtons, as the screen shows it.
struct PolicyRow {
  QString policy, weights, largest, rms, where;
  QString unavailable;  ///< why it has no numbers; empty if it has
};

std::vector<Column<PolicyRow>> policyColumns();
std::vector<PolicyRow> policyRows(const std::vector<ComparedWeights>& compared);

/// `Equal`, `By years of experience`, …
QString policyName(elicitation::WeightPolicy policy);

}  // namespace tactus::workbench
