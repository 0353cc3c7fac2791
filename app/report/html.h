// A self-contained HTML page: sections with anchors and a table of contents, tables and figures with captions. It has
// no scripts and loads nothing. Designed for screens 1280 to 1920 pixels wide and for paper. Written as XML, so that
// every tool can check it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/report/markup.h"

namespace tactus::report {

/// A cell of a table.
struct Cell {
  Markup text;
  int columns = 1;           ///< number of columns that the cell spans
  bool number = false;       ///< aligned right, with digits of equal width
  bool heading = false;      ///< heading of its row
  bool group_start = false;  ///< a line on its left separates a group of columns
};

/// A cell that holds a number or a short value.
Cell numberCell(Markup text, bool group_start = false);
/// A cell that names its row.
Cell headingCell(Markup text);

/// A table. All rows span the same number of columns.
struct Table {
  Markup caption;
  std::vector<std::vector<Cell>> head;
  std::vector<std::vector<Cell>> body;
  Markup note = {};   ///< below the table; may be empty
  bool wide = false;  ///< takes the whole width of the page
};

/// One drawing of a figure.
struct Panel {
  Markup heading = {};  ///< above the drawing, e.g. `(a) Lubrication`; may be empty
  std::string svg;      ///< one `<svg>` element
};

struct Figure {
  Markup caption;
  std::vector<Panel> panels;
  int columns = 1;  ///< panels side by side, 1 to 3
};

/// Collects the page from top to bottom.
class HtmlPage {
 public:
  HtmlPage(std::string title, Markup subtitle);

  /// From here on each caption begins with a number: `Table 1.`, `Figure 1.`
  void numberCaptions() { numbered_ = true; }

  /// Starts a section (level 2) or a subsection (level 3). Both get an anchor from the title; the table of contents
  /// lists sections.
  void section(std::string_view title);
  void subsection(std::string_view title);

  void paragraph(const Markup& text);
  void list(const std::vector<Markup>& items);
  /// A box for important notes.
  void notice(const Markup& text);
  /// A row of boxes, each with a large value above a short explanation.
  void keyNumbers(const std::vector<std::pair<Markup, Markup>>& numbers);
  void table(const Table& table);
  void figure(const Figure& figure);

  /// The whole page.
  std::string html() const;

 private:
  std::string anchorFor(std::string_view title);
  /// `Table 3. ` where captions are numbered.
  std::string numberText(std::string_view kind, int& count);

  std::string title_;
  Markup subtitle_;
  std::string contents_;
  std::string body_;
  std::vector<std::string> anchors_;
  bool numbered_ = false;
  int tables_ = 0;
  int figures_ = 0;
};

}  // namespace tactus::report
