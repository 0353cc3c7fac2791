// The search over everything that has a name (Ctrl+K): type a word, press Enter.
#pragma once

#include <QDialog>
#include <QList>
#include <QString>
#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;
class QMenuBar;

namespace tactus::workbench {

/// Something that can be found.
struct SearchEntry {
  QString text;
  QString kind;  ///< what it is, and the keys that lead there too: `Menu File · Ctrl+O`
  std::function<void()> run;
};

/// Gives what can be found at the moment at which the search opens.
using SearchSource = std::function<QList<SearchEntry>()>;

/// Gives what is meant by what is typed, where that is no name: it stands before what is found.
using SearchReading = std::function<QList<SearchEntry>(const QString& typed)>;

/// The entries that hold each word of `typed`, wherever it stands in text or kind; those whose text begins with it
/// first, otherwise in their order. Without words all of them.
QList<SearchEntry> foundEntries(const QList<SearchEntry>& all, const QString& typed);

class CommandSearch : public QDialog {
  Q_OBJECT

 public:
  CommandSearch(const std::vector<SearchSource>& sources, SearchReading reading, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find(const QString& typed);
  void choose();

  QList<SearchEntry> all_;
  SearchReading reading_;
  QList<SearchEntry> found_;
  QLineEdit* line_;
  QListWidget* list_;
};

// What the search finds in the window itself: the entries of its menus, and its panels.

class MainWindow;
class Panel;

/// Actions that can be used now, with their menu and keys.
QList<SearchEntry> menuEntries(const QMenuBar& bar);

/// The panels, while a model is open.
QList<SearchEntry> panelEntries(MainWindow& window);

/// Brings `panel` to the front in the stage that is shown, or in Understand where that shows no panels.
void goToPanel(MainWindow& window, Panel& panel);

}  // namespace tactus::workbench
