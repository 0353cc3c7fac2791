// Tens of thousands of random gestures: never an invalid model, undo always exact, terms that sum to one still do.
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "app/editing/edit.h"
#include "app/editing/edit_history.h"
#include "app/editing/rebase.h"
#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"
#include "app/editing/step_fixes.h"
#include "app/editing/term_edits.h"
#include "core/base/random.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"

#include "tests/app/editing/sample_models.h"
#include "tests/support/day.h"
#include "tests/support/random_model.h"

namespace tactus::editing {
namespace {

class Gestures {
 public:
  Gestures(std::uint64_t seed, bool hostile) : random_(seed), hostile_(hostile) {}

  base::Result<Edit> any(const fuzzy::ForceModel& model) {
    const fuzzy::Variable& variable = chooseVariable(model);
    const TermListId list = listOf(model, variable);
    const TermPlace term = termOf(model, variable, list);
    const std::string who = expert(model);
    const auto rules = random_.below(2) == 0 ? RulesOfTerm::kRefuse : RulesOfTerm::kRemove;
    const auto index = static_cast<std::size_t>(random_.below(static_cast<int>(model.experts[0].rules.size()) + 1));
    const bool coin = random_.below(2) == 0;
    switch (random_.below(17)) {
      case 0: return addTerm(model, list, suggestedTerm(variable, variable.terms, place(variable)));
      case 1: return removeTerm(model, term, {rules, coin});
      case 2: return renameTerm(model, term, "t" + std::to_string(random_.below(12)), "T");
      case 3: {
        SplitOptions options;
        options.cuts = {place(variable)};
        if (coin) options.cuts.push_back(place(variable));
        options.copy_rules = random_.below(4) != 0;
        return splitTerm(model, term, options);
      }
      case 4: return convertShape(model, term, fuzzy::kShapes[random_.below(3)]);
      case 5: return coin ? makeOwn(model, {variable.id, who}) : backToShared(model, {variable.id, who}, rules);
      case 6: return makeSumToOne(model, list);
      case 7: return answer(model, who);
      case 8:
        return coin ? enableRules(model, who, std::span(&index, 1), random_.below(2) == 0)
                    : removeRules(model, who, std::span(&index, 1));
      case 9: return coin ? setRuleWeight(model, who, index, number(1)) : setExpertWeight(model, who, number(2));
      case 10: return acceptance(model);
      case 11: return contract(model);
      default: return move(model, variable, term);
    }
  }

  base::Result<Edit> move(const fuzzy::ForceModel& model, const fuzzy::Variable& variable, const TermPlace& term) {
    const MoveOptions options{random_.below(4) == 0, {}};
    const double to = place(variable);
    const double way = place(variable) - to;
    switch (random_.below(4)) {
      case 0: return moveEdge(model, term, random_.below(2) == 0 ? Side::kLeft : Side::kRight, way, options);
      case 1: return moveTerm(model, term, way, options);
      default:
        return moveVertex(model, {term.list, term.term, static_cast<std::size_t>(random_.below(4))}, to, options);
    }
  }

  base::Random& random() { return random_; }

 private:
  template <class List>
  const auto& pick(const List& list) {
    return list[static_cast<std::size_t>(random_.below(static_cast<int>(list.size())))];
  }
  const fuzzy::Variable& chooseVariable(const fuzzy::ForceModel& model) {
    const auto which = static_cast<std::size_t>(random_.below(static_cast<int>(model.inputs.size()) + 1));
    return which < model.inputs.size() ? model.inputs[which] : model.output;
  }
  std::string expert(const fuzzy::ForceModel& model) { return pick(model.experts).id; }
  TermListId listOf(const fuzzy::ForceModel& model, const fuzzy::Variable& variable) {
    return random_.below(20) == 0 ? TermListId{variable.id, expert(model)}
                                  : editing::listOf(pick(model.experts), variable.id);
  }
  TermPlace termOf(const fuzzy::ForceModel& model, const fuzzy::Variable& variable, const TermListId& list) {
    if (list.expert.empty()) return {list, pick(variable.terms).id};
    return {list, pick(termsFor(**findExpert(model, list.expert), variable)).id};
  }
  base::Result<Edit> answer(const fuzzy::ForceModel& model, const std::string& who) {
    const auto& region = model.inputs[model.inputs.size() > 2 ? 2 : 0];
    const auto& condition = pick(model.inputs);
    const CellPlace cell{pick(condition.terms).id, pick(region.terms).id};
    std::optional<std::string> then;
    if (random_.below(4) != 0) then = pick(model.output.terms).id;
    return setAnswer(model, {who, condition.id, region.id}, cell, then);
  }

  base::Result<Edit> acceptance(const fuzzy::ForceModel& model) {
    if (random_.below(4) == 0) return forgetLapsed(model);
    if (!model.accepted_holes.empty() && random_.below(2) == 0)
      return withdrawAcceptance(model, pick(model.accepted_holes));
    return acceptHole(model, "depth " + std::to_string(random_.below(5)) + " to 6 mm");
  }

  base::Result<Edit> contract(const fuzzy::ForceModel& model) {
    const auto index = static_cast<std::size_t>(random_.below(static_cast<int>(model.contracts.size()) + 1));
    if (random_.below(3) == 0) return removeContract(model, index);
    fuzzy::Contract made;
    made.kind = fuzzy::kContractKinds[random_.below(7)];
    const fuzzy::Variable& input = pick(model.inputs);
    made.input = input.id;
    made.word = pick(input.terms).id;
    made.than = pick(input.terms).id;
    made.within = number(2);
    made.limit = number(1);
    if (random_.below(2) == 0) made.where = {{input.id, made.word}};
    return random_.below(2) == 0 ? addContract(model, made) : replaceContract(model, index, made);
  }

  double number(double range) {
    if (hostile_ && random_.below(20) == 0) {
      constexpr double kOdd[] = {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -1e308,
                                 1e200,
                                 -0.0,
                                 5e-324};
      return kOdd[random_.below(6)];
    }
    return range * random_.uniform();
  }
  /// Mostly inside the universe.
  double place(const fuzzy::Variable& variable) {
    const double range = variable.max - variable.min;
    const double far = random_.below(5) == 0 ? 3 : 1;
    const double shift = random_.below(5) == 0 ? range : 0;
    return variable.min + far * number(range) - shift;
  }

  base::Random random_;
  bool hostile_;
};

/// Gestures, some of them with several updates, on `start`; then everything undone. Counts the edits.
void play(const fuzzy::ForceModel& start, std::uint64_t seed, int count, int& edits) {
  auto history = EditHistory::open(start, "start", {}, study::RecordIds(seed)).value();
  Gestures gestures(seed, true);
  std::vector<std::string> texts = {model_io::formatModel(start)};
  for (int k = 0; k < count; ++k) {
    const int updates = gestures.random().below(3) + 1;
    history.begin();
    for (int u = 0; u < updates; ++u) {
      auto edit = gestures.any(history.base());
      if (!edit) {
        ASSERT_FALSE(edit.error().message().empty());
        continue;
      }
      ASSERT_TRUE(fuzzy::validate(edit->model)) << edit->label;
      ASSERT_FALSE(edit->label.empty());
      history.update(std::move(*edit));
      ++edits;
    }
    if (gestures.random().below(8) == 0) {
      history.cancel();
    } else if (history.commit({})) {
      texts.push_back(model_io::formatModel(history.model()));
    }
    // A few steps back and forth on the way.
    if (gestures.random().below(30) == 0 && history.canUndo()) {
      const auto before = history.model();
      ASSERT_TRUE(history.undo({}));
      ASSERT_EQ(model_io::formatModel(history.model()), texts[texts.size() - 2]);
      ASSERT_TRUE(history.redo({}));
      ASSERT_TRUE(sameBits(history.model(), before));
    }
  }
  while (history.canUndo()) {
    texts.pop_back();
    ASSERT_TRUE(history.undo({}));
    ASSERT_EQ(model_io::formatModel(history.model()), texts.back());
  }
  ASSERT_TRUE(sameBits(history.model(), start));
  EXPECT_EQ(texts.size(), 1);
}

TEST(GestureFuzz, OnTheNgtModel) {
  int edits = 0;
  const int runs = support::rounds(60);
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = support::firstSeedOfToday() + static_cast<std::uint64_t>(run);
    auto model = support::s4AsPrinted();
    if (run % 2 == 0) {
      model.experts.push_back(model.experts[0]);
      model.experts[1].id = "S5";
    }
    play(model, seed, 300, edits);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(edits, 333 * runs);  // the others are refused, as they should be
}

TEST(GestureFuzz, OnRandomModels) {
  base::Random random(support::seedOfToday());
  int edits = 0;
  const int runs = support::rounds(200);
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = support::firstSeedOfToday() + static_cast<std::uint64_t>(run);
    const auto model = support::randomModel(random, {.gaussians = run % 2 == 0, .adversarial = run % 3 == 0});
    play(model, seed, 50, edits);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(edits, 20 * runs);
}

TEST(GestureFuzz, TermsThatSumToOneStillDo) {
  auto model = support::s4AsPrinted();
  Gestures gestures(3, true);
  const auto random = [&](int below) { return static_cast<std::size_t>(gestures.random().below(below)); };
  int moved = 0;
  for (int k = 0; k < 20000; ++k) {
    const auto& input = model.inputs[random(4)];
    const auto& term = input.terms[random(static_cast<int>(input.terms.size()))];
    const double range = input.max - input.min;
    const double to = gestures.random().uniform(input.min - range / 4, input.max + range / 4);
    const MoveOptions options{true, {}};
    const TermPlace place{{input.id, ""}, term.id};
    const auto kind = random(3);
    auto edit = kind == 0   ? moveVertex(model, {place.list, term.id, random(4)}, to, options)
                : kind == 1 ? moveEdge(model, place, random(2) == 0 ? Side::kLeft : Side::kRight, to / 4, options)
                            : moveTerm(model, place, (to - input.min) / 4 - range / 8, options);
    ASSERT_TRUE(edit) << edit.error().message();
    const auto& after = variableIn(edit->model, input.id);
    ASSERT_TRUE(partitionOrder(after, after.terms)) << edit->label;
    if (k % 100 == 0) {
      // Ramps are at least a millionth of the universe wide: x - a and d - x round by up to 2^-53 of the universe each.
      ASSERT_LE(furthestFromOne(after, after.terms, 200), 1e-9) << edit->label;
    }
    if (!sameBits(edit->model, model)) ++moved;
    model = std::move(edit->model);
  }
  EXPECT_GT(moved, 10000);
}

/// `count` accepted edits of `model`.
fuzzy::ForceModel tuned(fuzzy::ForceModel model, std::uint64_t seed, int count) {
  Gestures gestures(seed, false);
  for (int k = 0; k < count; ++k) {
    auto edit = gestures.any(model);
    if (edit) model = std::move(edit->model);
  }
  return model;
}

// Carried over to the model they come from, the edits give the tuned one; to the tuned one, nothing; to any other, a
// valid model, and the same one in any order of those that go together.
TEST(GestureFuzz, EditsAreCarriedOver) {
  base::Random random(support::seedOfToday());
  int carried = 0;
  const int runs = support::rounds(300);
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = support::firstSeedOfToday() + static_cast<std::uint64_t>(run);
    const auto base = run % 3 == 0 ? support::s4AsPrinted()
                                   : support::randomModel(random, {.gaussians = run % 2 == 0, .adversarial = false});
    const auto mine = tuned(base, seed, 1 + run % 12);
    const auto all = [](const Rebase& rebase) {
      std::vector<std::size_t> out(rebase.edits.size());
      std::iota(out.begin(), out.end(), std::size_t{0});
      return out;
    };
    const auto onto = [&](const fuzzy::ForceModel& target) {
      return rebase(base, mine, ready(target).value()).value();
    };

    const Rebase back = onto(base);
    ASSERT_TRUE(sameBits(carryOver(back, all(back)).value().model, mine)) << "seed " << seed;
    for (const CarriedEdit& edit : back.edits) {
      ASSERT_TRUE(edit.canApply() || edit.outcome == CarriedEdit::Outcome::kAlreadySo)
          << edit.what << ": " << edit.note;
      ++carried;
    }
    const Rebase again = onto(mine);
    for (const CarriedEdit& edit : again.edits) ASSERT_FALSE(edit.canApply()) << "seed " << seed << ": " << edit.what;

    const auto other = tuned(base, seed + 1'000'000, 6);
    const Rebase moved = onto(other);
    for (std::size_t e = 0; e < moved.edits.size(); ++e) {
      ASSERT_TRUE(carryOver(moved, std::span(&e, 1))) << "seed " << seed << ": " << moved.edits[e].what;
    }
  }
  EXPECT_GT(carried, 2 * runs);
}

}  // namespace
}  // namespace tactus::editing
