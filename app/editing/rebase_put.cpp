#include <algorithm>
#include <map>
#include <utility>

#include "app/editing/rebase.h"
#include "app/editing/term_edits.h"

namespace tactus::editing {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::TermOverride;
using fuzzy::Variable;
using Keys = std::vector<std::string>;

std::optional<std::size_t> placeOf(const Keys& keys, const std::string& key) {
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) return std::nullopt;
  return static_cast<std::size_t>(found - keys.begin());
}

/// Puts `item` behind the nearest key before it in the tuned version that is there; at the front if there is none.
template <class Item>
void insertAt(std::vector<Item>& items, Keys& keys, Item item, const ModelPart& part) {
  const Keys& order = *part.order;
  std::size_t at = 0;
  for (std::size_t i = part.place; i-- > 0 && at == 0;) {
    if (const auto place = placeOf(keys, order[i])) at = *place + 1;
  }
  items.insert(items.begin() + static_cast<std::ptrdiff_t>(at), std::move(item));
  keys.insert(keys.begin() + static_cast<std::ptrdiff_t>(at), order[part.place]);
}

template <class Item>
Item takeOut(std::vector<Item>& items, Keys& keys, std::size_t place) {
  const auto at = static_cast<std::ptrdiff_t>(place);
  Item out = std::move(items[place]);
  items.erase(items.begin() + at);
  keys.erase(keys.begin() + at);
  return out;
}

template <class Value>
const Value& valueOf(const std::optional<PartValue>& value) {
  return std::get<Value>(*value);
}

// What the tuned version did not change stays.

template <class Value>
const Value& merged(const Value& from, const Value& to, const Value& now) {
  return to == from ? now : to;
}

Rule mergedRule(const Rule& from, const Rule& to, const Rule& now) {
  return {merged(from.conditions, to.conditions, now.conditions), merged(from.then, to.then, now.then),
          merged(from.weight, to.weight, now.weight), merged(from.enabled, to.enabled, now.enabled)};
}

Term mergedTerm(const Term& from, const Term& to, const Term& now) {
  Term out = now;
  out.label = merged(from.label, to.label, now.label);
  if (from.shape == to.shape && from.points == to.points) return out;
  out.shape = to.shape;
  out.points = to.points;
  if (from.shape != to.shape || now.shape != to.shape) return out;
  for (std::size_t p = 0; p < to.points.size(); ++p)
    out.points[p] = merged(from.points[p], to.points[p], now.points[p]);
  const bool in_order = to.shape == fuzzy::Shape::kGaussian || std::is_sorted(out.points.begin(), out.points.end());
  if (!in_order) out.points = to.points;
  return out;
}

/// Puts parts into one model. Keeps the keys of the rules while it works on them.
class Putting {
 public:
  explicit Putting(ForceModel& model) : model_(model) {}

  void put(std::span<const ModelPart* const> parts) {
    // The rules that are copied may be removed before their copies are added.
    for (const ModelPart* part : parts) {
      if (part->copy_of.empty()) continue;
      if (const auto now = valueOfRule(part->expert, part->copy_of)) originals_.emplace(part, *now);
    }
    for (const ModelPart* part : parts) put(*part);
  }

 private:
  void put(const ModelPart& part) {
    switch (part.kind) {
      case PartKind::kImplication: model_.implication = valueOf<fuzzy::Implication>(part.to); return;
      case PartKind::kDefaultForce: model_.default_force_n = valueOf<double>(part.to); return;
      case PartKind::kRenderer:
        model_.renderer = part.to ? std::optional(valueOf<fuzzy::RendererParameters>(part.to)) : std::nullopt;
        return;
      case PartKind::kHole: {
        Keys keys = model_.accepted_holes;
        place(model_.accepted_holes, keys, part, [&](const std::string*) { return part.key; });
        return;
      }
      case PartKind::kContract: {
        Keys keys = keysOf(model_.contracts);
        place(model_.contracts, keys, part, [&](const fuzzy::Contract*) { return valueOf<fuzzy::Contract>(part.to); });
        return;
      }
      case PartKind::kUniverse: putUniverse(part); return;
      case PartKind::kExpert: {
        Keys keys = keysOf(model_.experts);
        place(model_.experts, keys, part, [&](const Expert*) { return valueOf<Expert>(part.to); });
        return;
      }
      case PartKind::kExpertWeight: expert(part).weight = valueOf<double>(part.to); return;
      case PartKind::kOwnTerms: putOwnTerms(part); return;
      case PartKind::kTerm: putTerm(part); return;
      case PartKind::kVertex: term(part).points[part.point] = valueOf<double>(part.to); return;
      case PartKind::kEvent: {
        Keys keys = keysOf(model_.events);
        place(model_.events, keys, part, [&](const fuzzy::TubeEvent*) {
          return fuzzy::TubeEvent{part.key, valueOf<double>(part.to)};
        });
        return;
      }
      case PartKind::kTermName: putName(part); return;
      case PartKind::kRule: putRule(part); return;
    }
  }

  Expert& expert(const ModelPart& part) { return **findExpert(model_, part.expert); }
  std::vector<Term>& terms(const ModelPart& part) { return *openList(model_, part.list)->terms; }
  Term& term(const ModelPart& part) {
    std::vector<Term>& all = terms(part);
    return *std::find_if(all.begin(), all.end(), [&](const Term& one) { return one.id == part.key; });
  }

  /// Removes the item of the part, inserts it, or gives it the value of `make`, which gets the item that is there.
  template <class Item, class Make>
  static void place(std::vector<Item>& items, Keys& keys, const ModelPart& part, const Make& make) {
    const auto at = placeOf(keys, part.key);
    if (!part.to) {
      if (at) takeOut(items, keys, *at);
      return;
    }
    Item made = make(at ? &items[*at] : nullptr);
    const bool moves = part.order && (!at || part.from);
    if (!moves) {
      if (at) items[*at] = std::move(made);
      return;
    }
    if (at) takeOut(items, keys, *at);
    insertAt(items, keys, std::move(made), part);
  }

  void putUniverse(const ModelPart& part) {
    const auto& to = valueOf<UniverseRange>(part.to);
    const auto set = [&](Variable& variable) {
      if (variable.id != part.list.variable) return;
      variable.min = to.min;
      variable.max = to.max;
    };
    for (Variable& input : model_.inputs) set(input);
    set(model_.output);
  }

  void putOwnTerms(const ModelPart& part) {
    Expert& owner = expert(part);
    const Variable& variable = **findVariable(std::as_const(model_), part.list.variable);
    const std::vector<Term> now = termsFor(owner, variable);
    Keys keys = keysOf(owner.overrides);
    place(owner.overrides, keys, part, [&](const TermOverride* there) {
      if (part.from && there != nullptr) return *there;
      TermOverride own{part.list.variable, valueOf<std::vector<Term>>(part.to)};
      for (Term& term : own.terms) {
        const Term* const was = findTerm(part.shared, term.id);
        const Term* const is = findTerm(now, term.id);
        if (was != nullptr && is != nullptr) term = mergedTerm(*was, term, *is);
      }
      return own;
    });
  }

  void putTerm(const ModelPart& part) {
    std::vector<Term>& all = terms(part);
    Keys keys = keysOf(all);
    place(all, keys, part, [&](const Term* there) {
      const Term& to = valueOf<Term>(part.to);
      return part.from && there != nullptr ? mergedTerm(valueOf<Term>(part.from), to, *there) : to;
    });
  }

  void putName(const ModelPart& part) {
    const auto& to = valueOf<TermNames>(part.to);
    Term& named = term(part);
    named.label = to.label;
    if (to.id == part.key) return;
    named.id = to.id;
    const Variable& variable = **findVariable(std::as_const(model_), part.list.variable);
    for (Expert& one : model_.experts) {
      if (!reads(one, part.list)) continue;
      for (Rule& rule : one.rules) rule = withTerm(std::move(rule), model_, variable, part.key, to.id);
    }
    moveEvents(model_, part.list, part.key, to.id);
  }

  void putRule(const ModelPart& part) {
    Expert& owner = expert(part);
    const auto original = originals_.find(&part);
    // A copy of a rule that the model does not have.
    if (!part.copy_of.empty() && original == originals_.end()) return;
    place(owner.rules, keysOfRules(owner), part, [&](const Rule* there) {
      const Rule& to = valueOf<Rule>(part.to);
      if (part.from && there != nullptr) return mergedRule(valueOf<Rule>(part.from), to, *there);
      if (!part.copied) return to;
      Rule copy = mergedRule(*part.copied, to, original->second);
      copy.conditions = to.conditions;
      return copy;
    });
  }

  Keys& keysOfRules(const Expert& owner) {
    const auto found = keys_.find(owner.id);
    return found != keys_.end() ? found->second : keys_.emplace(owner.id, keysOf(owner.rules)).first->second;
  }

  std::optional<Rule> valueOfRule(const std::string& id, const std::string& key) {
    const auto owner = findExpert(std::as_const(model_), id);
    if (!owner) return std::nullopt;
    const auto at = placeOf(keysOfRules(**owner), key);
    return at ? std::optional((*owner)->rules[*at]) : std::nullopt;
  }

  ForceModel& model_;
  std::map<std::string, Keys> keys_;
  std::map<const ModelPart*, Rule> originals_;
};

}  // namespace

std::optional<PartValue> valueIn(const ForceModel& model, const ModelPart& part) {
  const auto expert = findExpert(model, part.expert);
  const std::vector<Term>* const terms = termsIn(model, part.list);
  const Term* const term = terms == nullptr ? nullptr : findTerm(*terms, part.key);
  switch (part.kind) {
    case PartKind::kImplication: return model.implication;
    case PartKind::kDefaultForce: return model.default_force_n;
    case PartKind::kRenderer: return model.renderer ? std::optional<PartValue>(*model.renderer) : std::nullopt;
    case PartKind::kHole:
      return placeOf(model.accepted_holes, part.key) ? std::optional<PartValue>(true) : std::nullopt;
    case PartKind::kContract: {
      const auto at = placeOf(keysOf(model.contracts), part.key);
      return at ? std::optional<PartValue>(model.contracts[*at]) : std::nullopt;
    }
    case PartKind::kUniverse: {
      const auto variable = findVariable(model, part.list.variable);
      return variable ? std::optional<PartValue>(UniverseRange{(*variable)->min, (*variable)->max}) : std::nullopt;
    }
    case PartKind::kExpert: return expert ? std::optional<PartValue>(**expert) : std::nullopt;
    case PartKind::kExpertWeight: return expert ? std::optional<PartValue>((*expert)->weight) : std::nullopt;
    case PartKind::kOwnTerms: return terms ? std::optional<PartValue>(*terms) : std::nullopt;
    case PartKind::kTerm: return term ? std::optional<PartValue>(*term) : std::nullopt;
    case PartKind::kVertex:
      return term && part.point < term->points.size() ? std::optional<PartValue>(term->points[part.point])
                                                      : std::nullopt;
    case PartKind::kEvent: {
      const auto at = placeOf(keysOf(model.events), part.key);
      return at ? std::optional<PartValue>(model.events[*at].share) : std::nullopt;
    }
    case PartKind::kTermName: return term ? std::optional<PartValue>(TermNames{term->id, term->label}) : std::nullopt;
    case PartKind::kRule: {
      if (!expert) return std::nullopt;
      const auto at = placeOf(keysOf((*expert)->rules), part.key);
      return at ? std::optional<PartValue>((*expert)->rules[*at]) : std::nullopt;
    }
  }
  return std::nullopt;
}

void put(ForceModel& model, std::span<const ModelPart* const> parts) {
  Putting(model).put(parts);
  fuzzy::eraseLostEvents(model);
}

}  // namespace tactus::editing
