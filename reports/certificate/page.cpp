#include "reports/certificate/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "fuzz/search/method.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "reports/certificate/margin.h"
#include "reports/gates/level.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/everyday.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string cell(const std::optional<TextNumber>& figure) { return figure ? *figure : "-"; }
std::string cell(const std::optional<std::uint64_t>& count) { return count ? thousands(*count) : "-"; }
std::string cell(Precision precision) { return std::string(name(precision)); }

class CertificatePage {
 public:
  CertificatePage(const CertificateStatement& statement, const Record* record)
      : statement_(statement), predicate_(statement.predicate), record_(record) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report;
    report.name = "certificate";
    const std::string no_answers = no_answers_sentence(predicate_);
    report.title = fmt::format("Certificate of {}, {}{}{}", predicate_.kernel.id, predicate_.kernel.question,
                               no_answers.empty() ? "" : ": ", no_answers);
    report.command = command;
    report.first = first();
    report.notes_heading = "In short";
    report.notes = {sentence(made_sentence(predicate_) + "; " + signer_sentence(predicate_)),
                    sentence("asked: " + asked_sentence(predicate_)), sentence(looked_sentence(predicate_)),
                    levels_note()};
    for (const auto& [precision, told] : told_of_precisions())
      for (std::size_t i = 1; i < told.size(); ++i)
        report.notes.push_back(fmt::format("{}: {}.", name(precision), told[i]));
    if (std::string note = peculiarities_note(predicate_); !note.empty()) report.notes.push_back(std::move(note));
    for (const MarginStatement& margin : predicate_.safe_margin.precisions)
      for (std::string& note : margin_notes(margin)) report.notes.push_back(std::move(note));
    if (predicate_.safe_margin.precisions.empty())
      report.notes.push_back(fmt::format("Safe margin: NOT CHECKED: {}.", predicate_.safe_margin.reason.value_or("")));
    report.add(situations_table(predicate_));
    report.tables.push_back(levels_table());
    report.add(unchecked_table());
    report.add(margin_table(predicate_.safe_margin));
    report.add(witnesses_table());
    report.tables.push_back(limits_table());
    report.tables.push_back(comparison_table());
    report.add(diagnosis_table());
    report.add(search_table());
    report.add(harness_table());
    report.tables.push_back(materials_table());
    report.data = json_of(statement_);
    return report;
  }

 private:
  static std::string sentence(std::string text) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
  }

  std::string levels_note() const {
    const auto list = [&](LevelState state) {
      const std::vector<std::string> levels = levels_with(predicate_, state);
      return levels.empty() ? "nothing" : fmt::format("{}", fmt::join(levels, ", "));
    };
    return fmt::format("Met{}: {}. Not met: {}. NOT CHECKED: {}.", decided_text(predicate_), list(LevelState::met),
                       list(LevelState::not_met), list(LevelState::not_checked));
  }

  InstrumentFirst first() const {
    InstrumentFirst first{states_table(), {}, {}};
    if (!predicate_.witnesses.empty()) {
      first.worst = scene_of(predicate_.witnesses.front());
      first.worst->title = "The worst: " + first.worst->title;
    }
    first.sentences.push_back(breaks_note(predicate_));
    for (const auto& [precision, told] : told_of_precisions())
      if (!told.empty()) first.sentences.push_back(fmt::format("{}: {}.", name(precision), told.front()));
    return first;
  }

  // What is said first of a run's kernel, by precision: everyday scenes, and then all others.
  std::vector<std::pair<Precision, std::vector<std::string>>> told_of_precisions() const {
    std::vector<std::pair<Precision, std::vector<std::string>>> told;
    if (record_ == nullptr) return told;
    for (const KernelRecord* kernel : precision_entries(*record_, predicate_.kernel.id))
      told.emplace_back(kernel->precision, first_sentences(*kernel, record_->plan));
    return told;
  }

  // "9 of 12", where the head of its column says of what.
  static std::string figures_of(std::string looked_at) {
    constexpr std::string_view of = " promised queries looked at";
    if (const std::size_t at = looked_at.find(of); at != looked_at.npos) looked_at.erase(at, of.size());
    return looked_at;
  }

  // What came of every level, and of how many queries. Those that were not checked are one row: another table says why.
  InstrumentTable states_table() const {
    InstrumentTable table{"The answer", {"level"}, {}};
    for (const Precision precision : predicate_.kernel.precisions)
      table.columns.insert(table.columns.end(), {cell(precision), "promised queries looked at"});
    std::vector<std::string> unchecked;
    for (const LevelState state : {LevelState::not_met, LevelState::met, LevelState::not_checked}) {
      for (const LevelStatement* level : first_of_levels(predicate_)) {
        if (state_of_level(predicate_, level->level) != state) continue;
        if (is_unchecked(level->level)) {
          unchecked.push_back(level->level);
          continue;
        }
        std::vector<std::string> row = {level->level};
        for (const Precision precision : predicate_.kernel.precisions) {
          const LevelStatement* entry = find(level->level, precision);
          row.emplace_back(entry ? name(entry->state) : "-");
          row.push_back(entry == nullptr            ? "-"
                        : !entry->looked_at.empty() ? figures_of(entry->looked_at)
                                                    : std::string(entry->reason.value_or("-")));
        }
        table.rows.push_back(std::move(row));
      }
    }
    if (unchecked.empty()) return table;
    std::vector<std::string> row = {unchecked.size() == 1 ? unchecked.front()
                                                          : fmt::format("{} more levels", unchecked.size())};
    for (std::size_t i = 0; i < predicate_.kernel.precisions.size(); ++i) {
      row.emplace_back(name(LevelState::not_checked));
      row.push_back(i == 0 ? fmt::format("{}; why is below", fmt::join(unchecked, ", ")) : "");
    }
    table.rows.push_back(std::move(row));
    return table;
  }

  // One row a level, a column a precision.
  InstrumentTable levels_table() const {
    InstrumentTable table{"Levels", {"level"}, {}};
    table.is_folded = true;
    for (const Precision precision : predicate_.kernel.precisions) table.columns.push_back(cell(precision));
    table.columns.insert(table.columns.end(), {"what it says", "what that rests on, or why not"});
    for (const LevelStatement* level : first_of_levels(predicate_)) {
      if (is_unchecked(level->level)) continue;
      std::vector<std::string> row = {level->level};
      std::string why;
      for (const Precision precision : predicate_.kernel.precisions) {
        const LevelStatement* entry = find(level->level, precision);
        row.emplace_back(entry ? name(entry->state) : "-");
        if (entry != nullptr && why.empty()) why = why_of(*entry);
        else if (entry != nullptr && entry->state != level->state)
          why += fmt::format(". In {}: {}", name(precision), why_of(*entry));
      }
      row.push_back(level->statement);
      row.push_back(why.empty() ? why_of(*level) : why);
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  const LevelStatement* find(const std::string& name, Precision precision) const {
    for (const LevelStatement& level : predicate_.levels) {
      if (level.level == name && level.precision == precision) return &level;
    }
    return nullptr;
  }

  // In every precision.
  bool is_unchecked(const std::string& name) const {
    return std::ranges::all_of(predicate_.levels, [&](const LevelStatement& level) {
      return level.level != name || level.state == LevelState::not_checked;
    });
  }

  static std::string why_of(const LevelStatement& level) {
    std::vector<std::string> parts;
    if (!level.looked_at.empty()) parts.push_back(level.looked_at);
    if (level.reason) parts.push_back("NOT CHECKED: " + *level.reason);
    for (const GroundStatement& rest : level.rests_on)
      parts.push_back(fmt::format("{}: {}", name(rest.kind), rest.text));
    for (const SaidText& failure : level.failures) parts.push_back(failure);
    const auto shown = level.failures.size();
    if (level.failure_count > shown) parts.push_back(fmt::format("and {} more", level.failure_count - shown));
    return fmt::format("{}", fmt::join(parts, ". "));
  }

  InstrumentTable unchecked_table() const {
    InstrumentTable table{"Levels that were NOT CHECKED", {"level", "why"}, {}};
    table.is_folded = true;
    for (const LevelStatement* level : first_of_levels(predicate_)) {
      if (is_unchecked(level->level)) table.rows.push_back({level->level, level->reason.value_or("-")});
    }
    return table;
  }

  InstrumentTable witnesses_table() const {
    InstrumentTable table{"Witnesses", {"what", "address"}, {}};
    for (const CertificateWitness& witness : predicate_.witnesses) {
      table.rows.push_back({witness.title, witness.address});
      table.scenes.push_back(scene_of(witness));
    }
    return table;
  }

  static InstrumentScene scene_of(const CertificateWitness& witness) {
    InstrumentScene scene;
    scene.title = witness.title;
    scene.sentence = witness.sentence;
    scene.command = witness.command;
    scene.query = witness.query.json;
    return scene;
  }

  InstrumentTable limits_table() const {
    InstrumentTable table{"What this does not say", {"limit"}, {}};
    for (const SaidText& limit : predicate_.limits) table.rows.push_back({limit});
    return table;
  }

  InstrumentTable comparison_table() const {
    const bool has_others =
        std::ranges::any_of(predicate_.comparison, [&](const auto& row) { return row.kernel != predicate_.kernel.id; });
    InstrumentTable table{
        has_others ? "Beside other kernels, on the same queries" : "Wrong verdicts on all queries",
        {"kernel", "precision", "looked at", "missed", "deepest", "phantom", "deepest ", "declined or undecided",
         "invalid", "no answer", "critical radius, median ulps", "greatest ulps"},
        {}};
    for (const ComparisonStatement& row : predicate_.comparison) {
      table.rows.push_back({row.kernel, cell(row.precision), thousands(row.looked_at), cell(row.missed),
                            cell(row.deepest_missed), cell(row.phantom), cell(row.deepest_phantom),
                            thousands(row.undecided), thousands(row.invalid), thousands(row.unanswered),
                            cell(row.median_ulps), cell(row.largest_ulps)});
    }
    return table;
  }

  InstrumentTable diagnosis_table() const {
    InstrumentTable table{"Diagnosis", {"property", "precision", "is", "because"}, {}};
    for (const DiagnosedStatement& part : predicate_.diagnosis.precisions) {
      for (const PropertyStatement& property : part.properties)
        table.rows.push_back({property.name, cell(part.precision), property.value, property.sentence});
    }
    return table;
  }

  InstrumentTable search_table() const {
    InstrumentTable table{"The worst that a search found", {"precision", "what", "worst", "unit", "evaluations"}, {}};
    for (const auto& [precision, search] : predicate_.search.precisions) {
      for (const auto& [goal, find] : search.finds) {
        const std::uint64_t looked_at = search.looked_at_for(goal);
        const bool is_of_a_number = goal.starts_with(goal_names[Goal::number]);
        table.rows.push_back({precision, goal,
                              find             ? cell(find->depth ? find->depth : find->ulps)
                              : looked_at == 0 ? "not looked at"
                                               : fmt::format("none among {} {}", thousands(looked_at),
                                                             is_of_a_number ? "judged" : "decided"),
                              is_of_a_number                              ? "-"
                              : goal == goal_names[Goal::critical_radius] ? "ulps"
                                                                          : "of the scene",
                              thousands(search.evaluations)});
      }
    }
    return table;
  }

  InstrumentTable harness_table() const {
    InstrumentTable table{
        "Faults planted in a right kernel that shows as much as this one, and those that a run notices",
        {"precision", "planted", "noticed", "not noticed", "without effect"},
        {}};
    for (const auto& [precision, score] : predicate_.harness.score) {
      const auto told = [&](std::uint64_t n) { return score.judged == 0 ? "-" : thousands(n); };
      table.rows.push_back({precision, thousands(score.mutants), told(score.noticed), told(score.survived),
                            thousands(score.equivalent)});
    }
    return table;
  }

  InstrumentTable materials_table() const {
    InstrumentTable table{"Made from", {"what", "name", "SHA-256"}, {}};
    table.is_folded = true;
    for (const SubjectStatement& subject : statement_.subject)
      table.rows.push_back({"subject: " + subject.annotations.what, subject.name, subject.digest.sha256});
    const MaterialsStatement& materials = predicate_.materials;
    table.rows.push_back({"axiscert", materials.axiscert.version, materials.axiscert.sources});
    table.rows.push_back({"proofs", "proofs/", materials.proofs});
    table.rows.push_back(
        {"plan", fmt::format("{} stretches", thousands(predicate_.asked.stretches)), materials.plan.digest});
    if (predicate_.signed_by) table.rows.push_back({"signer", "the key", *predicate_.signed_by});
    const std::string signed_at = predicate_.signed_at.value_or("not signed");
    table.rows.push_back({"this certificate", signed_at, predicate_.digest});
    return table;
  }

  const CertificateStatement& statement_;
  const CertificatePredicate& predicate_;
  const Record* const record_;
};

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') safe += "&amp;";
    else if (c == '<') safe += "&lt;";
    else if (c == '>') safe += "&gt;";
    else if (c == '"') safe += "&quot;";
    else safe += c;
  }
  return safe;
}

}  // namespace

InstrumentReport certificate_report(const CertificateStatement& statement, const std::string& command,
                                    const Record* record) {
  return CertificatePage(statement, record).report(command);
}

std::string certificate_badge(const CertificateStatement& statement) {
  const CertificatePredicate& predicate = statement.predicate;
  std::string text = "no level met", colour = "#c0392b";
  for (const GateLevel* best : badge_levels()) {
    const std::string level(best->name());
    if (state_of_level(predicate, level) != LevelState::met) continue;
    const std::string claim = claim_of_level(predicate, level) + decided_text(predicate);
    text = claim == level ? fmt::format("{} met", level) : claim;
    colour = best->badge->colour;
    break;
  }
  const std::string no_answers = no_answers_sentence(predicate);
  if (!no_answers.empty()) text = no_answers;
  text += fmt::format("; {}, {} queries", predicate.asked.effort, thousands(predicate.asked.queries));
  const std::string all =
      fmt::format("{}; {}; {}; asked: {}; {}", text, made_sentence(predicate), signer_sentence(predicate),
                  asked_sentence(predicate), looked_sentence(predicate));
  const std::string label = "axiscert";
  // Seven units a letter are enough for every letter of the sans-serif at this size.
  const std::size_t left = 7 * label.size() + 12, right = 7 * text.size() + 12;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"20\" role=\"img\" aria-label=\"{1}: {8}\">"
      "<title>{1}: {8}</title><rect width=\"{3}\" height=\"20\" fill=\"#444\"/>"
      "<rect x=\"{3}\" width=\"{4}\" height=\"20\" fill=\"{5}\"/>"
      "<g fill=\"#fff\" font-family=\"Verdana,DejaVu Sans,sans-serif\" font-size=\"11\" text-anchor=\"middle\">"
      "<text x=\"{6}\" y=\"14\">{1}</text><text x=\"{7}\" y=\"14\">{2}</text></g></svg>\n",
      left + right, label, text, left, right, colour, left / 2, left + right / 2, escaped(all));
}

// A certificate's report on a terminal: tables of short cells aligned, sentences wrapped below their row.

namespace {

constexpr std::size_t columns_of_text = 110, longest_cell = 44;

std::string wrapped(const std::string& sentence, std::size_t indent) {
  std::string text, line;
  const auto end_line = [&] {
    text += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  std::size_t at = 0;
  const std::string words = printable_line(sentence);
  while (at < words.size()) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string_view word = std::string_view(words).substr(at, end - at);
    if (!line.empty() && indent + line.size() + 1 + word.size() > columns_of_text) end_line();
    if (!line.empty()) line += ' ';
    line += word;
    at = end + 1;
  }
  if (!line.empty()) end_line();
  return text;
}

std::string table_words(const InstrumentTable& table) {
  std::string text = table.caption + "\n";
  const auto is_long = [&](std::size_t column) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const auto& row) { return row[column].size() > longest_cell; });
  };
  std::vector<bool> long_columns;
  for (std::size_t k = 0; k < table.columns.size(); ++k) long_columns.push_back(is_long(k));
  const auto short_cells = [&](const std::vector<std::string>& row) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!long_columns[k]) cells.push_back(row[k]);
    return cells;
  };
  if (std::none_of(long_columns.begin(), long_columns.end(), [](bool is) { return is; }))
    return text + aligned_table(table.columns, table.rows);
  // The short cells of all rows are aligned with each other; each row's sentences follow its line.
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : table.rows) rows.push_back(short_cells(row));
  const std::vector<std::string> columns = short_cells(table.columns);
  const std::string aligned = columns.empty() ? "" : aligned_table(columns, rows);
  std::size_t at = columns.empty() ? 0 : aligned.find('\n') + 1;
  if (at != 0) text += aligned.substr(0, at);
  for (const auto& row : table.rows) {
    if (!columns.empty()) {
      const std::size_t end = aligned.find('\n', at) + 1;
      text += aligned.substr(at, end - at);
      at = end;
    }
    for (std::size_t k = 0; k < row.size(); ++k)
      if (long_columns[k]) text += wrapped(row[k], columns.empty() ? 2 : 6);
  }
  return text;
}

}  // namespace

std::string certificate_words(const InstrumentReport& report) {
  std::string text = wrapped(report.title, 0);
  // By whom, how much was asked and looked at, the levels; then what the page begins with, and the rest.
  constexpr std::size_t notes_before = 4;
  for (std::size_t i = 0; i < report.notes.size(); ++i) {
    if (i == notes_before && report.first)
      for (const std::string& sentence : report.first->sentences) text += wrapped(sentence, 0);
    text += wrapped(report.notes[i], 0);
  }
  for (const InstrumentTable& table : report.tables) {
    text += "\n" + table_words(table);
    for (const InstrumentScene& scene : table.scenes)
      text += fmt::format("{}{}", wrapped(scene.sentence, 2), "      " + printable_line(scene.command) + "\n");
  }
  return text;
}

}  // namespace axiscert
