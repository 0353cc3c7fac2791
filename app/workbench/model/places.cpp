#include "app/workbench/model/places.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/patient.h"
#include "core/analysis/rule_table.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

std::vector<procedure::Figure> figuresOf(const procedure::Procedure* procedure, const fuzzy::ForceModel& model) {
  std::vector<procedure::Figure> out;
  if (procedure == nullptr) return out;
  const auto known = [&model](const std::string& id) { return inputNamed(model, id).has_value(); };
  const auto known_all = [&known](const procedure::Figure& figure) {
    return (figure.varied.empty() || known(figure.varied)) &&
           std::all_of(figure.map.begin(), figure.map.end(), known) &&
           std::all_of(figure.at.begin(), figure.at.end(), [&known](const auto& set) { return known(set.first); });
  };
  std::copy_if(procedure->figures.begin(), procedure->figures.end(), std::back_inserter(out), known_all);
  return out;
}

namespace {

double nearestPeak(const fuzzy::Term& term, const fuzzy::Variable& input, double from) {
  const auto function = fuzzy::MembershipFunction::of(term);
  const double low = std::max(function.gaussian ? function.mean : function.b, input.min);
  const double high = std::min(function.gaussian ? function.mean : function.c, input.max);
  // A core outside the universe leaves the end next to it.
  return low <= high ? std::clamp(from, low, high) : analysis::peakPosition(term, input.min, input.max);
}

}  // namespace

std::vector<double> pointOfRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                                std::span<const double> from) {
  std::vector<double> point(from.begin(), from.end());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Variable& input = model.inputs[i];
    for (const fuzzy::Condition& condition : rule.conditions) {
      if (condition.input != input.id) continue;
      const fuzzy::Term* const term = fuzzy::findTerm(fuzzy::termsFor(expert, input), condition.term);
      if (term != nullptr) point[i] = nearestPeak(*term, input, from[i]);
    }
  }
  return point;
}

QString rangesOutside(const fuzzy::ForceModel& model, const std::vector<analysis::InputRange>& region,
                      std::span<const double> values, std::size_t but) {
  QStringList out;
  for (std::size_t i = 0; i < region.size(); ++i) {
    if (i == but || (values[i] >= region[i].low && values[i] <= region[i].high)) continue;
    const fuzzy::Variable& input = model.inputs[i];
    out << labelOf(input) + QLatin1Char(' ') + rangeText(input, region[i].low, region[i].high);
  }
  return out.join(QStringLiteral(", "));
}

namespace {

QStringList wordsOf(const QString& text) {
  static const QRegularExpression kGap(QStringLiteral("[\\s;_]+|,(?=\\s|$)"));
  return text.toLower().split(kGap, Qt::SkipEmptyParts);
}

/// The words of a text that is typed, and how far they are read.
class Reader {
 public:
  Reader(const QString& typed, const fuzzy::ForceModel& model, std::span<const double> from)
      : words_(wordsOf(typed)), model_(model), set_(model.inputs.size()) {
    place_.point.assign(from.begin(), from.end());
  }

  std::optional<TypedPlace> read() {
    while (at_ < words_.size()) {
      if (!readPart()) return std::nullopt;
    }
    // A term alone is looked for as a term.
    if (place_.words.isEmpty() || (place_.words.size() == 1 && !any_number_)) return std::nullopt;
    return std::move(place_);
  }

 private:
  /// How many words from `at` on are `text`; 0: they are not.
  qsizetype matched(const QString& text, qsizetype at) const {
    const QStringList parts = wordsOf(text);
    return !parts.isEmpty() && words_.mid(at, parts.size()) == parts ? parts.size() : 0;
  }

  std::optional<std::size_t> readName() {
    std::optional<std::size_t> found;
    qsizetype longest = 0;
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      const fuzzy::Variable& input = model_.inputs[i];
      for (const QString& name : {labelOf(input), shortLabelOf(input), text(input.id)}) {
        if (const qsizetype length = matched(name, at_); length > longest) {
          longest = length;
          found = i;
        }
      }
    }
    at_ += longest;
    return found;
  }

  bool readPart() {
    const auto named = readName();
    if (at_ >= words_.size()) return false;
    return readNumber(named) || readTerm(named);
  }

  bool readNumber(std::optional<std::size_t> named) {
    // The unit stands at the number or behind it.
    static const QRegularExpression kNumber(QStringLiteral("^([+-]?[0-9]+(?:[.,][0-9]+)?)(\\D*)$"));
    const auto match = kNumber.match(words_[at_]);
    if (!match.hasMatch()) return false;
    const auto number = typedNumber(match.captured(1));
    if (!number) return false;
    const bool apart = match.captured(2).isEmpty() && at_ + 1 < words_.size();
    const QString unit = apart ? words_[at_ + 1] : match.captured(2);
    std::optional<std::size_t> input;
    bool has_unit = false;
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      if (unit.isEmpty() || unitText(model_.inputs[i].unit).toLower() != unit) continue;
      if (named && named != i) continue;
      if (has_unit) return false;  // of two inputs
      has_unit = true;
      input = i;
    }
    if (!has_unit) input = named;
    if (!input || (!apart && !unit.isEmpty() && !has_unit)) return false;
    const fuzzy::Variable& variable = model_.inputs[*input];
    if (*number < variable.min || *number > variable.max) return false;
    at_ += has_unit && apart ? 2 : 1;
    any_number_ = true;
    return set(*input, *number, quantityText(*number, variable.unit));
  }

  bool readTerm(std::optional<std::size_t> named) {
    struct Found {
      std::size_t input = 0;
      const fuzzy::Term* term = nullptr;
    };
    std::vector<Found> found;
    qsizetype longest = 1;
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      if (named && named != i) continue;
      for (const fuzzy::Term& term : model_.inputs[i].terms) {
        const qsizetype length = std::max(matched(labelOf(term), at_), matched(text(term.id), at_));
        if (length < longest) continue;
        if (length > longest) found.clear();
        longest = length;
        found.push_back({i, &term});
      }
    }
    if (found.empty()) return false;
    at_ += longest;
    if (found.size() > 1) {
      // `medium speed`
      const auto behind = readName();
      std::erase_if(found, [&](const Found& one) { return one.input != behind; });
      if (found.size() != 1) return false;
    }
    const fuzzy::Variable& variable = model_.inputs[found.front().input];
    return set(found.front().input, coreMiddle(variable, *found.front().term), labelOf(*found.front().term));
  }

  bool set(std::size_t input, double value, const QString& words) {
    if (set_[input]) return false;
    set_[input] = true;
    place_.point[input] = value;
    place_.words << shortLabelOf(model_.inputs[input]) + QLatin1Char(' ') + words;
    return true;
  }

  QStringList words_;
  const fuzzy::ForceModel& model_;
  qsizetype at_ = 0;
  TypedPlace place_;
  std::vector<bool> set_;
  bool any_number_ = false;
};

}  // namespace

std::optional<TypedPlace> typedPlace(const QString& typed, const fuzzy::ForceModel& model,
                                     std::span<const double> from) {
  return Reader(typed, model, from).read();
}

}  // namespace tactus::workbench
