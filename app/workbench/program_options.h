// The command line of tactus-workbench.
#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

#include "app/workbench/screen_pictures.h"
#include "app/workbench/session/rehearse_start.h"
#include "core/base/error.h"

class QCoreApplication;
class QLocale;

namespace tactus::workbench {

// The languages that the program speaks: the *.ts files of translations/, carried as resources.

/// English with its plural forms, and above it the language of `locale` where the program carries it. What a language
/// has no translation for stays English. Before the first text is shown.
void installTranslations(QCoreApplication& application, const QLocale& locale);

struct ProgramOptions {
  QString file;                              ///< a model or a study; empty: none
  std::optional<PictureSettings> pictures;   ///< --screens
  QString take_part;                         ///< the study of --take-part; empty: none
  std::optional<RehearseSettings> rehearse;  ///< --rehearse
};

/// Options, arguments and their help texts. Needs no QApplication.
void describeOptions(QCommandLineParser& parser);
/// Reads what `parser` has parsed. Refuses a wrong value, and options that would be ignored beside others or without
/// them.
base::Result<ProgramOptions> readOptions(const QCommandLineParser& parser);

/// What Qt must know before there is a QApplication: that pictures need no display, and their scale.
void prepareForPictures(const PictureSettings& pictures);
/// The same pictures on each computer: no blinking cursor, no animations, no local number format.
void calmForPictures();

}  // namespace tactus::workbench
