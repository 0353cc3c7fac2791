#include "app/workbench/shell/layout_menu.h"

#include <QInputDialog>
#include <QMenu>

#include "app/workbench/base/display_text.h"
#include "app/workbench/kit/message_banner.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {
namespace {

/// A name as the text of a menu's entry.
QString entryText(const QString& name) { return harmless(name).replace(QLatin1Char('&'), QLatin1String("&&")); }

}  // namespace

LayoutMenu::LayoutMenu(MainWindow& window, QMenu& menu) : QObject(&menu), window_(window), menu_(menu) {
  connect(&menu_, &QMenu::aboutToShow, this, &LayoutMenu::fill);
  fill();
}

void LayoutMenu::fill() {
  menu_.clear();
  const QStringList names = window_.panels().namedLayouts();
  for (const QString& name : names) menu_.addAction(entryText(name), this, [this, name] { show(name); });
  menu_.addSeparator();
  menu_.addAction(tr("&Keep this layout as…"), this, &LayoutMenu::askName);
  if (names.isEmpty()) return;
  QMenu* forget = menu_.addMenu(tr("&Forget"));
  for (const QString& name : names)
    forget->addAction(entryText(name), this, [this, name] { window_.panels().forgetNamed(name); });
}

void LayoutMenu::show(const QString& name) {
  if (window_.panels().showNamed(name)) return;
  window_.banner().showRemedy(
      tr("The layout %1 was not shown: it was kept with other panels than there are now.").arg(harmless(name)),
      {tr("Forget it"), [this, name] { window_.panels().forgetNamed(name); }});
}

void LayoutMenu::askName() {
  const QString name =
      QInputDialog::getText(&window_, tr("Keep this layout"), tr("Its name; one that is there is replaced:")).trimmed();
  if (name.isEmpty()) return;
  window_.panels().nameLayout(name);
  window_.say(tr("The layout is kept as %1.").arg(harmless(name)));
}

}  // namespace tactus::workbench
