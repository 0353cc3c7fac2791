#include "app/workbench/bench_screens.h"

#include "app/workbench/feel_parts.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {

BenchScreens::BenchScreens(MainWindow& window, const BenchPanels& panels) {
  using Place = PanelPlace;
  window.addScreen(
      Stage::kUnderstand,
      {Place::first(panels.curves), Place::below(panels.rules_here, 38, panels.curves),
       Place::right(panels.map, 44, panels.curves), Place::behind(panels.surface, panels.map),
       Place::behind(panels.terms_here, panels.rules_here), Place::right(panels.reading, 26, panels.rules_here)},
      {Place::first(panels.curves), Place::below(panels.rules_here, 40, panels.curves),
       Place::right(panels.map, 44, panels.curves), Place::behind(panels.surface, panels.map),
       Place::behind(panels.terms_here, panels.rules_here), Place::behind(panels.reading, panels.rules_here)});
  // What is edited, what that does to the curves, and how it feels, at one glance.
  window.addScreen(Stage::kTune,
                   {Place::first(panels.membership_editor), Place::behind(panels.rule_editor, panels.membership_editor),
                    Place::behind(panels.findings, panels.membership_editor),
                    Place::right(panels.curves, 51, panels.membership_editor),
                    Place::below(panels.feel, 43, panels.curves), Place::behind(panels.map, panels.feel),
                    Place::behind(panels.surface, panels.feel), Place::behind(panels.rules_here, panels.feel),
                    Place::behind(panels.reading, panels.feel), Place::behind(panels.history, panels.feel)},
                   // Two places instead of three. The surface, for which the tabs have no room, is in Understand.
                   {Place::first(panels.membership_editor), Place::behind(panels.rule_editor, panels.membership_editor),
                    Place::behind(panels.findings, panels.membership_editor),
                    Place::behind(panels.history, panels.membership_editor),
                    Place::right(panels.curves, 51, panels.membership_editor),
                    Place::behind(panels.feel, panels.curves), Place::behind(panels.map, panels.curves),
                    Place::behind(panels.rules_here, panels.curves), Place::behind(panels.reading, panels.curves)});
  window.addLayout(FeelParts::layoutId(), {Place::first(panels.feel)});
  window.addScreen(Stage::kDeliver,
                   {Place::first(panels.readiness), Place::right(panels.bundle, 52, panels.readiness)});
}

}  // namespace tactus::workbench
