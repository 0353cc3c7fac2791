// Adds the search (Ctrl+K) to the window: menus, panels, tables and figures of the labs, and the experts, terms,
// findings and places of the open model.
#pragma once

#include <QObject>
#include <vector>

#include "app/workbench/shell/command_search.h"

namespace tactus::workbench {

class FindingsController;
class LabScreen;
class MainWindow;
class Panel;
class RuleController;
class SceneController;
class TermController;

class SearchParts : public QObject {
  Q_OBJECT

 public:
  struct Controllers {
    SceneController& scene;
    TermController& terms;
    RuleController& rules;
    FindingsController& findings;
  };
  /// Where terms, rules, findings and the reason of a force are shown.
  struct Places {
    Panel& membership_editor;
    Panel& rule_editor;
    Panel& findings;
    Panel& rules_here;
  };
  SearchParts(MainWindow& window, LabScreen& labs, const Controllers& controllers, const Places& places);

  const std::vector<SearchSource>& sources() const { return sources_; }
  /// What is typed as a place leads to it, and to why the force is as it is there.
  QList<SearchEntry> placesIn(const QString& typed) const;

 private:
  void open();
  QList<SearchEntry> experts() const;
  QList<SearchEntry> terms() const;
  QList<SearchEntry> findings() const;
  void reveal(Panel& panel) const;

  MainWindow& window_;
  Controllers on_;
  Places places_;
  std::vector<SearchSource> sources_;
};

}  // namespace tactus::workbench
