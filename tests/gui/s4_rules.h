// Table A2 of the paper, open, with the controllers of its rules: what tests of the rule editor begin with.
#pragma once

#include <gtest/gtest.h>

#include "app/workbench/tune/rules/rule_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::tests {

/// Grids of S4: lubrication (poor, medium, well), neck flexion (small, medium, large), speed (slow, medium, fast)
/// against six regions of depth. Table A2 has no oropharynx, column 2.
class S4Rules : public testing::Test {
 protected:
  void SetUp() override {
    start.created_utc = "2026-11-21T08:00:00Z";
    start.generator = "tactus tests";
    models.open(folder.write(start));
    ASSERT_TRUE(rules.isOpen());
  }

  const fuzzy::Rule& rule(std::size_t index) const { return rules.expert().rules[index]; }
  std::size_t count() const { return rules.expert().rules.size(); }

  ModelFolder folder;
  fuzzy::ForceModel start = support::s4AsPrinted();
  workbench::ModelController models;
  workbench::SceneController scene{models};
  workbench::EditController edits{models};
  workbench::Selection selection{edits};
  workbench::RuleController rules{edits, scene, selection};
};

}  // namespace tactus::tests
