// Runs programs that are installed beside this one, one after another, and waits for each.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace tactus::workbench {

struct ProgramRun {
  bool ok = false;
  QByteArray said;  ///< what it printed; if it failed, its errors
};

/// The path of an installed program; empty without it.
QString installedProgram(const char* name);

/// Waits for its end, at most a minute. Thread: any but the gui.
ProgramRun runProgram(const QString& program, const QStringList& arguments);

}  // namespace tactus::workbench
