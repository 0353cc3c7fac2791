// A hand that does anything to the terms, in any order.
#include <gtest/gtest.h>

#include "app/workbench/tune/terms/term_controller.h"
#include "core/base/random.h"
#include "core/fuzzy/validate.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using Part = Grip::Part;

class RandomHand {
 public:
  RandomHand(EditController& edits, TermController& terms, std::uint64_t seed)
      : edits_(edits), terms_(terms), random_(seed) {}

  void act() {
    const std::size_t count = terms_.terms().size();
    const std::size_t t = pick(count);
    const std::string id = terms_.terms()[t].id;
    const double range = terms_.variable().max - terms_.variable().min;
    const double place = terms_.variable().min + range * random_.uniform(-0.2, 1.2);
    switch (pick(20)) {
      case 0: {
        const auto& model = terms_.model();
        const std::size_t v = pick(model.inputs.size() + 1);
        terms_.setVariable(v == model.inputs.size() ? model.output.id : model.inputs[v].id);
        break;
      }
      case 1:
        terms_.setExpert(pick(2) == 0 ? "" : terms_.model().experts[pick(2)].id);
        terms_.chooseScope(pick(2) == 0);
        break;
      case 2: terms_.setKeepsSum(pick(2) == 0); break;
      case 3: terms_.setLocked(id, pick(4), pick(3) == 0); break;
      case 4: terms_.convert(id, fuzzy::kShapes[pick(3)]); break;
      case 5:
        if (count < 12) terms_.add(QStringLiteral("New"), place);
        break;
      case 6: terms_.remove(id, pick(4) == 0); break;
      case 7:
        if (count < 12) terms_.split(id, {place});
        break;
      case 8: terms_.rename(id, QStringLiteral("Name %1").arg(pick(100))); break;
      case 9: terms_.setOwnList(pick(2) == 0); break;
      case 10: terms_.setPoint(id, pick(4), place); break;
      case 11: edits_.undo(); break;
      case 12: edits_.redo(); break;
      case 13: terms_.selectNext(pick(2) == 0 ? 1 : -1); break;
      case 14:
      case 15:
        for (std::size_t i = pick(6) + 1; i > 0; --i) terms_.step(pick(2) == 0 ? 1 : -1, pick(3) == 0);
        if (pick(3) != 0) terms_.endSteps();
        break;
      default: dragSomething(t, range); break;
    }
  }

 private:
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_.below(static_cast<int>(count))); }

  void dragSomething(std::size_t t, double range) {
    const std::size_t part = pick(7);
    Grip grip{t, Part::kVertex, part, false};
    if (part == 4) grip = {t, Part::kLeftEdge, 0, false};
    if (part == 5) grip = {t, Part::kRightEdge, 0, false};
    if (part == 6) grip = {t, Part::kTerm, 0, false};
    if (!holds(terms_.terms(), grip)) return;
    terms_.beginMove(grip);
    for (std::size_t i = pick(8) + 1; i > 0; --i) terms_.moveBy(range * random_.uniform(-0.5, 0.5));
    switch (pick(6)) {
      case 0: terms_.cancelMove(); break;
      case 1:
        edits_.undo();  // Ctrl+Z while the button is down
        terms_.endMove();
        break;
      default: terms_.endMove(); break;
    }
  }

  EditController& edits_;
  TermController& terms_;
  base::Random random_;
};

TEST(TermHandTest, NoHandMakesAnInvalidModelAndUndoReturnsExactly) {
  const tests::ModelFolder folder;
  ModelController models;
  EditController edits{models};
  TermController terms{edits};
  models.open(folder.write(tests::twoExperts()));
  RandomHand hand(edits, terms, 7);
  constexpr int kActs = 4000;
  for (int i = 0; i < kActs; ++i) {
    hand.act();
    const auto valid = fuzzy::validate(edits.model());
    ASSERT_TRUE(valid.has_value()) << "act " << i << ": " << valid.error().message();
  }
  terms.endSteps();
  EXPECT_EQ(models.current()->model, edits.model());
  while (edits.canUndo()) edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
  EXPECT_EQ(models.current()->model, tests::twoExperts());
}

}  // namespace
}  // namespace tactus::workbench
