// What the answer to an open question would tell about the force: an order of the questions by what is least known, and
// how well the force is known so far. Method, and how it was tried: docs/question-order.md.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"

namespace tactus::elicitation {

/// What is known of one participant's force after some answers.
struct ForceKnown {
  double sd_n = 0;  ///< standard deviation of the force, rms over the points of use, N
  /// Of each item of the form: the share of the variance of the force that its answer would remove, [0, 1]. 0 for an
  /// item with an answer, and for one about the way out, which is no rule.
  std::vector<double> shares;
  std::vector<std::size_t> expected;  ///< the word that is expected of each item; of an answered one its own
};

/// A belief about how one participant answers: a level on the scale of the force words for each item, normal, with what
/// items of the same region, condition or input have in common. Expected words are never answers: nothing stores them.
class AnswerBelief {
 public:
  /// `form`: of `about`; both are used in here alone. Returns an error for a procedure that makes no model.
  static base::Result<AnswerBelief> make(const procedure::Procedure& about, const study::Form& form);

  /// `words`: of each item of the form the index of its force word, from the smallest; nothing without an answer. The
  /// same words give the same numbers on every machine. About 10 ms for 45 items.
  ForceKnown known(std::span<const std::optional<std::size_t>> words) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace tactus::elicitation
