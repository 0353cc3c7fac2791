// Carries edits over to a model that was built anew: what differs between a model (base) and its tuned version is tried
// on the new model (target), edit by edit. Example: the base says Medium, the tuned version Small, and the target
// Large: the edit `Medium to Small` is a conflict. The user decides; carried over, the target says Small.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/edit_impact.h"
#include "app/editing/membership_edits.h"
#include "app/editing/term_list.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

// The parts of a model by name. Two versions differ in parts; a part of one can be put into any other model.

enum class PartKind {
  kImplication,
  kDefaultForce,
  kRenderer,
  kHole,  ///< an accepted hole
  kContract,
  kUniverse,      ///< of a variable
  kExpert,        ///< an expert that was added or removed
  kExpertWeight,  ///< the share of an expert in the mean
  kOwnTerms,      ///< whether an expert has an own list of terms for a variable, and which
  kTerm,          ///< a term that was added or removed, has another shape, or stands at another place of its list
  kVertex,        ///< a point of a term
  kEvent,         ///< at a term of the way: the share of the force that is lost
  kTermName,      ///< id and label of a term
  kRule,
};

struct UniverseRange {
  double min = 0;
  double max = 1;

  bool operator==(const UniverseRange&) const = default;
};

struct TermNames {
  std::string id;
  std::string label;

  bool operator==(const TermNames&) const = default;
};

using PartValue = std::variant<double, bool, fuzzy::Implication, fuzzy::RendererParameters, UniverseRange, TermNames,
                               fuzzy::Term, std::vector<fuzzy::Term>, fuzzy::Rule, fuzzy::Expert, fuzzy::Contract>;

/// One difference between two versions.
struct ModelPart {
  PartKind kind = PartKind::kRule;
  TermListId list;                ///< of terms, vertices and events; of an own list with its owner; of a universe
  std::string expert;             ///< of a rule
  std::string key;                ///< id of the expert, contract or term in the base, name of the hole, conditions
  std::size_t point = 0;          ///< of a vertex
  std::optional<PartValue> from;  ///< in the base; nothing: not there
  std::optional<PartValue> to;    ///< in the tuned version
  /// Where it stands: the keys of the whole list in the tuned version, and the place among them. Null for what keeps
  /// its place.
  std::shared_ptr<const std::vector<std::string>> order;
  std::size_t place = 0;
  /// Of an added rule: the key of the removed rule of which it is a copy with another term. The copy takes its word,
  /// weight and switch from the target as far as the tuned version did not change them.
  std::string copy_of;
  std::optional<fuzzy::Rule> copied;     ///< that rule in the base
  std::vector<fuzzy::Term> shared = {};  ///< of an own list that was made: the shared one in the base
};

/// Keys of the parts of a list: ids; of rules their conditions in any order, each further rule with the same ones by
/// its number.
std::vector<std::string> keysOf(const std::vector<fuzzy::Term>& terms);
std::vector<std::string> keysOf(const std::vector<fuzzy::TermOverride>& lists);
std::vector<std::string> keysOf(const std::vector<fuzzy::Expert>& experts);
std::vector<std::string> keysOf(const std::vector<fuzzy::TubeEvent>& events);
std::vector<std::string> keysOf(const std::vector<fuzzy::Contract>& contracts);
std::vector<std::string> keysOf(const std::vector<fuzzy::Rule>& rules);

/// The parts in which `tuned` differs from `base`, in the order in which `put` has to put them. Refused: other
/// variables. Name, date, program, origin and unknown keys of the file are no parts. Checks follow from the others.
base::Result<std::vector<ModelPart>> differingParts(const fuzzy::ForceModel& base, const fuzzy::ForceModel& tuned);

/// The value of the part in `model`; nothing if it is not there.
std::optional<PartValue> valueIn(const fuzzy::ForceModel& model, const ModelPart& part);

/// Puts the parts, in the order of `differingParts`, into `model`. What a part did not change stays as `model` has it.
/// A rule that got another word keeps the weight that it has in `model`; terms that became an expert's own take the
/// vertices that the edit did not move from `model`. The result need not be valid.
void put(fuzzy::ForceModel& model, std::span<const ModelPart* const> parts);

// Parts that belong together, in words.

/// What the parts are: `Insertion depth: between Nasopharynx and Oropharynx`. `after`: the tuned version with the names
/// of the base.
std::string partsTitle(const fuzzy::ForceModel& base, const fuzzy::ForceModel& after,
                       std::span<const ModelPart* const> parts);
/// What `model` has there: `125 to 132 mm`.
std::string partsText(const fuzzy::ForceModel& model, std::span<const ModelPart* const> parts);
/// The same for the tuned version, with the new names of terms.
std::string tunedText(const fuzzy::ForceModel& after, std::span<const ModelPart* const> parts);

// The edits: parts that belong together.

struct CarriedEdit {
  enum class Outcome {
    kApplies,
    kConflict,      ///< applies; the target has another value there than the base: `note` names it
    kAlreadySo,     ///< the target has it as the edit put it
    kDoesNotApply,  ///< `note` says why
  };

  std::string what;    ///< `S4: IF Tube lubrication is Well AND Insertion depth is Stomach`
  std::string before;  ///< in the base: `Medium`
  std::string after;   ///< in the tuned version: `Small`
  Outcome outcome = Outcome::kApplies;
  std::string note;                ///< one sentence, empty if there is nothing to say
  std::vector<std::size_t> parts;  ///< of Rebase::parts, those that can be put into the target

  bool canApply() const { return outcome == Outcome::kApplies || outcome == Outcome::kConflict; }
};

/// `applies`, `conflict`, `already so`, `does not apply`.
std::string_view name(CarriedEdit::Outcome state) noexcept;

struct Rebase {
  SharedModel target;
  std::vector<ModelPart> parts;
  std::vector<CarriedEdit> edits;  ///< in the order of the model: settings, terms, rules
  /// The target with the base's names of terms to which it gives the new ones already, and the parts that give them
  /// back.
  fuzzy::ForceModel named;
  std::vector<std::size_t> names;
};

/// The net edits between `base` and `tuned`, tried on `target`: several edits of one thing are one. Vertices of one
/// term belong together, in a partition those of one ramp; a term that is added, removed or split, with the rules that
/// name it. Independent of each other on the base; all of them together give `tuned` there, bit for bit. `locked`:
/// vertices that must not move. Refused: two of the models have other variables. Thread: any.
base::Result<Rebase> rebase(const fuzzy::ForceModel& base, const fuzzy::ForceModel& tuned, SharedModel target,
                            std::span<const VertexPlace> locked = {});

/// The target with the edits `chosen` (indices, in any order; those that cannot apply are left out) as one edit.
/// Refused: edits that exclude each other.
base::Result<Edit> carryOver(const Rebase& rebase, std::span<const std::size_t> chosen);

/// What `carryOver` of `chosen` changes about the force of the target.
base::Result<EditImpact> priceOf(const Rebase& rebase, std::span<const std::size_t> chosen);

}  // namespace tactus::editing
