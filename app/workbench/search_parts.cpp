#include "app/workbench/search_parts.h"

#include <QAction>
#include <QMenuBar>

#include "app/workbench/base/display_text.h"
#include "app/workbench/lab_search.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/places.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {

SearchParts::SearchParts(MainWindow& window, LabScreen& labs, const Controllers& controllers, const Places& places)
    : window_(window), on_(controllers), places_(places) {
  sources_ = {[this] { return menuEntries(*window_.menuBar()); },
              [this] { return panelEntries(window_); },
              [this, &labs] { return labEntries(window_, labs); },
              [this] { return experts(); },
              [this] { return terms(); },
              [this] { return findings(); }};
  QAction* const search = window_.menus().addAction(MenuSlot::kHelp, tr("&Search…"), Qt::CTRL | Qt::Key_K);
  connect(search, &QAction::triggered, this, &SearchParts::open);
}

void SearchParts::open() {
  CommandSearch(
      sources_, [this](const QString& typed) { return placesIn(typed); }, &window_)
      .exec();
}

QList<SearchEntry> SearchParts::placesIn(const QString& typed) const {
  if (on_.scene.model() == nullptr) return {};
  const auto place = typedPlace(typed, on_.scene.model()->model, on_.scene.values());
  if (!place) return {};
  return {SearchEntry{tr("Go to %1").arg(place->words.join(QStringLiteral(" · "))), tr("Place: why this force"),
                      [this, point = place->point] {
                        on_.scene.goTo(point);
                        window_.enter(Stage::kUnderstand);
                        places_.rules_here.reveal();
                      }}};
}

void SearchParts::reveal(Panel& panel) const {
  window_.enter(Stage::kTune);
  panel.reveal();
}

// An expert is shown with his own terms, and his rules are in the editor.
QList<SearchEntry> SearchParts::experts() const {
  QList<SearchEntry> entries;
  if (on_.scene.model() == nullptr) return entries;
  for (const fuzzy::Expert& expert : on_.scene.model()->model.experts) {
    entries << SearchEntry{labelOf(expert), tr("Expert: rules"), [this, id = expert.id] {
                             on_.rules.setExpert(id);
                             on_.terms.setExpert(id);
                             reveal(places_.rule_editor);
                           }};
  }
  return entries;
}

QList<SearchEntry> SearchParts::terms() const {
  QList<SearchEntry> entries;
  if (on_.scene.model() == nullptr) return entries;
  const auto add = [&](const fuzzy::Variable& variable) {
    for (const fuzzy::Term& term : variable.terms) {
      entries << SearchEntry{labelOf(term), tr("Term of %1").arg(labelOf(variable)), [this, id = variable.id] {
                               on_.terms.setVariable(id);
                               reveal(places_.membership_editor);
                             }};
    }
  };
  const fuzzy::ForceModel& model = on_.scene.model()->model;
  for (const fuzzy::Variable& input : model.inputs) add(input);
  add(model.output);
  return entries;
}

QList<SearchEntry> SearchParts::findings() const {
  QList<SearchEntry> entries;
  const auto shown = on_.findings.shared();
  for (std::size_t i = 0; i < shown->size(); ++i) {
    entries << SearchEntry{(*shown)[i].kind + QStringLiteral(": ") + (*shown)[i].sentence, tr("Finding"),
                           [this, i, shown] {
                             reveal(places_.findings);
                             // Another list has come meanwhile: its findings have other numbers.
                             if (on_.findings.shared() == shown) on_.findings.choose(i);
                           }};
  }
  return entries;
}

}  // namespace tactus::workbench
