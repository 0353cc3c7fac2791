// What the C source of one model is made of (c_source.h). Nothing outside this folder includes this.
#pragma once

#include <memory_resource>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/c_parts.h"

namespace tactus::exchange {

/// Writes the source of one model: what each expert needs, and from it the functions of the header.
class SourceWriter {
 public:
  SourceWriter(const fuzzy::ForceModel& model, const FixedInputs& fixed)
      : model_(model), fixed_(fixed), memberships_(model, fixed) {
    for (std::size_t e = 0; e < model.experts.size(); ++e) addExpert(e);
  }

  std::string header() const;
  std::string source() const;

 private:
  /// An expert whose centroid is the function of a group.
  struct Ordered {
    std::size_t group = 0;
    std::vector<Strength> strengths;
  };

  void addExpert(std::size_t index);
  std::size_t groupOf(const ExpertView& view, fuzzy::ClosedForm form, const std::vector<Strength>& strengths);
  bool isLarge() const;
  /// The experts that count.
  std::vector<std::size_t> counting() const;
  bool areOneGroup(const std::vector<std::size_t>& experts) const;
  std::string strengthFunction(std::size_t index, const Ordered& expert) const;
  std::string largest(const CentroidGroup& group, const std::string& at) const;
  std::string orderedFunctions(std::size_t index) const;
  std::string expertFunctions() const;
  std::string meanText() const;
  std::vector<std::size_t> membershipsOf(std::size_t input) const;
  std::size_t inputOfMostMemberships() const;
  std::optional<std::size_t> pivotFor(const std::vector<std::size_t>& experts) const;
  std::string stretchesText(const std::vector<std::size_t>& experts, std::size_t pivot) const;
  std::string stretchedText(const std::vector<std::size_t>& experts, std::size_t pivot) const;
  std::string sideBySideStart(const std::vector<std::size_t>& experts) const;
  std::string sideBySideCentroids(const std::vector<std::size_t>& experts) const;
  std::string oneByOneText(const std::vector<std::size_t>& experts) const;
  std::string sideBySideText(const std::vector<std::size_t>& experts) const;
  bool goesInBlocks(const std::vector<std::size_t>& experts) const;
  std::string batchText() const;
  std::string columnsText(std::string& point) const;
  std::string strengthsTogether(const std::vector<std::size_t>& experts) const;
  std::string blockText(const std::vector<std::size_t>& experts) const;
  std::string expertText() const;
  std::string share(std::size_t expert) const;

  const fuzzy::ForceModel& model_;
  const std::vector<double> weights_ = normalizedWeights(model_);  ///< of the experts
  const FixedInputs& fixed_;
  MembershipCode memberships_;
  std::pmr::monotonic_buffer_resource memory_;
  std::vector<CentroidGroup> groups_;
  std::vector<std::optional<Ordered>> ordered_;  ///< of each expert
  std::vector<std::string> walked_;              ///< the body of each other expert
  std::string tables_;
  std::size_t most_walked_ = 0;  ///< strengths of such an expert
  bool general_ = false;
  bool gaussian_ = false;
};

}  // namespace tactus::exchange
