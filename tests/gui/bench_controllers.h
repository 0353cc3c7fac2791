// The controllers of the tuning bench that change a model or look at it, as the program puts them together.
#pragma once

#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::tests {

struct BenchControllers {
  workbench::ModelController models;
  workbench::SceneController scene{models};
  workbench::EditController edits{models};
  workbench::TermController terms{edits};
  workbench::Selection selection{edits};
  workbench::RuleController rules{edits, scene, selection};
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
