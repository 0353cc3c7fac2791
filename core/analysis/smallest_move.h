// The nearest place along one input at which something about the mean of the experts has changed. Internal to the
// counterfactuals.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/expert_line.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The experts that count along one input, and their mean: first the force, measured from the lower end of its
/// universe, then the share of each word.
class MeanLine {
 public:
  MeanLine(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input,
           std::span<const double> point, std::span<const std::size_t> experts);

  /// The places at which a polynomial of some expert ends, and those at which a term has a vertical edge. Ascending.
  const std::vector<double>& places() const { return places_; }
  const std::vector<double>& edges() const { return edges_; }
  const std::vector<std::string>& words() const { return words_; }
  double width() const { return places_.back() - places_.front(); }

  /// The exact values at `x`; empty where all abstain.
  std::vector<double> at(double x) const;

  /// Takes the polynomials around `x`, which is no place. Returns false where all abstain.
  bool enter(double x);
  /// Bounds of the slopes of all polynomials taken.
  std::span<const double> slopes() const { return slopes_; }
  /// Their values: the force alone, or all.
  void polynomialsAt(double x, bool force_only, std::span<double> sums) const;

 private:
  struct Seat {
    ExpertLine line;
    double weight;
    std::vector<std::size_t> place;  ///< of each of its values among those of the mean
    std::size_t piece;               ///< where the search is
  };
  struct Moving {
    const ExpertLine::Piece* piece;
    const Seat* seat;
  };

  std::vector<Seat> seats_;
  std::vector<std::string> words_;
  std::vector<double> places_, edges_;
  double weights_ = 0;  ///< of those who fire around the place that was entered
  std::vector<double> slopes_;
  std::vector<double> constants_;  ///< the sums over those who do not vary there
  std::vector<Moving> moving_;     ///< the others
};

/// What a search looks for: that one of the excesses is 0 or more. They are sums of values of the mean, as shares of
/// the range of the force or of the area.
class Change {
 public:
  virtual ~Change() = default;
  virtual bool forceOnly() const = 0;
  virtual std::size_t excessCount() const = 0;
  virtual void excesses(std::span<const double> values, std::span<double> out) const = 0;
  /// Bounds of their slopes from those of the values.
  virtual void excessSlopes(std::span<const double> slopes, std::span<double> out) const = 0;
  /// Exactly at `x`. Not in a hole.
  virtual bool happened(double x) const = 0;
};

/// Branch and bound on the polynomials; what comes near is looked at exactly.
class MoveSearch {
 public:
  MoveSearch(MeanLine& line, const Change& change) : line_(line), change_(change) {}

  /// The nearest place from `now` on, in both directions, at which the change has happened.
  std::optional<double> nearest(double now);

 private:
  std::optional<double> along(double now, bool upward, double most);
  std::optional<double> firstWithin(double near, double far);
  std::optional<double> onlyCrossing(double near, double far);
  bool isWithinReach(double near, double far);
  void prepare();
  bool comesNear(double near, double far);
  double halvedFrom(double near, double after);
  double halved(double after) const;

  MeanLine& line_;
  const Change& change_;
  double before_ = 0;           ///< nearest place so far at which nothing has happened
  double varies_ = 0;           ///< how much the excesses that may reach 0 do in the stretch looked at
  double nearest_ = 0;          ///< the largest excess at its near end
  std::size_t candidates_ = 0;  ///< the number of excesses that may reach 0 there, and the last of them
  std::size_t candidate_ = 0;
  std::vector<double> values_, excesses_, highest_, lowest_;
  std::vector<double> at_nodes_;  ///< the excesses node by node
};

}  // namespace tactus::analysis
