// tactus-workbench --rehearse as another program sees it: its lines, and what can happen to it from outside.
#pragma once

#include <QProcess>
#include <QString>
#include <optional>

namespace tactus::tests {

/// A line of the rehearsal (rehearsal_progress.h).
struct RehearsalLine {
  QString screen;
  int insertions = 0;
  int judgements = 0;
  int answers = 0;
  int ratings = 0;
  int position = 0;
  bool failed = false;
};

class WatchedProgram {
 public:
  /// A rehearsal of the study at `path`, as fast as the computer can. `settings`: a folder for the program's own.
  WatchedProgram(const QString& path, const QString& settings);
  /// Ends it where it still runs.
  ~WatchedProgram();

  /// The next line; nothing: it has ended.
  std::optional<RehearsalLine> next();
  /// All of its threads stand still, as long as this call and until `thaw`. The last line that it said before; nothing:
  /// the one before is still the last.
  std::optional<RehearsalLine> freeze();
  void thaw();
  /// SIGKILL. The last line that it said; nothing: as `freeze`.
  std::optional<RehearsalLine> kill();
  /// Every write to a file fails, as on a full disk; or no longer.
  void fillDisk(bool full);
  /// Once it has ended by itself.
  int exitCode();
  QString complaint() { return QString::fromLocal8Bit(process_.readAllStandardError()); }

 private:
  std::optional<RehearsalLine> read();
  std::optional<RehearsalLine> readRest();
  bool standsStill() const;

  QProcess process_;
};

}  // namespace tactus::tests
