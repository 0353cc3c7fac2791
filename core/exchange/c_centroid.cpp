// The centroid in C: polynomials in the strengths where the output terms have an order (core/fuzzy/closed_form.h), else
// a walk along the upper envelope.
#include <algorithm>
#include <array>
#include <functional>
#include <memory_resource>
#include <span>

#include "core/exchange/c_parts.h"
#include "core/fuzzy/closed_form.h"

namespace tactus::exchange {
namespace {

using fuzzy::ClosedForm;
using Polynomial = fuzzy::Polynomial<double>;

std::string strength(std::size_t term) { return "s" + std::to_string(term); }

/// The parts of a sum in C, each in a variable of its own, so that the processor can work at them side by side.
class Parts {
 public:
  /// Declares area and moment of one more part; `sign` is + or -.
  void add(char sign, const std::string& area, const std::function<std::string(const std::string& area)>& moment) {
    const std::string index = std::to_string(count_++);
    text_ += "  const double a" + index + " = " + area + ";\n";
    text_ += "  const double n" + index + " = " + moment("a" + index) + ";\n";
    (sign == '+' ? plus_ : minus_).push_back(index);
  }
  void declare(const std::string& name, const std::string& value) {
    text_ += "  const double " + name + " = " + value + ";\n";
  }
  std::size_t count() const { return count_; }

  std::string text() const {
    return text_ + "  *area = " + sum(plus_, "a") + rest("a") + ";\n  *moment = " + sum(plus_, "n") + rest("n") + ";\n";
  }

 private:
  std::string rest(const std::string& letter) const {
    return minus_.empty() ? std::string() : " - " + sum(minus_, letter);
  }

  /// A balanced tree of additions.
  static std::string sum(std::span<const std::string> indices, const std::string& letter) {
    if (indices.size() == 1) return letter + indices.front();
    const std::size_t half = indices.size() / 2;
    return "(" + sum(indices.first(half), letter) + " + " + sum(indices.subspan(half), letter) + ")";
  }

  std::string text_;
  std::size_t count_ = 0;
  std::vector<std::string> plus_;
  std::vector<std::string> minus_;
};

/// Area and moment of a trapezoid that is clipped at `t`.
void addClipped(const std::string& t, const Polynomial& f, char sign, Parts& parts) {
  parts.add(sign, t + " * (" + number(f.width) + " - " + t + " * " + number(f.half_taper) + ")",
            [&](const std::string& area) {
              if (f.linear == 0 && f.cubic == 0) return area + " * " + number(f.middle);
              return t + " * (" + number(f.width * f.middle) + " - " + t + " * (" +
                     number(f.half_taper * f.middle - f.linear) + " + " + t + " * " + number(f.cubic) + "))";
            });
}

void addClippedOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right,
                       const std::vector<std::string>& between, Parts& parts) {
  const std::string common = "t" + std::to_string(parts.count());
  std::string least = "lower(" + left + ", " + right + ")";
  // The common part of two trapezoids reaches 1 only where their cores meet.
  if (pair.overlap.peak < 1) least = "lower(" + least + ", " + number(pair.overlap.peak) + ")";
  parts.declare(common, least);
  addClipped(common, pair.overlap.shape, '-', parts);
  if (between.empty()) return;
  // Below the strength of the strongest term between, terms between cover the whole overlap.
  const std::string hidden = "t" + std::to_string(parts.count());
  parts.declare(hidden, "lower(" + common + ", " + tree(between, "larger") + ")");
  addClipped(hidden, pair.overlap.shape, '+', parts);
}

void addScaledOverlap(const ClosedForm::Pair& pair, const std::string& left, const std::string& right, Parts& parts) {
  const auto& overlap = pair.overlap;
  const double width = overlap.shape.width;
  const std::string index = std::to_string(parts.count());
  const std::string sum = "fall" + index + " + rise" + index;
  parts.declare("fall" + index, left + " * " + number(overlap.inverse_fall));
  parts.declare("rise" + index, right + " * " + number(overlap.inverse_rise));
  parts.declare("t" + index, "fall" + index + " / (" + sum + " > 0.0 ? " + sum + " : 1.0)");
  parts.add('-', "rise" + index + " * t" + index + " * " + number(width * width * 0.5), [&](const std::string& area) {
    return area + " * ((t" + index + " + 1.0) * " + number(width / 3) + " + " + number(overlap.start) + ")";
  });
}

}  // namespace

std::string centroidFunction(const fuzzy::ForceModel& model, const CentroidGroup& group, std::size_t index) {
  const bool clips = model.implication == fuzzy::Implication::kClip;
  const ClosedForm& form = group.form;
  std::array<std::size_t, fuzzy::kMostTerms> term_of{};  // of each lane
  std::array<bool, fuzzy::kMostTerms> live{};
  for (std::size_t t = 0; t < form.lane_of.size(); ++t) term_of[form.lane_of[t]] = t;
  for (const std::size_t term : group.live) live[form.lane_of[term]] = true;

  Parts parts;
  for (std::size_t lane = 0; lane < form.terms.size(); ++lane) {
    if (!live[lane]) continue;
    const std::string own = strength(term_of[lane]);
    const Polynomial& whole = form.terms[lane];
    if (clips) {
      addClipped(own, whole, '+', parts);
    } else {
      parts.add('+', own + " * " + number(whole.width),
                [&](const std::string&) { return own + " * " + number(whole.middle); });
    }
    for (std::uint32_t p = form.first_pair[lane]; p < form.first_pair[lane + 1]; ++p) {
      const ClosedForm::Pair& pair = form.pairs[p];
      if (!live[pair.left]) continue;
      const std::string left = strength(term_of[pair.left]);
      std::vector<std::string> between;
      for (std::size_t k = pair.left + 1U; k < lane; ++k) {
        if (live[k]) between.push_back(strength(term_of[k]));
      }
      if (clips) {
        addClippedOverlap(pair, left, own, between, parts);
      } else {
        addScaledOverlap(pair, left, own, parts);
      }
    }
  }
  std::string out =
      "PART void centroid_" + std::to_string(index) + "(const double *s, int n, double *area, double *moment) {\n";
  for (std::size_t k = 0; k < group.live.size(); ++k) {
    out += "  const double " + strength(group.live[k]) + " = s[" + std::to_string(k) + " * n];  /* " +
           comment(group.terms[group.live[k]].id) + " */\n";
  }
  return out + parts.text() + "}\n\n";
}

}  // namespace tactus::exchange
