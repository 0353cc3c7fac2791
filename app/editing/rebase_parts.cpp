#include <algorithm>
#include <map>
#include <utility>

#include "app/editing/rebase.h"
#include "app/editing/term_edits.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::editing {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::TermOverride;
using fuzzy::Variable;
using Keys = std::vector<std::string>;

Keys keysOf(const std::vector<Term>& terms) {
  Keys out;
  for (const Term& term : terms) out.push_back(term.id);
  return out;
}

Keys keysOf(const std::vector<Expert>& experts) {
  Keys out;
  for (const Expert& expert : experts) out.push_back(expert.id);
  return out;
}

Keys keysOf(const std::vector<fuzzy::TubeEvent>& events) {
  Keys out;
  for (const fuzzy::TubeEvent& event : events) out.push_back(event.term);
  return out;
}

Keys keysOf(const std::vector<fuzzy::Contract>& contracts) {
  Keys out;
  for (const fuzzy::Contract& contract : contracts) out.push_back(contract.id);
  return out;
}

Keys keysOf(const std::vector<TermOverride>& lists) {
  Keys out;
  for (const TermOverride& own : lists) out.push_back(own.variable);
  return out;
}

/// A rule is known by its conditions in any order; a second one with the same conditions is another one.
Keys keysOf(const std::vector<Rule>& rules) {
  constexpr char kBetween = '\x1f';
  Keys out;
  std::map<std::string, int> seen;
  for (const Rule& rule : rules) {
    Keys conditions;
    for (const auto& condition : rule.conditions) conditions.push_back(condition.input + kBetween + condition.term);
    std::sort(conditions.begin(), conditions.end());
    std::string key = base::joined(conditions, std::string(2, kBetween));
    if (const int copy = ++seen[key]; copy > 1) key += kBetween + std::to_string(copy);
    out.push_back(std::move(key));
  }
  return out;
}

namespace {

// How one list becomes another.

struct KeyChange {
  std::optional<std::size_t> before;
  std::optional<std::size_t> after;
  bool moved = false;  ///< in both, but not in the same order as the others
};

/// The longest run of ascending numbers among `places`: which of them belong to it (Schensted, 1961).
std::vector<bool> longestAscending(const std::vector<std::size_t>& places) {
  std::vector<std::size_t> ends;  // the index of the smallest end of a run of each length
  std::vector<std::size_t> before(places.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = std::lower_bound(ends.begin(), ends.end(), places[i],
                                     [&](std::size_t end, std::size_t place) { return places[end] < place; });
    if (at != ends.begin()) before[i] = *std::prev(at);
    at == ends.end() ? ends.push_back(i) : void(*at = i);
  }
  std::vector<bool> out(places.size());
  for (std::size_t i = ends.empty() ? places.size() : ends.back(); i < places.size(); i = before[i]) out[i] = true;
  return out;
}

/// What was removed, then every key of `after` in its order.
std::vector<KeyChange> changesOf(const Keys& before, const Keys& after) {
  std::map<std::string, std::size_t> place_before;
  for (std::size_t i = 0; i < before.size(); ++i) place_before.emplace(before[i], i);
  std::vector<KeyChange> out;
  std::vector<bool> stays(before.size());
  std::vector<std::size_t> common;
  std::vector<KeyChange> there;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto found = place_before.find(after[i]);
    KeyChange change{std::nullopt, i, false};
    if (found != place_before.end()) {
      change.before = found->second;
      stays[found->second] = true;
      common.push_back(found->second);
    }
    there.push_back(change);
  }
  const std::vector<bool> in_order = longestAscending(common);
  std::size_t next = 0;
  for (KeyChange& change : there) {
    if (change.before) change.moved = !in_order[next++];
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!stays[i]) out.push_back({i, std::nullopt, false});
  }
  out.insert(out.end(), there.begin(), there.end());
  return out;
}

// Finding the differences.

class Differences {
 public:
  Differences(const ForceModel& base, const ForceModel& tuned) : base_(base), tuned_(tuned) {}

  std::vector<ModelPart> all() {
    addSettings();
    nameBack();
    addExperts();
    forEachList([&](const TermListId& list, const auto& before, const auto& after) { addTerms(list, before, after); });
    addEvents();
    for (const Expert& expert : base_.experts) {
      if (const auto now = findExpert(std::as_const(tuned_), expert.id)) addRules(expert, **now);
    }
    parts_.insert(parts_.end(), names_.begin(), names_.end());
    return std::move(parts_);
  }

 private:
  ModelPart& add(PartKind kind, const std::string& key, std::optional<PartValue> from, std::optional<PartValue> to) {
    ModelPart part;
    part.kind = kind;
    part.key = key;
    part.from = std::move(from);
    part.to = std::move(to);
    return parts_.emplace_back(std::move(part));
  }

  template <class Value>
  void addIfOther(PartKind kind, const std::string& key, const Value& from, const Value& to) {
    if (!(from == to)) add(kind, key, from, to);
  }

  static void setOrder(ModelPart& part, const std::shared_ptr<const Keys>& order, std::size_t place) {
    part.order = order;
    part.place = place;
  }

  void addSettings() {
    addIfOther(PartKind::kImplication, {}, base_.implication, tuned_.implication);
    addIfOther(PartKind::kDefaultForce, {}, base_.default_force_n, tuned_.default_force_n);
    if (base_.renderer != tuned_.renderer) {
      const auto value = [](const auto& renderer) {
        return renderer ? std::optional<PartValue>(*renderer) : std::nullopt;
      };
      add(PartKind::kRenderer, {}, value(base_.renderer), value(tuned_.renderer));
    }
    const auto order = std::make_shared<const Keys>(tuned_.accepted_holes);
    for (const KeyChange& change : changesOf(base_.accepted_holes, tuned_.accepted_holes)) {
      if (change.before && change.after && !change.moved) continue;
      const std::string& key =
          change.after ? tuned_.accepted_holes[*change.after] : base_.accepted_holes[*change.before];
      const auto there = [](bool is) { return is ? std::optional<PartValue>(true) : std::nullopt; };
      ModelPart& part = add(PartKind::kHole, key, there(change.before.has_value()), there(change.after.has_value()));
      if (change.after) setOrder(part, order, *change.after);
    }
    addContracts();
    forEachVariable([&](const Variable& before, const Variable& after) {
      const UniverseRange from{before.min, before.max};
      const UniverseRange to{after.min, after.max};
      if (from == to) return;
      add(PartKind::kUniverse, before.id, from, to).list.variable = before.id;
    });
  }

  void addContracts() {
    const auto order = std::make_shared<const Keys>(keysOf(tuned_.contracts));
    for (const KeyChange& change : changesOf(keysOf(base_.contracts), *order)) {
      std::optional<PartValue> from, to;
      if (change.before) from = base_.contracts[*change.before];
      if (change.after) to = tuned_.contracts[*change.after];
      if (from == to && !change.moved) continue;
      const std::string& id = std::get<fuzzy::Contract>(to ? *to : *from).id;
      ModelPart& part = add(PartKind::kContract, id, from, to);
      const bool stands = change.after && (change.moved || !change.before);
      if (stands) setOrder(part, order, *change.after);
    }
  }

  template <class Use>
  void forEachVariable(const Use& use) {
    for (std::size_t i = 0; i < base_.inputs.size(); ++i) use(base_.inputs[i], tuned_.inputs[i]);
    use(base_.output, tuned_.output);
  }

  /// Every list that both versions have.
  template <class Use>
  void forEachList(const Use& use) {
    forEachVariable([&](const Variable& before, Variable& after) { use({before.id, {}}, before.terms, after.terms); });
    for (const Expert& expert : base_.experts) {
      const auto now = findExpert(tuned_, expert.id);
      if (!now) continue;
      for (const TermOverride& own : expert.overrides) {
        for (TermOverride& other : (*now)->overrides) {
          if (other.variable == own.variable) use({own.variable, expert.id}, own.terms, other.terms);
        }
      }
    }
  }

  // A term with another name is the same term: the tuned version gets the old name back, so that all other edits are
  // found without the new one.
  void nameBack() {
    forEachList([&](const TermListId& list, const std::vector<Term>& before, std::vector<Term>& after) {
      for (std::size_t i = 0; i < after.size(); ++i) {
        const Term* was = findTerm(before, after[i].id);
        if (was == nullptr) was = nameBefore(before, after, i);
        if (was == nullptr || (was->id == after[i].id && was->label == after[i].label)) continue;
        const TermNames from{was->id, was->label};
        const TermNames to{after[i].id, after[i].label};
        if (from.id != to.id) renameInRules(list, to.id, from.id);
        moveEvents(tuned_, list, to.id, from.id);
        after[i].id = from.id;
        after[i].label = from.label;
        ModelPart part;
        part.kind = PartKind::kTermName;
        part.list = list;
        part.key = from.id;
        part.from = from;
        part.to = to;
        names_.push_back(std::move(part));
      }
    });
  }

  /// The term of `before` that is gone and has the function of `after[place]`, or its place in the list.
  static const Term* nameBefore(const std::vector<Term>& before, const std::vector<Term>& after, std::size_t place) {
    const Term& now = after[place];
    const auto gone = [&](const Term& term) { return findTerm(after, term.id) == nullptr; };
    for (const Term& was : before) {
      if (gone(was) && was.shape == now.shape && was.points == now.points) return &was;
    }
    if (before.size() != after.size() || !gone(before[place]) || before[place].shape != now.shape) return nullptr;
    return &before[place];
  }

  void renameInRules(const TermListId& list, const std::string& from, const std::string& to) {
    const Variable& variable = **findVariable(tuned_, list.variable);
    for (Expert& expert : tuned_.experts) {
      if (!reads(expert, list)) continue;
      for (Rule& rule : expert.rules) rule = withTerm(std::move(rule), tuned_, variable, from, to);
    }
  }

  void addExperts() {
    const Keys before = keysOf(base_.experts);
    const auto after = std::make_shared<const Keys>(keysOf(tuned_.experts));
    for (const KeyChange& change : changesOf(before, *after)) {
      if (change.before && change.after) {
        addExpert(base_.experts[*change.before], tuned_.experts[*change.after]);
      } else if (change.before) {
        const Expert& gone = base_.experts[*change.before];
        add(PartKind::kExpert, gone.id, gone, std::nullopt).expert = gone.id;
      } else {
        const Expert& made = tuned_.experts[*change.after];
        ModelPart& part = add(PartKind::kExpert, made.id, std::nullopt, made);
        part.expert = made.id;
        setOrder(part, after, *change.after);
      }
    }
  }

  void addExpert(const Expert& before, const Expert& after) {
    if (before.weight != after.weight) {
      add(PartKind::kExpertWeight, before.id, before.weight, after.weight).expert = before.id;
    }
    const auto order = std::make_shared<const Keys>(keysOf(after.overrides));
    for (const KeyChange& change : changesOf(keysOf(before.overrides), *order)) {
      if (change.before && change.after && !change.moved) continue;
      const auto value = [](const auto& lists, const auto& place) {
        return place ? std::optional<PartValue>(lists[*place].terms) : std::nullopt;
      };
      const std::string& variable = change.after ? (*order)[*change.after] : before.overrides[*change.before].variable;
      ModelPart& part = add(PartKind::kOwnTerms, variable, value(before.overrides, change.before),
                            value(after.overrides, change.after));
      part.list = {variable, before.id};
      part.expert = before.id;
      part.shared = (*findVariable(base_, variable))->terms;
      if (change.after) setOrder(part, order, *change.after);
    }
  }

  void addTerms(const TermListId& list, const std::vector<Term>& before, const std::vector<Term>& after) {
    const auto order = std::make_shared<const Keys>(keysOf(after));
    for (const KeyChange& change : changesOf(keysOf(before), *order)) {
      const Term* const was = change.before ? &before[*change.before] : nullptr;
      const Term* const now = change.after ? &after[*change.after] : nullptr;
      const bool same_shape = was != nullptr && now != nullptr && was->shape == now->shape;
      if (!same_shape || change.moved) {
        const auto value = [](const Term* term) { return term ? std::optional<PartValue>(*term) : std::nullopt; };
        ModelPart& part = add(PartKind::kTerm, was ? was->id : now->id, value(was), value(now));
        part.list = list;
        if (now && (!was || change.moved)) setOrder(part, order, *change.after);
      }
      for (std::size_t p = 0; same_shape && p < was->points.size(); ++p) {
        if (was->points[p] == now->points[p]) continue;
        ModelPart& part = add(PartKind::kVertex, was->id, was->points[p], now->points[p]);
        part.list = list;
        part.point = p;
      }
    }
  }

  void addEvents() {
    const auto way = fuzzy::wayOf(base_.inputs);
    if (!way) return;
    const auto order = std::make_shared<const Keys>(keysOf(tuned_.events));
    for (const KeyChange& change : changesOf(keysOf(base_.events), *order)) {
      const auto value = [](const auto& events, const auto& place) {
        return place ? std::optional<PartValue>(events[*place].share) : std::nullopt;
      };
      const auto from = value(base_.events, change.before);
      const auto to = value(tuned_.events, change.after);
      if (from == to && !change.moved) continue;
      ModelPart& part =
          add(PartKind::kEvent, change.after ? (*order)[*change.after] : base_.events[*change.before].term, from, to);
      part.list.variable = base_.inputs[*way].id;
      if (change.after && (!change.before || change.moved)) setOrder(part, order, *change.after);
    }
  }

  void addRules(const Expert& before, const Expert& after) {
    if (before.rules == after.rules) return;
    const Keys keys_before = keysOf(before.rules);
    const auto keys_after = std::make_shared<const Keys>(keysOf(after.rules));
    std::vector<std::size_t> gone;
    for (const KeyChange& change : changesOf(keys_before, *keys_after)) {
      const Rule* const was = change.before ? &before.rules[*change.before] : nullptr;
      const Rule* const now = change.after ? &after.rules[*change.after] : nullptr;
      if (was != nullptr && now != nullptr && *was == *now && !change.moved) continue;
      const auto value = [](const Rule* rule) { return rule ? std::optional<PartValue>(*rule) : std::nullopt; };
      ModelPart& part = add(PartKind::kRule, change.before ? keys_before[*change.before] : (*keys_after)[*change.after],
                            value(was), value(now));
      part.expert = before.id;
      if (now == nullptr) gone.push_back(*change.before);
      if (now != nullptr && (was == nullptr || change.moved)) setOrder(part, keys_after, *change.after);
      if (was != nullptr) continue;
      for (const std::size_t r : gone) {
        if (!isCopy(before.rules[r], before, *now, after)) continue;
        part.copy_of = keys_before[r];
        part.copied = before.rules[r];
        break;
      }
    }
  }

  /// The same rule, but for terms that took the place of terms that are gone.
  bool isCopy(const Rule& was, const Expert& before, const Rule& now, const Expert& after) const {
    if (was.conditions.size() != now.conditions.size()) return false;
    return std::all_of(was.conditions.begin(), was.conditions.end(), [&](const fuzzy::Condition& one) {
      return std::any_of(now.conditions.begin(), now.conditions.end(), [&](const fuzzy::Condition& other) {
        if (one.input != other.input) return false;
        if (one.term == other.term) return true;
        const auto& terms_before = termsFor(before, **findVariable(base_, one.input));
        const auto& terms_after = termsFor(after, **findVariable(tuned_, one.input));
        return findTerm(terms_after, one.term) == nullptr && findTerm(terms_before, other.term) == nullptr;
      });
    });
  }

  const ForceModel& base_;
  ForceModel tuned_;  ///< with the old names of terms
  std::vector<ModelPart> parts_;
  std::vector<ModelPart> names_;  ///< come last: everything else goes by the old names
};

bool sameVariables(const ForceModel& one, const ForceModel& other) {
  const auto same = [](const Variable& a, const Variable& b) { return a.id == b.id; };
  return std::equal(one.inputs.begin(), one.inputs.end(), other.inputs.begin(), other.inputs.end(), same) &&
         same(one.output, other.output);
}

std::string variableIds(const ForceModel& model) {
  Keys ids;
  for (const Variable& input : model.inputs) ids.push_back(input.id);
  ids.push_back(model.output.id);
  return base::listed(ids);
}

}  // namespace

base::Result<std::vector<ModelPart>> differingParts(const ForceModel& base, const ForceModel& tuned) {
  if (!sameVariables(base, tuned)) {
    return base::fail(base::ErrorCode::kMismatch, "variables", variableIds(tuned), variableIds(base));
  }
  return Differences(base, tuned).all();
}

}  // namespace tactus::editing
