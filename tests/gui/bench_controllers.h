// The controllers of the tuning bench that change a model or look at it, as the program puts them together.
#pragma once

#include "app/workbench/controllers/compare_controller.h"
#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/controllers/findings_controller.h"
#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/rule_controller.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/controllers/term_controller.h"

namespace tactus::tests {

struct BenchControllers {
  workbench::ModelController models;
  workbench::SceneController scene{models};
  workbench::EditController edits{models};
  workbench::TermController terms{edits};
  workbench::RuleController rules{edits, scene};
  workbench::CompareController compare{models, edits};
  workbench::FindingsController findings{edits, scene};
};

/// What a hand can reach: of these, or of the whole program.
struct BenchReach {
  template <class Bench>
  explicit BenchReach(Bench& bench)
      : models(bench.models),
        scene(bench.scene),
        edits(bench.edits),
        terms(bench.terms),
        rules(bench.rules),
        compare(bench.compare),
        findings(bench.findings) {}

  workbench::ModelController& models;
  workbench::SceneController& scene;
  workbench::EditController& edits;
  workbench::TermController& terms;
  workbench::RuleController& rules;
  workbench::CompareController& compare;
  workbench::FindingsController& findings;
};

}  // namespace tactus::tests
