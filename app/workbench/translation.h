// The languages that the program speaks: the *.ts files of translations/, carried as resources.
#pragma once

class QCoreApplication;
class QLocale;

namespace tactus::workbench {

/// English with its plural forms, and above it the language of `locale` where the program carries it. What a language
/// has no translation for stays English. Before the first text is shown.
void installTranslations(QCoreApplication& application, const QLocale& locale);

}  // namespace tactus::workbench
