// Qt wants names of files and texts of the system in UTF-8.
#pragma once

namespace tactus::workbench {

/// Makes the environment's locale one in UTF-8 where it is none, or names one that is not there; the language stays
/// that of the program. Qt does so too, with a warning that nobody can use. To be called before the application is
/// made.
void useUtf8Locale();

}  // namespace tactus::workbench
