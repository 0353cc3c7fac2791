#include "app/editing/rebase.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "core/analysis/term_conversion.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/fuzzy/validate.h"

namespace tactus::editing {
namespace {

using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Shape;
using fuzzy::Term;
using fuzzy::Variable;
using Outcome = CarriedEdit::Outcome;

using Group = std::vector<std::size_t>;  // indices of parts, ascending

constexpr auto kNothingToDo = "The new model has it already: nothing to do.";

std::vector<const ModelPart*> partsOf(const std::vector<ModelPart>& parts, const Group& group) {
  std::vector<const ModelPart*> out;
  for (const std::size_t p : group) out.push_back(&parts[p]);
  return out;
}

bool isVertexOf(const ModelPart& part, const TermListId& list) {
  return part.kind == PartKind::kVertex && part.list == list;
}

/// Whether a term comes or goes with the part.
bool isStructure(const ModelPart& part) { return part.kind == PartKind::kTerm && (!part.from || !part.to); }

const Rule* ruleOf(const std::optional<PartValue>& value) { return value ? std::get_if<Rule>(&*value) : nullptr; }

bool overlap(const Term& one, const Term& other) {
  const auto [low, high] = std::minmax_element(one.points.begin(), one.points.end());
  const auto [from, to] = std::minmax_element(other.points.begin(), other.points.end());
  return *low <= *to && *from <= *high;
}

/// Puts together which parts make one edit.
class Grouping {
 public:
  Grouping(const ForceModel& base, const std::vector<ModelPart>& parts)
      : base_(base), after_(base), parts_(parts), up_(parts.size()) {
    std::iota(up_.begin(), up_.end(), std::size_t{0});
    std::vector<const ModelPart*> unnamed;
    for (const ModelPart& part : parts_) {
      if (part.kind != PartKind::kTermName) unnamed.push_back(&part);
    }
    put(after_, unnamed);
  }

  /// The tuned version with the names of the base.
  const ForceModel& after() const { return after_; }

  std::vector<Group> groups() {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].kind == PartKind::kVertex) joinVertex(p);
      if (isStructure(parts_[p])) joinStructure(p);
      if (parts_[p].kind == PartKind::kOwnTerms) joinOwnTerms(p);
      if (!parts_[p].copy_of.empty()) joinCopy(p);
    }
    joinDependent();
    return all();
  }

 private:
  std::size_t rootOf(std::size_t part) {
    while (up_[part] != part) part = up_[part] = up_[up_[part]];
    return part;
  }
  void join(std::size_t one, std::size_t other) {
    const std::size_t first = rootOf(one);
    const std::size_t second = rootOf(other);
    up_[std::max(first, second)] = std::min(first, second);
  }

  /// The order of a list that is a partition before and after; nothing for any other.
  std::optional<std::vector<std::string>> partition(const TermListId& list, const ForceModel& model) const {
    const Variable& variable = **findVariable(model, list.variable);
    const std::vector<Term>* const terms = termsIn(model, list);
    if (terms == nullptr) return std::nullopt;
    const auto order = analysis::partitionOrder(variable, *terms);
    if (!order) return std::nullopt;
    std::vector<std::string> out;
    for (const std::size_t t : *order) out.push_back((*terms)[t].id);
    return out;
  }

  /// In a partition the ramps that the vertex belongs to, by the terms at their sides; else its term.
  std::vector<std::string> seatsOf(const ModelPart& part) {
    const auto found = orders_.find({part.list.variable, part.list.expert});
    const auto& order =
        found != orders_.end()
            ? found->second
            : orders_.emplace(std::pair(part.list.variable, part.list.expert), orderOf(part.list)).first->second;
    if (!order) return {part.key};
    const auto at = static_cast<std::size_t>(std::find(order->begin(), order->end(), part.key) - order->begin());
    const std::size_t last = findTerm(*termsIn(base_, part.list), part.key)->points.size() - 1;
    std::vector<std::string> out;
    if (part.point <= 1) out.push_back("ramp " + std::to_string(at));
    if (part.point + 1 >= last) out.push_back("ramp " + std::to_string(at + 1));
    return out;
  }

  std::optional<std::vector<std::string>> orderOf(const TermListId& list) const {
    auto order = partition(list, base_);
    return order && order == partition(list, after_) ? order : std::nullopt;
  }

  void joinVertex(std::size_t p) {
    const ModelPart& part = parts_[p];
    for (const std::string& seat : seatsOf(part)) {
      const auto [found, is_new] = seats_.try_emplace({part.list.variable, part.list.expert, seat}, p);
      if (!is_new) join(found->second, p);
    }
  }

  void joinStructure(std::size_t p) {
    const ModelPart& part = parts_[p];
    const ForceModel& with = part.from ? base_ : after_;
    const Term& term = *findTerm(*termsIn(with, part.list), part.key);
    const auto order = partition(part.list, with);
    const auto isNeighbor = [&](const std::string& id) {
      if (!order) return false;
      const auto at = std::find(order->begin(), order->end(), part.key);
      return (at != order->begin() && *std::prev(at) == id) || (std::next(at) != order->end() && *std::next(at) == id);
    };
    for (std::size_t q = 0; q < parts_.size(); ++q) {
      const ModelPart& other = parts_[q];
      if (isVertexOf(other, part.list) && isNeighbor(other.key)) join(p, q);
      if (isStructure(other) && other.list == part.list && other.from.has_value() != part.from.has_value()) {
        const ForceModel& has = other.from ? base_ : after_;
        if (overlap(term, *findTerm(*termsIn(has, part.list), other.key))) join(p, q);
      }
      if (other.kind == PartKind::kEvent && other.list == part.list && other.key == part.key) join(p, q);
      if (other.kind == PartKind::kRule && readsIn(with, other.expert, part.list) && namesTerm(other, part)) join(p, q);
    }
  }

  static bool readsIn(const ForceModel& model, const std::string& expert, const TermListId& list) {
    const auto found = findExpert(model, expert);
    return found && reads(**found, list);
  }

  bool namesTerm(const ModelPart& rule, const ModelPart& term) const {
    const Variable& variable = **findVariable(base_, term.list.variable);
    const auto in = [&](const Rule* one) { return one != nullptr && names(*one, base_, variable, term.key); };
    return in(ruleOf(rule.from)) || in(ruleOf(rule.to));
  }

  // The rules with a term that only one of the two lists has.
  void joinOwnTerms(std::size_t p) {
    const ModelPart& part = parts_[p];
    const Variable& variable = **findVariable(base_, part.list.variable);
    const auto before = termsFor(**findExpert(base_, part.expert), variable);
    const auto after = termsFor(**findExpert(std::as_const(after_), part.expert),
                                **findVariable(std::as_const(after_), part.list.variable));
    for (std::size_t q = 0; q < parts_.size(); ++q) {
      const ModelPart& other = parts_[q];
      if (other.kind != PartKind::kRule || other.expert != part.expert) continue;
      const auto namesLone = [&](const Rule* rule, const std::vector<Term>& own, const std::vector<Term>& others) {
        return rule != nullptr && std::any_of(own.begin(), own.end(), [&](const Term& term) {
                 return findTerm(others, term.id) == nullptr && names(*rule, base_, variable, term.id);
               });
      };
      if (namesLone(ruleOf(other.from), before, after) || namesLone(ruleOf(other.to), after, before)) join(p, q);
    }
  }

  void joinCopy(std::size_t p) {
    for (std::size_t q = 0; q < parts_.size(); ++q) {
      if (parts_[q].kind == PartKind::kRule && parts_[q].expert == parts_[p].expert &&
          parts_[q].key == parts_[p].copy_of) {
        join(p, q);
      }
    }
  }

  // What does not make sense alone belongs together: first vertices of one list, then all of that kind, then
  // everything.
  void joinDependent() {
    const auto joinAll = [&](const std::vector<std::size_t>& roots) {
      for (const std::size_t root : roots) join(roots.front(), root);
    };
    for (const std::size_t root : wrongAlone()) {
      if (parts_[root].kind != PartKind::kVertex) continue;
      for (std::size_t q = 0; q < parts_.size(); ++q) {
        if (isVertexOf(parts_[q], parts_[root].list)) join(root, q);
      }
    }
    joinAll(wrongAlone());
    if (wrongAlone().empty()) return;
    std::vector<std::size_t> every(parts_.size());
    std::iota(every.begin(), every.end(), std::size_t{0});
    joinAll(every);
  }

  std::vector<std::size_t> wrongAlone() {
    std::vector<std::size_t> out;
    for (const Group& group : all()) {
      ForceModel made = base_;
      put(made, partsOf(parts_, group));
      if (!fuzzy::validate(made)) out.push_back(group.front());
    }
    return out;
  }

  std::vector<Group> all() {
    std::map<std::size_t, Group> by_root;
    for (std::size_t p = 0; p < parts_.size(); ++p) by_root[rootOf(p)].push_back(p);
    std::vector<Group> out;
    for (auto& [root, group] : by_root) out.push_back(std::move(group));
    return out;
  }

  const ForceModel& base_;
  ForceModel after_;
  const std::vector<ModelPart>& parts_;
  std::vector<std::size_t> up_;
  std::map<std::pair<std::string, std::string>, std::optional<std::vector<std::string>>> orders_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> seats_;
};

/// Tries edits on one model.
class Trial {
 public:
  Trial(const ForceModel& base, const Rebase& rebase, std::span<const VertexPlace> locked)
      : base_(base), target_(rebase.named), parts_(rebase.parts), names_(rebase.names), locked_(locked) {
    for (const ModelPart& part : parts_) {
      if (!part.copy_of.empty()) copied_.insert(part.expert + '/' + part.copy_of);
    }
  }

  /// Tries the edit of `group` on the target and writes into `out` whether it applies, or why not.
  void run(const Group& group, CarriedEdit& out) const {
    std::string reason;
    bool has_name = false;
    for (const std::size_t p : group) {
      if (std::count(names_.begin(), names_.end(), p) > 0) {
        has_name = true;
        continue;
      }
      const auto why = whyNot(parts_[p]);
      if (!why) out.parts.push_back(p);
      if (why && reason.empty()) reason = *why;
    }
    ForceModel made = target_;
    put(made, partsOf(parts_, out.parts));
    if (editing::sameBits(made, target_)) {
      if (reason.empty() && (has_name || !out.parts.empty())) return settle(out, Outcome::kAlreadySo, kNothingToDo);
    } else if (const std::string wrong = wrongWith(out.parts); !wrong.empty()) {
      reason = wrong;
    } else {
      const auto isConflict = [&](std::size_t p) { return isOther(parts_[p]); };
      const bool conflict = std::any_of(out.parts.begin(), out.parts.end(), isConflict);
      return settle(out, conflict ? Outcome::kConflict : Outcome::kApplies,
                    reason.empty() ? reason : "A part is left out: " + reason);
    }
    settle(out, Outcome::kDoesNotApply,
           reason.empty() ? "The new model does not have the rules that it copies." : reason);
  }

 private:
  static void settle(CarriedEdit& out, Outcome outcome, std::string note) {
    out.outcome = outcome;
    out.note = std::move(note);
    if (!out.canApply()) out.parts.clear();
  }

  /// Why a part cannot be put into the target; nothing: it can. Empty: it has no meaning there.
  std::optional<std::string> whyNot(const ModelPart& part) const {
    if (!part.expert.empty() && part.kind != PartKind::kExpert && !findExpert(target_, part.expert)) {
      return labelOf(**findExpert(base_, part.expert)) + " is not in the new model.";
    }
    if (!part.list.variable.empty() && !findVariable(target_, part.list.variable)) {
      return labelOf(**findVariable(base_, part.list.variable)) + " is not in the new model.";
    }
    if (part.kind == PartKind::kRule) return whyNotRule(part);
    if (part.kind == PartKind::kEvent) return whyNotEvent(part);
    const bool of_term =
        part.kind == PartKind::kTerm || part.kind == PartKind::kVertex || part.kind == PartKind::kTermName;
    return of_term ? whyNotTerm(part) : std::nullopt;
  }

  std::optional<std::string> whyNotRule(const ModelPart& part) const {
    if (!part.copy_of.empty()) {
      ModelPart original = part;
      original.key = part.copy_of;
      return valueIn(target_, original) ? std::nullopt : std::optional<std::string>("");
    }
    if (!part.from || !part.to || valueIn(target_, part)) return std::nullopt;
    const auto expert = *findExpert(base_, part.expert);
    return labelOf(*expert) + " has no rule " + conditionsText(base_, *expert, *ruleOf(part.from)) +
           " in the new model.";
  }

  std::optional<std::string> whyNotEvent(const ModelPart& part) const {
    const auto addsTerm = [&](const ModelPart& other) {
      return isStructure(other) && other.to && other.list == part.list && other.key == part.key;
    };
    const bool has_term = findTerm(*termsIn(target_, part.list), part.key) != nullptr;
    if (!part.to || has_term || std::any_of(parts_.begin(), parts_.end(), addsTerm)) return std::nullopt;
    return "The new model has no term " + part.key + " of " + labelOf(**findVariable(base_, part.list.variable)) + '.';
  }

  std::optional<std::string> whyNotTerm(const ModelPart& part) const {
    const Variable& variable = **findVariable(base_, part.list.variable);
    const std::vector<Term>* const terms = termsIn(target_, part.list);
    if (terms == nullptr) {
      return labelOf(**findExpert(base_, part.list.expert)) + " has no terms of its own for " + labelOf(variable) +
             " in the new model.";
    }
    if (readersOf(target_, part.list).empty() && !readersOf(base_, part.list).empty()) {
      return "In the new model each expert has terms of its own for " + labelOf(variable) + ".";
    }
    const Term* const was = part.from ? findTerm(*termsIn(base_, part.list), part.key) : nullptr;
    const Term* const now = findTerm(*terms, part.key);
    if (was == nullptr || (now == nullptr && !part.to)) return std::nullopt;
    const std::string called = "The term " + labelOf(*was) + " of " + labelOf(variable);
    if (now == nullptr) return called + " is not in the new model.";
    if (part.kind == PartKind::kVertex && now->shape != was->shape) {
      return called + " has another shape in the new model: " + std::string(fuzzy::name(now->shape)) + " instead of " +
             std::string(fuzzy::name(was->shape)) + '.';
    }
    const auto locked = std::find_if(locked_.begin(), locked_.end(), [&](const VertexPlace& place) {
      const bool same = place.list == part.list && place.term == part.key;
      return same && part.kind != PartKind::kTermName && (part.kind == PartKind::kTerm || place.point == part.point);
    });
    if (locked != locked_.end()) return called + ": the " + pointName(now->shape, locked->point) + " is locked.";
    if (part.kind != PartKind::kTermName) return std::nullopt;
    const std::string& id = std::get<TermNames>(*part.to).id;
    if (id == part.key || findTerm(*terms, id) == nullptr) return std::nullopt;
    return "The new model has another term " + id + " of " + labelOf(variable) + '.';
  }

  /// Why the target with the parts makes no sense; empty if it does.
  std::string wrongWith(const Group& group) const {
    ForceModel made = target_;  // with the names of the base, as the parts have them
    Group unnamed;
    std::copy_if(group.begin(), group.end(), std::back_inserter(unnamed),
                 [&](std::size_t p) { return parts_[p].kind != PartKind::kTermName; });
    put(made, partsOf(parts_, unnamed));
    for (const std::size_t p : group) {
      const ModelPart& part = parts_[p];
      if (part.kind == PartKind::kVertex) {
        const Term& term = *findTerm(*termsIn(made, part.list), part.key);
        if (term.shape != Shape::kGaussian && !std::is_sorted(term.points.begin(), term.points.end())) {
          return "The vertices of " + labelOf(term) + " would not be in order any more.";
        }
      }
      if (const Rule* const rule = ruleOf(part.to)) {
        const std::string missing = missingTerm(made, part.expert, *rule);
        if (!missing.empty()) return missing;
      }
    }
    ForceModel named = target_;
    put(named, partsOf(parts_, group));
    const auto valid = fuzzy::validate(named);
    return valid ? std::string() : "The new model would not make sense: " + valid.error().message() + '.';
  }

  std::string missingTerm(const ForceModel& made, const std::string& expert, const Rule& rule) const {
    const auto owner = *findExpert(made, expert);
    const auto missing = [&](const std::string& variable, const std::string& term) -> std::string {
      const auto found = findVariable(made, variable);
      if (!found) return variable + " is not in the new model.";
      if (findTerm(termsFor(*owner, **found), term) != nullptr) return {};
      return "The new model has no term " + term + " of " + labelOf(**found) + '.';
    };
    for (const auto& condition : rule.conditions) {
      if (auto why = missing(condition.input, condition.term); !why.empty()) return why;
    }
    return missing(made.output.id, rule.then);
  }

  /// Whether the target has another value than the base there, and than the tuned version.
  bool isOther(const ModelPart& part) const {
    const auto now = valueIn(target_, part);
    if (now == part.from || now == part.to) return false;
    if (part.kind == PartKind::kRule) {
      if (!part.copy_of.empty() || (!part.to && copied_.contains(part.expert + '/' + part.key))) return false;
      if (!now) return false;
      if (part.from && part.to) {
        const Rule& from = *ruleOf(part.from);
        const Rule& to = *ruleOf(part.to);
        const Rule& is = *ruleOf(now);
        const auto other = [](const auto& a, const auto& b, const auto& c) { return a != b && c != a && c != b; };
        return other(from.then, to.then, is.then) || other(from.weight, to.weight, is.weight) ||
               other(from.enabled, to.enabled, is.enabled);
      }
    }
    return true;
  }

  const ForceModel& base_;
  const ForceModel& target_;
  const std::vector<ModelPart>& parts_;
  const std::vector<std::size_t>& names_;
  std::span<const VertexPlace> locked_;
  std::set<std::string> copied_;  ///< rules of which there are copies for the terms that take a term's place
};

/// Gives the target the old names of the terms that are called there as in the tuned version.
void nameAsBefore(Rebase& rebase) {
  rebase.named = rebase.target->model;
  for (std::size_t p = 0; p < rebase.parts.size(); ++p) {
    const ModelPart& part = rebase.parts[p];
    if (part.kind != PartKind::kTermName) continue;
    const std::string& id = std::get<TermNames>(*part.to).id;
    const std::vector<Term>* const terms = termsIn(rebase.named, part.list);
    if (terms == nullptr || findTerm(*terms, part.key) != nullptr || findTerm(*terms, id) == nullptr) continue;
    ModelPart back = part;
    back.key = id;
    std::swap(back.from, back.to);
    const ModelPart* const one = &back;
    put(rebase.named, std::span(&one, 1));
    rebase.names.push_back(p);
  }
}

std::string carriedLabel(const Rebase& rebase, const Group& chosen) {
  if (chosen.size() != 1) return std::to_string(chosen.size()) + " edits carried over";
  const CarriedEdit& edit = rebase.edits[chosen.front()];
  return "Carried over: " + edit.what + ": " + edit.before + " to " + edit.after;
}

}  // namespace

std::string_view name(CarriedEdit::Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::kApplies: return "applies";
    case Outcome::kConflict: return "conflict";
    case Outcome::kAlreadySo: return "already so";
    case Outcome::kDoesNotApply: return "does not apply";
  }
  return "";
}

base::Result<Rebase> rebase(const ForceModel& base, const ForceModel& tuned, SharedModel target,
                            std::span<const VertexPlace> locked) {
  TACTUS_TRY(auto parts, differingParts(base, tuned));
  Rebase out{std::move(target), std::move(parts), {}, {}, {}};
  nameAsBefore(out);
  Grouping grouping(base, out.parts);
  const std::vector<Group> groups = grouping.groups();
  const Trial trial(base, out, locked);
  for (const Group& group : groups) {
    const auto parts_of = partsOf(out.parts, group);
    CarriedEdit edit;
    edit.what = partsTitle(base, grouping.after(), parts_of);
    edit.before = partsText(base, parts_of);
    edit.after = tunedText(grouping.after(), parts_of);
    trial.run(group, edit);
    if (edit.outcome == Outcome::kConflict) {
      const std::string now = "The new model has " + partsText(out.named, parts_of) + ".";
      edit.note = edit.note.empty() ? now : now + ' ' + edit.note;
    }
    out.edits.push_back(std::move(edit));
  }
  return out;
}

base::Result<Edit> carryOver(const Rebase& rebase, std::span<const std::size_t> chosen) {
  std::set<std::size_t> parts(rebase.names.begin(), rebase.names.end());
  Group carried;
  for (const std::size_t e : std::set<std::size_t>(chosen.begin(), chosen.end())) {
    TACTUS_CHECK(e < rebase.edits.size());
    if (!rebase.edits[e].canApply()) continue;
    carried.push_back(e);
    parts.insert(rebase.edits[e].parts.begin(), rebase.edits[e].parts.end());
  }
  ForceModel made = rebase.named;
  put(made, partsOf(rebase.parts, Group(parts.begin(), parts.end())));
  return finished(std::move(made), carriedLabel(rebase, carried));
}

base::Result<EditImpact> priceOf(const Rebase& rebase, std::span<const std::size_t> chosen) {
  TACTUS_TRY(const auto edit, carryOver(rebase, chosen));
  return editImpact(rebase.target->model, rebase.target->compiled, edit.model, edit.compiled);
}

}  // namespace tactus::editing
