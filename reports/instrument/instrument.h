// The report of a measuring subcommand (`ladder`, `precision`, ...): tables, plots and notes, for the terminal and for
// a page, and the same figures as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {
// Tables for a terminal.

// Whether a cell is one number, perhaps with a sign: such cells are right-aligned.
bool is_number(const std::string& cell);
// Aligned columns, two spaces before each; every row has a cell for each column. A control character, which a terminal
// would obey, is shown as '?'.
std::string aligned_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows);

// A sphere and a triangle, drawn on a page beside a sentence and text to paste.
struct InstrumentScene {
  std::string title, sentence;
  std::string code;             // in the language of what it is about, lines; empty: none
  std::string needs;            // the package, and its version, that the code loads; empty: not stated
  std::string command;          // for a shell, lines
  Json query = Json::object();  // "a", "b", "c", "p" and "r" as hex-floats, as a witness has them
};

// A cell is text that is ready to read; numbers are right-aligned.
struct InstrumentTable {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<InstrumentScene> scenes{};  // below the table on a page; in text, after all tables, those with code
  // A page has a table for each heading, or more of ten columns each. `heading_of` has for each column 1 + the place of
  // its heading; 0: it is in every table. Empty: one table.
  std::vector<std::string> headings{};
  std::vector<std::size_t> heading_of{};
  bool is_folded = false;  // on a page, after all others
};

// What a page begins with. In text the notes and the tables say it.
struct InstrumentFirst {
  InstrumentTable table;
  std::optional<InstrumentScene> worst;
  std::vector<std::string> sentences;
};

struct InstrumentSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;       // finite; all above 0 on a logarithmic axis
  std::vector<std::string> labels;                     // one for each point, or none
  std::vector<std::pair<double, double>> intervals{};  // of y, drawn as error bars: one for each point, or none
};

struct InstrumentPlot {
  enum class Kind { line, scatter };
  std::string caption, x_label, y_label;
  Kind kind = Kind::line;
  bool x_log = false, y_log = false;
  std::vector<InstrumentSeries> series;
  std::vector<std::string> x_names{};  // names of x = 0, 1, ... where x counts named things; else empty
};

struct InstrumentReport {
  // Adds a table that has rows.
  void add(InstrumentTable table) {
    if (!table.rows.empty()) tables.push_back(std::move(table));
  }

  std::string name;  // that of the subcommand
  std::string title;
  std::string command;             // produces the report again
  std::vector<std::string> notes;  // what was measured, in which units, and what it does not cover; one paragraph each
  std::vector<InstrumentTable> tables;
  std::vector<InstrumentPlot> plots;
  Json data;                                        // every figure, by name
  std::string notes_heading = "What was measured";  // of the notes on the page
  std::optional<InstrumentFirst> first = {};
  bool are_notes_last = false;  // on the page, folded: they say what words mean
  bool is_of_nothing = false;   // nothing was measured or judged: its command exits with 1
};

// The tables as aligned columns, and the notes.
std::string instrument_text(const InstrumentReport& report);
// One self-contained HTML file, for a browser without a network.
std::string instrument_page(const InstrumentReport& report);

}  // namespace axiscert
