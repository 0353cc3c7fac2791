// What the search (Ctrl+K) finds in stage Agree: the tables and figures of the paper by their numbers, and the labs'
// pages.
#pragma once

#include "app/workbench/shell/command_search.h"

namespace tactus::workbench {

class LabScreen;
class MainWindow;

/// Nothing while stage Agree cannot be entered.
QList<SearchEntry> labEntries(MainWindow& window, LabScreen& labs);

}  // namespace tactus::workbench
