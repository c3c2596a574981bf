#include "reports/certificate/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "reports/certificate/findings/asked_words.h"
#include "reports/certificate/findings/breaks_words.h"
#include "reports/certificate/findings/margin_words.h"
#include "reports/gates/levels/level.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string cell_count(const Json& count) { return thousands(count.get<std::uint64_t>()); }

class CertificatePage {
 public:
  explicit CertificatePage(const Json& statement) : statement_(statement), predicate_(statement["predicate"]) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report;
    report.name = "certificate";
    const std::string no_answers = no_answers_sentence(predicate_);
    report.title = fmt::format("Certificate of {}, {}{}{}", kernel("id"), kernel("test"),
                               no_answers.empty() ? "" : ": ", no_answers);
    report.command = command;
    report.notes_heading = "In short";
    report.notes = {sentence(made_sentence(predicate_) + "; " + signer_sentence(predicate_)),
                    sentence("asked: " + asked_sentence(predicate_)), sentence(looked_sentence(predicate_)),
                    levels_note()};
    report.notes.push_back(breaks_note(predicate_));
    if (std::string note = peculiarities_note(predicate_); !note.empty()) report.notes.push_back(std::move(note));
    for (const Json& margin : predicate_["safe_margin"]["precisions"])
      for (std::string& note : margin_notes(margin)) report.notes.push_back(std::move(note));
    if (predicate_["safe_margin"]["precisions"].empty())
      report.notes.push_back(
          fmt::format("Safe margin: NOT CHECKED: {}.", predicate_["safe_margin"]["reason"].get<std::string>()));
    if (InstrumentTable table = situations_table(predicate_); !table.rows.empty())
      report.tables.push_back(std::move(table));
    report.tables.push_back(levels_table());
    if (InstrumentTable table = unchecked_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    if (InstrumentTable table = margin_table(predicate_["safe_margin"]); !table.rows.empty())
      report.tables.push_back(std::move(table));
    if (InstrumentTable table = witnesses_table(); !table.rows.empty()) report.tables.push_back(std::move(table));
    report.tables.push_back(limits_table());
    report.tables.push_back(comparison_table());
    for (InstrumentTable table : {diagnosis_table(), search_table(), harness_table()})
      if (!table.rows.empty()) report.tables.push_back(std::move(table));
    report.tables.push_back(materials_table());
    report.data = statement_;
    return report;
  }

 private:
  std::string kernel(const char* member) const { return predicate_["kernel"][member].get<std::string>(); }

  static std::string sentence(std::string text) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
  }

  std::string levels_note() const {
    const auto list = [&](const char* state) {
      const std::vector<std::string> levels = levels_with(predicate_, state);
      return levels.empty() ? "nothing" : fmt::format("{}", fmt::join(levels, ", "));
    };
    return fmt::format("Met{}: {}. Not met: {}. NOT CHECKED: {}.", decided_text(predicate_), list("met"),
                       list("not met"), list("NOT CHECKED"));
  }

  // One row a level, a column a precision.
  InstrumentTable levels_table() const {
    InstrumentTable table{"Levels", {"level"}, {}};
    std::vector<std::string> precisions;
    for (const Json& precision : predicate_["kernel"]["precisions"]) precisions.push_back(precision);
    for (const std::string& precision : precisions) table.columns.push_back(precision);
    table.columns.insert(table.columns.end(), {"what it says", "what that rests on, or why not"});
    std::vector<std::string> done;
    for (const Json& level : predicate_["levels"]) {
      const std::string name = level["level"];
      if (std::find(done.begin(), done.end(), name) != done.end() || is_unchecked(name)) continue;
      done.push_back(name);
      std::vector<std::string> row = {name};
      std::string why;
      for (const std::string& precision : precisions) {
        const Json* entry = find(name, precision);
        row.push_back(entry ? plain_text((*entry)["state"]) : "-");
        if (entry != nullptr && why.empty()) why = why_of(*entry);
        else if (entry != nullptr && (*entry)["state"] != level["state"])
          why += fmt::format(". In {}: {}", precision, why_of(*entry));
      }
      row.push_back(level["statement"]);
      row.push_back(why.empty() ? why_of(level) : why);
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  const Json* find(const std::string& name, const std::string& precision) const {
    for (const Json& level : predicate_["levels"]) {
      if (level["level"] == name && level["precision"] == precision) return &level;
    }
    return nullptr;
  }

  // In every precision.
  bool is_unchecked(const std::string& name) const {
    return std::all_of(predicate_["levels"].begin(), predicate_["levels"].end(),
                       [&](const Json& level) { return level["level"] != name || level["state"] == "NOT CHECKED"; });
  }

  static std::string why_of(const Json& level) {
    std::vector<std::string> parts;
    if (level["looked_at"] != "") parts.push_back(level["looked_at"]);
    if (!level["reason"].is_null()) parts.push_back("NOT CHECKED: " + level["reason"].get<std::string>());
    for (const Json& rest : level["rests_on"])
      parts.push_back(fmt::format("{}: {}", plain_text(rest["kind"]), plain_text(rest["text"])));
    for (const Json& failure : level["failures"]) parts.push_back(failure);
    const auto shown = level["failures"].size();
    const auto count = level["failure_count"].get<std::uint64_t>();
    if (count > shown) parts.push_back(fmt::format("and {} more", count - shown));
    return fmt::format("{}", fmt::join(parts, ". "));
  }

  InstrumentTable unchecked_table() const {
    InstrumentTable table{"Levels that were NOT CHECKED", {"level", "why"}, {}};
    for (const Json& level : predicate_["levels"]) {
      const auto is_there = [&](const auto& row) { return Json(row[0]) == level["level"]; };
      if (!is_unchecked(level["level"]) || std::ranges::any_of(table.rows, is_there)) continue;
      table.rows.push_back({plain_text(level["level"]), plain_text(level["reason"])});
    }
    return table;
  }

  InstrumentTable witnesses_table() const {
    InstrumentTable table{"Witnesses", {"what", "address"}, {}};
    for (const Json& witness : predicate_["witnesses"]) {
      table.rows.push_back({plain_text(witness["title"]), plain_text(witness["address"])});
      InstrumentScene scene;
      scene.title = witness["title"];
      scene.sentence = witness["sentence"];
      scene.command = witness["command"];
      scene.query = witness["query"];
      table.scenes.push_back(std::move(scene));
    }
    return table;
  }

  InstrumentTable limits_table() const {
    InstrumentTable table{"What this does not say", {"limit"}, {}};
    for (const Json& limit : predicate_["limits"]) table.rows.push_back({limit.get<std::string>()});
    return table;
  }

  InstrumentTable comparison_table() const {
    const bool has_others = std::any_of(predicate_["comparison"].begin(), predicate_["comparison"].end(),
                                        [&](const Json& row) { return row["kernel"] != predicate_["kernel"]["id"]; });
    InstrumentTable table{
        has_others ? "Beside other kernels, on the same queries" : "Wrong verdicts on all queries",
        {"kernel", "precision", "looked at", "missed", "deepest", "phantom", "deepest ", "declined or undecided",
         "invalid", "no answer", "critical radius, median ulps", "greatest ulps"},
        {}};
    for (const Json& row : predicate_["comparison"]) {
      table.rows.push_back({plain_text(row["kernel"]), plain_text(row["precision"]), cell_count(row["looked_at"]),
                            cell_count(row["missed"]), plain_text(row["deepest_missed"]), cell_count(row["phantom"]),
                            plain_text(row["deepest_phantom"]), cell_count(row["undecided"]),
                            cell_count(row["invalid"]), cell_count(row["unanswered"]), plain_text(row["median_ulps"]),
                            plain_text(row["largest_ulps"])});
    }
    return table;
  }

  InstrumentTable diagnosis_table() const {
    InstrumentTable table{"Diagnosis", {"property", "precision", "is", "because"}, {}};
    for (const Json& part : predicate_["diagnosis"]["precisions"]) {
      for (const Json& property : part["properties"]) {
        table.rows.push_back({plain_text(property["name"]), plain_text(part["precision"]),
                              plain_text(property["value"]), plain_text(property["sentence"])});
      }
    }
    return table;
  }

  InstrumentTable search_table() const {
    InstrumentTable table{"The worst that a search found", {"precision", "what", "worst", "unit", "evaluations"}, {}};
    for (const auto& [precision, search] : predicate_["search"]["precisions"].items()) {
      for (const auto& [goal, find] : search["finds"].items()) {
        const bool is_depth = find.is_object() && find.contains("depth");
        table.rows.push_back({precision, goal, find.is_null() ? "none" : plain_text(find[is_depth ? "depth" : "ulps"]),
                              goal == "critical_radius" ? "ulps" : "of the scene", cell_count(search["evaluations"])});
      }
    }
    return table;
  }

  InstrumentTable harness_table() const {
    const Json& harness = predicate_["harness"];
    InstrumentTable table{
        "Faults planted in a right kernel that shows as much as this one, and those that a run notices",
        {"precision", "planted", "noticed", "not noticed", "without effect"},
        {}};
    for (const auto& [precision, score] : harness["score"].items()) {
      table.rows.push_back({precision, cell_count(score["mutants"]), cell_count(score["noticed"]),
                            cell_count(score["survived"]), cell_count(score["equivalent"])});
    }
    return table;
  }

  InstrumentTable materials_table() const {
    InstrumentTable table{"Made from", {"what", "name", "SHA-256"}, {}};
    for (const Json& subject : statement_["subject"]) {
      table.rows.push_back({"subject: " + plain_text(subject["annotations"]["what"]), plain_text(subject["name"]),
                            plain_text(subject["digest"]["sha256"])});
    }
    const Json& materials = predicate_["materials"];
    table.rows.push_back(
        {"axiscert", plain_text(materials["axiscert"]["version"]), plain_text(materials["axiscert"]["sources"])});
    table.rows.push_back({"proofs", "proofs/", plain_text(materials["proofs"])});
    table.rows.push_back({"plan", fmt::format("{} stretches", cell_count(predicate_["asked"]["stretches"])),
                          plain_text(materials["plan"]["digest"])});
    if (!predicate_["signed_by"].is_null())
      table.rows.push_back({"signer", "the key", plain_text(predicate_["signed_by"])});
    table.rows.push_back({"this certificate",
                          plain_text(predicate_["signed_at"].is_null() ? Json("not signed") : predicate_["signed_at"]),
                          plain_text(predicate_["digest"])});
    return table;
  }

  const Json& statement_;
  const Json& predicate_;
};

}  // namespace

namespace {

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

InstrumentReport certificate_report(const Json& statement, const std::string& command) {
  return CertificatePage(statement).report(command);
}

std::string certificate_badge(const Json& statement) {
  const Json& predicate = statement["predicate"];
  std::string text = "no level met", colour = "#c0392b";
  for (const GateLevel* best : badge_levels()) {
    const std::string level(best->name());
    if (state_of_level(predicate, level) != "met") continue;
    const std::string claim = claim_of_level(predicate, level) + decided_text(predicate);
    text = claim == level ? fmt::format("{} met", level) : claim;
    colour = best->badge->colour;
    break;
  }
  const std::string no_answers = no_answers_sentence(predicate);
  if (!no_answers.empty()) text = no_answers;
  text += fmt::format("; {}, {} queries", plain_text(predicate["asked"]["effort"]),
                      cell_count(predicate["asked"]["queries"]));
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

}  // namespace axiscert
