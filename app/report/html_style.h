// The style sheet of the report, for screen and paper. Colors as in palette.h.
#pragma once

#include <string_view>

namespace tactus::report {

// It has no XML special characters (<, &), so the page stays well-formed without escaping.
inline constexpr std::string_view kStyleSheet = R"css(
:root { --ink: #1b1f24; --muted: #57606a; --line: #d5dbe1; --soft: #f6f8fa; --accent: #0b5394; }
* { box-sizing: border-box; }
html { scroll-padding-top: 16px; }
body { margin: 0; color: var(--ink); background: #fff; font: 16px/1.55 "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
header { background: #12324f; color: #fff; padding: 30px max(28px, calc((100% - 1212px) / 2)) 26px; }
header h1 { margin: 0; font-size: 30px; line-height: 1.25; font-weight: 600; }
header .subtitle { margin: 8px 0 0; color: #d3e0ec; max-width: 80ch; }
.page { display: grid; grid-template-columns: 214px minmax(0, 1fr); gap: 44px; max-width: 1268px; margin: 0 auto; padding: 28px 28px 64px; }
nav { position: sticky; top: 20px; align-self: start; max-height: calc(100vh - 40px); overflow: auto; font-size: 14px; line-height: 1.35; }
.nav-title { font-weight: 600; margin-bottom: 6px; }
nav ol { list-style: none; margin: 0; padding: 0; border-left: 2px solid var(--line); counter-reset: entry; }
nav li::before { counter-increment: entry; content: counter(entry) ". "; color: var(--muted); }
main { counter-reset: section; }
main h2::before { counter-increment: section; content: counter(section) ". "; }
nav li { padding: 4px 0 4px 14px; }
a { color: var(--accent); }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
h2 { font-size: 23px; line-height: 1.3; font-weight: 600; margin: 52px 0 12px; padding-top: 14px; border-top: 2px solid var(--line); }
main > h2:first-child { margin-top: 0; padding-top: 0; border-top: 0; }
h3 { font-size: 18px; font-weight: 600; margin: 34px 0 8px; }
p, ul { margin: 0 0 14px; max-width: 84ch; }
ul { padding-left: 22px; }
li { margin-bottom: 5px; }
nav li { margin-bottom: 0; }
.muted { color: var(--muted); }
.notice { border: 1px solid #e3b778; border-left: 5px solid #d9822b; background: #fff8ee; padding: 12px 16px; margin: 0 0 20px; border-radius: 4px; }
.key-numbers { display: grid; grid-template-columns: repeat(4, 1fr); gap: 12px; margin: 4px 0 22px; }
.key-numbers > div { border: 1px solid var(--line); border-radius: 6px; padding: 12px 14px; }
.key-numbers .value { font-size: 22px; font-weight: 600; line-height: 1.25; font-variant-numeric: tabular-nums; }
.key-numbers .what { font-size: 14px; line-height: 1.4; color: var(--muted); margin-top: 3px; }
.badge { display: inline-block; font-size: 12px; line-height: 17px; font-weight: 600; padding: 0 7px; border-radius: 9px; border: 1px solid; white-space: nowrap; vertical-align: 1px; }
.badge.simulated { color: #8a4b00; background: #fff1dc; border-color: #e7b36a; }
.badge.published { color: #0b4a7d; background: #e6f1fb; border-color: #8fbfe6; }
.badge.computed { color: #0f5c46; background: #e4f5ef; border-color: #82c9b1; }
.badge.construction { color: #6b3462; background: #f8eaf4; border-color: #d6a3c8; }
.badge.yes { color: #fff; background: #1a7f5a; border-color: #1a7f5a; }
.badge.no { color: #fff; background: #b0413e; border-color: #b0413e; }
.badge.none { color: var(--muted); background: #fff; border-color: #b6bec7; }
.table { margin: 18px 0 26px; overflow-x: auto; }
table { border-collapse: collapse; min-width: 60%; font-size: 14.5px; line-height: 1.4; }
.table.wide table { width: 100%; }
.caption-number { font-weight: 600; }
caption { text-align: left; font-size: 14.5px; padding-bottom: 8px; line-height: 1.5; }
th, td { padding: 5px 10px; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
thead th { border-bottom: 1px solid var(--line); font-weight: 600; vertical-align: bottom; }
thead tr:last-child th { border-bottom: 1.5px solid #8b949e; }
thead tr + tr th.number { font-weight: 400; color: var(--muted); }
thead th.number { white-space: normal; }
thead th.span { text-align: center; }
thead th.blank { border-bottom: 0; }
tbody th { font-weight: 600; }
tbody td.span { background: var(--soft); }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.group { border-left: 1px solid #b6bec7; }
.note { font-size: 14px; color: var(--muted); margin: 8px 0 0; }
figure { margin: 22px 0 30px; }
.panels { display: grid; gap: 18px 20px; }
.panels.columns-2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
.panels.columns-3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
.panel-heading { font-size: 14.5px; line-height: 1.45; font-weight: 600; margin-bottom: 4px; }
.panel-heading .muted { font-weight: 400; margin-left: 4px; }
.panel svg { display: block; width: 100%; height: auto; }
figcaption { font-size: 14.5px; line-height: 1.5; margin-top: 8px; max-width: 96ch; }
@media (min-width: 1700px) {
  body { font-size: 17px; }
  header { padding-left: max(28px, calc((100% - 1444px) / 2)); padding-right: max(28px, calc((100% - 1444px) / 2)); }
  .page { max-width: 1500px; grid-template-columns: 250px minmax(0, 1fr); }
  nav, .note, .key-numbers .what { font-size: 15px; }
  table, caption, figcaption, .panel-heading { font-size: 15.5px; }
}
@media (max-width: 1000px) {
  .page { display: block; }
  nav { position: static; margin-bottom: 28px; max-height: none; }
  .key-numbers { grid-template-columns: repeat(2, 1fr); }
  .panels.columns-2, .panels.columns-3 { grid-template-columns: 1fr; }
}
@media print {
  @page { size: A4; margin: 16mm 15mm 18mm; @bottom-center { content: counter(page) " of " counter(pages); font: 9pt Arial, sans-serif; color: #57606a; } }
  body { font-size: 10.5pt; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  header { background: none; color: var(--ink); padding: 0 0 8px; border-bottom: 2px solid var(--line); }
  header .subtitle { color: var(--muted); }
  .page { display: block; padding: 12px 0 0; max-width: none; }
  nav { position: static; max-height: none; margin-bottom: 18px; columns: 2; }
  .key-numbers { grid-template-columns: repeat(4, 1fr); }
  .panels.columns-2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .panels.columns-3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
  h2, h3 { break-after: avoid; }
  h2 { margin-top: 26px; }
  .panel, .key-numbers, .notice, tr, figure:not(.long), .table:not(.wide):not(.tall) { break-inside: avoid; }
  .panel svg { max-height: 225mm; }
  thead { display: table-header-group; }
  figcaption { break-before: avoid; }
  .key-numbers .value { font-size: 14pt; }
  .key-numbers .what { font-size: 9pt; }
  .table { overflow: visible; }
  table, caption, figcaption { font-size: 9pt; }
  th, td { padding: 3px 6px; }
  a { color: inherit; text-decoration: none; }
}
)css";

}  // namespace tactus::report
