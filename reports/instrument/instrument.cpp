#include "reports/instrument/instrument.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/text/json.h"
#include "reports/page/page_template.h"

namespace axiscert {
namespace {

std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

}  // namespace

bool is_number(const std::string& cell) {
  return cell.find_first_of("0123456789") <= 1 && cell.find_first_not_of("0123456789.,+-e") == cell.npos;
}

std::string aligned_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::string& column : columns) widths.push_back(column.size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells, bool is_head) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool right = is_head ? !rows.empty() && is_number(rows.front()[i]) : is_number(cells[i]);
      line += right ? fmt::format("  {:>{}}", printable(cells[i]), widths[i])
                    : fmt::format("  {:<{}}", printable(cells[i]), widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add(columns, true);
  for (const auto& row : rows) add(row, false);
  return text;
}

// An instrument's tables for the terminal, and the code of their scenes.

namespace {

std::string scene_text(const InstrumentScene& scene) {
  std::string text = fmt::format("{}: {}{}\n", scene.title, scene.sentence,
                                 scene.needs.empty() ? "" : fmt::format(" With {}:", scene.needs));
  for (std::size_t begin = 0; begin < scene.code.size();) {
    const std::size_t end = scene.code.find('\n', begin);
    text += fmt::format("    {}\n", std::string_view(scene.code).substr(begin, end - begin));
    begin = end == scene.code.npos ? end : end + 1;
  }
  return text + "\n";
}

}  // namespace

std::string instrument_text(const InstrumentReport& report) {
  std::string text = report.title + "\n\n";
  for (const InstrumentTable& table : report.tables) {
    text += fmt::format("{}\n{}\n", table.caption, aligned_table(table.columns, table.rows));
  }
  for (const InstrumentTable& table : report.tables) {
    for (const InstrumentScene& scene : table.scenes) {
      if (!scene.code.empty()) text += scene_text(scene);
    }
  }
  return text + fmt::format("{}\n", fmt::join(report.notes, "\n"));
}

// An instrument's page: tables and scenes as HTML, plots drawn by Chart.js from the figures beneath them.

namespace {

// With places where a line may end: before the section of a document, and after a folder.
std::string wrapped_html(const std::string& text) {
  std::string html;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '#' && text[i - 1] != '/') continue;
    html += html_text(text.substr(begin, i - begin)) + "<wbr>";
    begin = i;
  }
  return html + html_text(text.substr(begin));
}

// The look of a cell whose text is a state of a level; null for any other text.
const char* state_look(const std::string& cell) {
  return cell == "met" ? "good" : cell == "not met" ? "bad" : cell == "NOT CHECKED" ? "warn" : nullptr;
}

// With `labels`, cells but the first have the heads of their columns: a phone shows them in place of the head.
std::string cells(const std::vector<std::string>& row, const char* tag,
                  const std::vector<std::string>* labels = nullptr) {
  std::string html;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char* element = i == 0 ? "th" : tag;
    // Sentences, names of sections and paths are wrapped: a table of advice, or of kernels by their files, has to fit
    // on the page.
    const bool is_long = row[i].size() > 16 && row[i].find_first_of(" #/") != std::string::npos;
    const bool is_labelled = labels != nullptr && i != 0;
    const char* const look = is_long                                        ? "words"
                             : is_labelled && state_look(row[i]) != nullptr ? state_look(row[i])
                             : i != 0 && is_number(row[i])                  ? "n"
                                                                            : nullptr;
    html += fmt::format("<{0}{1}{2}>{3}</{0}>", element, look == nullptr ? "" : fmt::format(" class=\"{}\"", look),
                        is_labelled ? fmt::format(" data-label=\"{}\"", html_text((*labels)[i])) : "",
                        is_long ? wrapped_html(row[i]) : html_text(row[i]));
  }
  return html;
}

// Text to paste; the script adds a button that copies it.
std::string paste_html(const std::string& label, const std::string& text) {
  if (text.empty()) return "";
  return fmt::format("<div><p class=\"label\">{}</p>\n<div class=\"command\"><pre><code>{}</code></pre></div></div>\n",
                     html_text(label), html_text(text));
}

// The script puts the picture in its place.
std::string scene_html(const InstrumentScene& scene) {
  const std::string label = scene.needs.empty() ? "Code to paste" : fmt::format("Code to paste, with {}", scene.needs);
  return fmt::format(
      "<article class=\"worst\"><h3>{}</h3>\n<p>{}</p>\n"
      "<div class=\"columns\"><div class=\"picture\"></div><div class=\"stack\">{}{}</div></div></article>\n",
      html_text(scene.title), html_text(scene.sentence), paste_html(label, scene.code),
      paste_html("Judge it here", scene.command));
}

constexpr std::size_t columns_that_fit = 12;  // of short cells, at the usual size of letters

std::string grid_html(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                      bool has_labels = false) {
  std::string html = fmt::format("<div class=\"scroll\" tabindex=\"0\"><table{}><thead><tr>{}</tr></thead><tbody>\n",
                                 columns.size() > columns_that_fit ? " class=\"dense\"" : "", cells(columns, "th"));
  for (const auto& row : rows) html += fmt::format("<tr>{}</tr>\n", cells(row, "td", has_labels ? &columns : nullptr));
  return html + "</tbody></table></div>\n";
}

constexpr std::size_t columns_side_by_side = 10;

// The rows with these columns alone; a row may end early.
std::string part_html(const InstrumentTable& table, const std::vector<std::size_t>& places) {
  const auto part = [&](const std::vector<std::string>& row) {
    std::vector<std::string> some;
    for (const std::size_t i : places) some.push_back(i < row.size() ? row[i] : "");
    return some;
  };
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : table.rows) rows.push_back(part(row));
  return grid_html(part(table.columns), rows);
}

std::string grids_html(const InstrumentTable& table) {
  if (table.headings.empty()) return grid_html(table.columns, table.rows);
  const auto places_of = [&](std::size_t heading) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.heading_of[i] == heading) places.push_back(i);
    }
    return places;
  };
  const std::vector<std::size_t> common = places_of(0);
  std::string html;
  for (std::size_t heading = 1; heading <= table.headings.size(); ++heading) {
    const std::vector<std::size_t> own = places_of(heading);
    if (!own.empty()) html += fmt::format("<h3>{}</h3>\n", html_text(table.headings[heading - 1]));
    for (std::size_t first = 0; first < own.size(); first += columns_side_by_side) {
      std::vector<std::size_t> shown = common;
      const std::size_t end = std::min(own.size(), first + columns_side_by_side);
      shown.insert(shown.end(), own.begin() + static_cast<std::ptrdiff_t>(first),
                   own.begin() + static_cast<std::ptrdiff_t>(end));
      html += part_html(table, shown);
    }
  }
  return html;
}

std::string table_html(const InstrumentTable& table) {
  std::string html = grids_html(table);
  for (const InstrumentScene& scene : table.scenes) html += scene_html(scene);
  const std::string caption = html_text(table.caption);
  if (table.is_folded)
    return fmt::format("<section><details><summary><h2>{}</h2></summary>\n{}</details></section>\n", caption, html);
  return fmt::format("<section><h2>{}</h2>\n{}</section>\n", caption, html);
}

std::string first_html(const InstrumentFirst& first) {
  std::string sentences, worst;
  for (const std::string& sentence : first.sentences) sentences += fmt::format("<li>{}</li>\n", html_text(sentence));
  if (first.worst) {
    worst = fmt::format("<article class=\"worst\"><h3>{}</h3>\n<p>{}</p>\n<div class=\"picture\"></div></article>\n",
                        html_text(first.worst->title), html_text(first.worst->sentence));
  }
  return fmt::format(
      "<section id=\"answer\"><h2>{}</h2>\n<div class=\"first\"><div><ul class=\"sentences\">{}</ul>{}</div>{}</div>"
      "</section>\n",
      html_text(first.table.caption), sentences, grid_html(first.table.columns, first.table.rows, true), worst);
}

std::string note_html(const std::string& note) { return fmt::format("<p class=\"lead\">{}</p>\n", html_text(note)); }

std::string notes_html(const InstrumentReport& report) {
  std::string notes;
  for (const std::string& note : report.notes) notes += note_html(note);
  const std::string heading = html_text(report.notes_heading);
  if (!report.are_notes_last) return fmt::format("<section><h2>{}</h2>\n{}</section>\n", heading, notes);
  return fmt::format("<section id=\"words\"><details><summary><h2>{}</h2></summary>\n{}</details></section>\n", heading,
                     notes);
}

// The figures of a plot, for a reader who does not see the plot.
std::string figures_html(const InstrumentPlot& plot) {
  const bool has_intervals =
      std::ranges::any_of(plot.series, [](const InstrumentSeries& series) { return !series.intervals.empty(); });
  std::string html = fmt::format(
      "<details><summary>The figures</summary><table><thead><tr><th>series</th><th>{}</th>"
      "<th>{}</th>{}</tr></thead><tbody>",
      html_text(plot.x_label), html_text(plot.y_label), has_intervals ? "<th>from</th><th>to</th>" : "");
  for (const InstrumentSeries& series : plot.series) {
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      const std::string& label = i < series.labels.size() ? series.labels[i] : series.name;
      html += fmt::format("<tr><th>{}</th><td class=\"n\">{:.6g}</td><td class=\"n\">{:.6g}</td>", html_text(label),
                          series.points[i].first, series.points[i].second);
      if (i < series.intervals.size()) {
        html += fmt::format("<td class=\"n\">{:.6g}</td><td class=\"n\">{:.6g}</td>", series.intervals[i].first,
                            series.intervals[i].second);
      }
      html += "</tr>\n";
    }
  }
  return html + "</tbody></table></details>";
}

std::string plot_html(const InstrumentPlot& plot) {
  return fmt::format(
      "<section><h2>{0}</h2>\n<div class=\"plot\"><canvas role=\"img\" aria-label=\"{0}\"></canvas></div>\n{1}"
      "</section>\n",
      html_text(plot.caption), figures_html(plot));
}

Json plot_data(const InstrumentPlot& plot) {
  Json data = {{"kind", plot.kind == InstrumentPlot::Kind::line ? "line" : "scatter"},
               {"x", {{"label", plot.x_label}, {"log", plot.x_log}, {"names", plot.x_names}}},
               {"y", {{"label", plot.y_label}, {"log", plot.y_log}}},
               {"series", Json::array()}};
  for (const InstrumentSeries& series : plot.series) {
    data["series"].push_back(
        {{"name", series.name}, {"points", series.points}, {"labels", series.labels}, {"intervals", series.intervals}});
  }
  return data;
}

}  // namespace

std::string instrument_page(const InstrumentReport& given) {
  InstrumentReport report = given;
  // A page of figures begins with what was asked. The other notes say what words mean.
  const bool has_lead = !report.first && report.notes.size() > 1;
  const std::string lead = has_lead ? note_html(report.notes.front()) : "";
  report.are_notes_last |= has_lead;
  const std::string notes = notes_html(report);
  std::string body = report.are_notes_last ? lead : notes, folded;
  Json plots = Json::array();
  for (const InstrumentPlot& plot : report.plots) {
    body += plot_html(plot);
    plots.push_back(plot_data(plot));
  }
  Json scenes = Json::array(), of_folded = Json::array();  // in the order of the page
  if (report.first && report.first->worst) scenes.push_back(report.first->worst->query);
  for (const InstrumentTable& table : report.tables) {
    (table.is_folded ? folded : body) += table_html(table);
    for (const InstrumentScene& scene : table.scenes) (table.is_folded ? of_folded : scenes).push_back(scene.query);
  }
  scenes.insert(scenes.end(), of_folded.begin(), of_folded.end());
  if (report.are_notes_last) folded += notes;
  const std::pair<std::string_view, std::string> places[] = {
      {"<!--TITLE-->", html_text(report.title)},
      {"/*CSS*/", std::string(embedded::report_css)},
      {"<!--HEADING-->", html_text(report.title)},
      {"<!--COMMAND-->", html_text(report.command)},
      {"<!--BODY-->", (report.first ? first_html(*report.first) : "") + body + folded},
      {"/*DATA*/", inert_json(plots)},
      {"/*SCENES*/", inert_json(scenes)},
      {"/*JS*/", fmt::format("{}\n{}\n{}\n{}\n{}", embedded::chart_min_js, embedded::chart_js, embedded::table_js,
                             scene_scripts(), embedded::instrument_js)}};
  return filled(embedded::instrument_html, places);
}

}  // namespace axiscert
