// How far the averaged force can be trusted along the curve: one of the bands "again", "others" and "next"
// (elicitation/uncertainty/force_bands.h), made in batches in the background and refined while it is shown.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/lab_model.h"
#include "elicitation/uncertainty/force_bands.h"

namespace tactus::workbench {

/// A band along one input.
struct ShownBand {
  elicitation::BandKind kind = elicitation::BandKind::kOthers;
  std::vector<double> x;
  elicitation::ForceBand band;
  std::size_t done = 0;  ///< replicates
  std::size_t planned = 0;
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

/// `Again`, `Others`, `Next`, with what each means.
QString bandName(elicitation::BandKind kind);
QString bandMeaning(elicitation::BandKind kind);
/// What the band says and leaves out, for below the curve.
QString bandText(const ShownBand& shown);

}  // namespace tactus::workbench
