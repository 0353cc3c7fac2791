#include "app/workbench/kit/statistic_help.h"

#include <QStringList>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes_popup.h"

namespace tactus::workbench {

StatisticHelp::StatisticHelp(std::initializer_list<Statistic> statistics, QWidget* parent) : QToolButton(parent) {
  QStringList sentences;
  for (const Statistic statistic : statistics) sentences << explained(statistic);
  setText(QStringLiteral("?"));
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  setObjectName(QStringLiteral("statistic_help"));
  setAccessibleName(tr("Explain these numbers"));
  setAccessibleDescription(sentences.join(QLatin1Char('\n')));
  setToolTip(sentences.join(QLatin1Char('\n')));
  connect(this, &QToolButton::clicked, this, [this, sentences] {
    showNotesPopup(*this, mapToGlobal(QPoint(0, height() + 4)), {{tr("What these numbers mean"), sentences}});
  });
}

QSize StatisticHelp::sizeHint() const {
  const int side = 3 * theme::kGrid;
  return {side, side};
}

}  // namespace tactus::workbench
