#include "app/workbench/model/author_name.h"

#include <QSettings>

#include "app/workbench/model/edit_controller.h"

namespace tactus::workbench {
namespace {

constexpr auto kKey = "author";

}  // namespace

AuthorName::AuthorName(QSettings& settings, EditController& edits, QObject* parent)
    : QObject(parent), settings_(settings), edits_(edits) {
  edits_.setAuthor(name());
}

QString AuthorName::name() const { return settings_.value(QLatin1String(kKey)).toString(); }

void AuthorName::setName(const QString& name) {
  settings_.setValue(QLatin1String(kKey), name.trimmed());
  edits_.setAuthor(name);
}

}  // namespace tactus::workbench
