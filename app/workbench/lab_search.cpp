#include "app/workbench/lab_search.h"

#include <QCoreApplication>
#include <QTabWidget>

#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/shell/main_window.h"

namespace tactus::workbench {
namespace {

struct LabSearch {
  Q_DECLARE_TR_FUNCTIONS(LabSearch)
};

/// By the names of the widgets.
struct LabPlace {
  QString text;
  const char* lab;
  const char* page = nullptr;  ///< empty: the first one; null: the lab has one page, or any will do
};

QList<LabPlace> places() {
  return {{LabSearch::tr("Table 1: insertion speed of each participant"), "speed", "table"},
          {LabSearch::tr("Table 2: votes for each force"), "force"},
          {LabSearch::tr("Table 3: answers to the usability scale"), "rules", "usability"},
          {LabSearch::tr("Fig. 3d: terms of the speed"), "speed", ""},
          {LabSearch::tr("Fig. 3e: words of the force"), "force"},
          {LabSearch::tr("Fig. 4: way of the tube on an image"), "depth"},
          {LabSearch::tr("Fig. 6: recordings of the strokes"), "speed", "strokes"},
          {LabSearch::tr("Fig. 7: clusters of each participant"), "speed", ""},
          {LabSearch::tr("Fig. 8: speed terms of each participant, and their average"), "speed", ""},
          {LabSearch::tr("Insertion length of a person"), "depth", "length"},
          {LabSearch::tr("Judgements of the forces"), "force", "judgements"},
          {LabSearch::tr("Rules of all experts, and the conflict map"), "rules", "cell"},
          {LabSearch::tr("Findings about the experts' rules"), "rules", "findings"},
          {LabSearch::tr("Agreement of the experts (Krippendorff, Kendall, Fleiss)"), "rules", "agreement"},
          {LabSearch::tr("Weights, and leaving one expert out"), "experts", "policies"},
          {LabSearch::tr("Does a choice of the method matter?"), "method"}};
}

void show(MainWindow& window, LabScreen& labs, const char* lab, const char* page) {
  window.enter(Stage::kAgree);
  for (QWidget* const one : labs.labs()) {
    if (one->objectName() != QLatin1String(lab)) continue;
    labs.reveal(one);
    auto* const pages = one->findChild<QTabWidget*>();
    if (page == nullptr || pages == nullptr) return;
    auto* const named = *page == 0 ? pages->widget(0) : pages->findChild<QWidget*>(QLatin1String(page));
    if (named != nullptr) pages->setCurrentWidget(named);
  }
}

}  // namespace

QList<SearchEntry> labEntries(MainWindow& window, LabScreen& labs) {
  QList<SearchEntry> entries;
  if (!window.canEnter(Stage::kAgree)) return entries;
  for (const LabPlace& place : places()) {
    // "Fig. 7" is found as "figure 7" too.
    const QString kind = place.text.startsWith(LabSearch::tr("Fig."))
                             ? LabSearch::tr("Figure · %1").arg(stageName(Stage::kAgree))
                             : stageName(Stage::kAgree);
    entries << SearchEntry{place.text, kind,
                           [&window, &labs, lab = place.lab, page = place.page] { show(window, labs, lab, page); }};
  }
  return entries;
}

}  // namespace tactus::workbench
