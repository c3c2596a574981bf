#include "reports/gates/ratchet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "kernel/base/error.h"
#include "kernel/base/utf8.h"
#include "reports/comparison/cells.h"
#include "reports/run_folder/plan_queries.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::string_view schema = "axiscert-ratchet/1";
constexpr std::string_view form = "FINGERPRINT KERNEL PRECISION FAMILY CELL FIGURE EXPIRY OWNER REASON";

bool is_held(const Cell& cell) { return !cell.is_zero() && cell.member != "max_error_u"; }

std::string word(const std::string& text) {
  const bool is_plain = !text.empty() && text[0] != '#' && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c > 0x20 && c < 0x7f && c != '"';
  });
  return is_plain ? text : Json(text).dump();
}

std::string line_of(const Json& key, const Json& figure, const std::string& expiry, const std::string& owner,
                    const std::string& reason) {
  std::string line = fingerprint(key);
  for (const Json& part : key) line += " " + word(part);
  return fmt::format("{} {} {} {} {}", line, figure.dump(), expiry, word(owner), word(reason));
}
std::string open_line(const Cell& cell) { return line_of(cell.key(), cell.figure, "EXPIRY", "OWNER", "REASON"); }

std::string name_of(const Json& key) {
  const auto part = [&](std::size_t i) { return key[i].get<std::string>(); };
  return fmt::format("{} {} on {}: {}", part(0), part(1), part(2), part(3));
}

// Files of the first test are those of versions that had no other.
std::string head(const std::string& plan, const std::string& test) {
  return fmt::format("{} {}{}\n# {}\n", schema, plan, test == first_test().id ? "" : " " + word(test), form);
}

struct Line {
  const std::string& file;
  std::size_t number;

  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", file, number, what)); }
};

std::vector<std::string> words_of(std::string_view text, const Line& line) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r", at)) != text.npos) {
    if (text[at] != '"') {
      const std::size_t end = std::min(text.find_first_of(" \t\r", at), text.size());
      words.emplace_back(text.substr(at, end - at));
      at = end;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
    const Json value = end < text.size() ? Json::parse(text.substr(at, end + 1 - at), nullptr, false) : Json();
    if (!value.is_string())
      line.fail("a quotation mark does not open a JSON string: \"...\", with \\\" and \\\\ inside");
    words.push_back(value);
    at = end + 1;
  }
  return words;
}

bool is_date(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  int year = 0;
  unsigned month = 0, day = 0;
  const auto read = [&](std::size_t first, std::size_t last, auto& into) {
    return std::from_chars(text.data() + first, text.data() + last, into).ptr == text.data() + last;
  };
  if (text.find_first_not_of("0123456789-") != text.npos) return false;
  return read(0, 4, year) && read(5, 7, month) && read(8, 10, day) &&
         std::chrono::year_month_day(std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)).ok();
}

RatchetEntry entry_of(const std::vector<std::string>& words, const Line& line) {
  if (words.size() != 9) {
    line.fail(fmt::format("{} words, but a line has nine: {}; put words with spaces in \"...\"", words.size(), form));
  }
  RatchetEntry entry{Json::array({words[1], words[2], words[3], words[4]}),
                     Json::parse(words[5], nullptr, false),
                     words[6],
                     words[7],
                     words[8],
                     line.number};
  const std::string own = fingerprint(entry.key);
  if (own != words[0]) {
    line.fail(fmt::format("fingerprint {} is not that of {}, which is {}; take whole lines from ratchet.txt", words[0],
                          name_of(entry.key), own));
  }
  if (!entry.figure.is_number() || entry.figure < 0) {
    line.fail(fmt::format("FIGURE '{}' is not a number >= 0", words[5]));
  }
  if (entry.expiry != "never" && !is_date(entry.expiry)) {
    line.fail(fmt::format("EXPIRY '{}' is neither a day, YYYY-MM-DD, nor never", entry.expiry));
  }
  if (entry.owner.empty() || entry.owner == "OWNER")
    line.fail("OWNER is not filled in: name who is responsible for this");
  if (entry.reason.empty() || entry.reason == "REASON") line.fail("REASON is not filled in: say why this is accepted");
  return entry;
}

}  // namespace

Ratchet parse_ratchet(std::string_view text, const std::string& name) {
  Ratchet ratchet;
  ratchet.name = name;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view content = text.substr(at, end - at);
    const Line line{name, ++number};
    at = end + 1;
    if (!is_utf8(content)) line.fail("not UTF-8");
    const std::vector<std::string> words =
        content.starts_with('#') ? std::vector<std::string>() : words_of(content, line);
    if (words.empty()) continue;
    if (ratchet.plan.empty()) {
      if (words[0] != schema || words.size() < 2 || words.size() > 3) {
        line.fail(
            fmt::format("begins with '{}', but a ratchet begins with '{} PLAN [TEST]'; a run writes one as ratchet.txt",
                        words[0].substr(0, 80), schema));
      }
      ratchet.plan = words[1];
      if (words.size() == 3) ratchet.test = words[2];
      continue;
    }
    RatchetEntry entry = entry_of(words, line);
    const auto [at_entry, is_new] = ratchet.entries.emplace(words[0], std::move(entry));
    if (!is_new) line.fail(fmt::format("{} appears twice, first in line {}", words[0], at_entry->second.line));
  }
  if (ratchet.plan.empty()) throw Error(fmt::format("{}: empty; a run writes a ratchet as ratchet.txt", name));
  return ratchet;
}

Ratchet read_ratchet(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!in.is_open() || in.bad()) {
    throw Error(fmt::format("{}: cannot be read: {}; a run without --ratchet writes a first one as ratchet.txt", path,
                            std::strerror(errno)));
  }
  return parse_ratchet(text.view(), as_utf8(path));
}

void require_plan(const Ratchet& ratchet, const Json& plan) {
  if (const std::string_view test = test_of(plan).id; test != ratchet.test) {
    throw Error(fmt::format("{}: of the test {}, and this run is of {}; figures of two tests are not comparable",
                            ratchet.name, ratchet.test, test));
  }
  const std::string given = plan_fingerprint(plan);
  if (given == ratchet.plan) return;
  throw Error(fmt::format(
      "{}: belongs to plan {}, this run to {}: different families, trials, seed, files, precisions or tolerances, "
      "so the figures are not comparable; run without --ratchet and review the new ratchet.txt",
      ratchet.name, ratchet.plan, given.empty() ? "one that cannot be repeated" : given));
}

RatchetOutcome hold_against(const Ratchet& ratchet, const Json& record, const std::string& today) {
  require_plan(ratchet, record["plan"]);
  RatchetOutcome outcome;
  outcome.accepted = head(ratchet.plan, ratchet.test);
  const auto fail = [&](const Json& key, std::string text) { outcome.failures.push_back({key, std::move(text)}); };
  std::set<Json> judged;  // kernel and precision
  for (const Json& kernel : record["kernels"]) judged.insert(Json::array({kernel["id"], kernel["precision"]}));
  std::set<std::string> met;
  const auto check_expiry = [&](const RatchetEntry& entry) {
    if (entry.expiry == "never" || entry.expiry >= today) return;
    fail(entry.key, fmt::format("{}:{}: expired on {} ({}, {}): {}", ratchet.name, entry.line, entry.expiry,
                                entry.owner, entry.reason, name_of(entry.key)));
  };
  for (const Cell& cell : cells_of(record)) {
    if (!is_held(cell)) continue;
    const std::string id = fingerprint(cell.key());
    const auto found = ratchet.entries.find(id);
    if (found == ratchet.entries.end()) {
      fail(cell.key(), fmt::format("{}: {}, accepted is 0; to accept it: {}", name_of(cell.key()), cell.figure.dump(),
                                   open_line(cell)));
      outcome.accepted += open_line(cell) + "\n";
      continue;
    }
    const RatchetEntry& entry = found->second;
    met.insert(id);
    check_expiry(entry);
    const bool is_worse = is_less(entry.figure, cell.figure);
    const std::string line =
        is_worse ? open_line(cell) : line_of(cell.key(), cell.figure, entry.expiry, entry.owner, entry.reason);
    if (is_worse) {
      fail(cell.key(), fmt::format("{}: {}, accepted is {} ({}:{}); to accept it: {}", name_of(cell.key()),
                                   cell.figure.dump(), entry.figure.dump(), ratchet.name, entry.line, line));
    } else if (is_less(cell.figure, entry.figure)) {
      outcome.better.push_back(fmt::format("{}: {}, accepted is {} ({}:{}); the line now: {}", name_of(cell.key()),
                                           cell.figure.dump(), entry.figure.dump(), ratchet.name, entry.line, line));
    }
    outcome.accepted += line + "\n";
  }
  for (const auto& [id, entry] : ratchet.entries) {
    if (met.count(id) != 0) continue;
    check_expiry(entry);
    // A finding made in loading has no precision: nothing was judged because of it, or it is gone.
    const bool of_loading = entry.key[1] == "";
    const auto& kernels = record["plan"]["kernels"];
    if (of_loading ? std::find(kernels.begin(), kernels.end(), entry.key[0]) == kernels.end()
                   : judged.count(Json::array({entry.key[0], entry.key[1]})) == 0) {
      fail(entry.key,
           fmt::format("{}: NOT CHECKED: this run did not judge {} {} ({}:{})", name_of(entry.key),
                       entry.key[0].get<std::string>(), entry.key[1].get<std::string>(), ratchet.name, entry.line));
      outcome.accepted += line_of(entry.key, entry.figure, entry.expiry, entry.owner, entry.reason) + "\n";
      continue;
    }
    outcome.better.push_back(fmt::format("{}: 0, accepted is {} ({}:{}); remove the line", name_of(entry.key),
                                         entry.figure.dump(), ratchet.name, entry.line));
  }
  return outcome;
}

Json outcome_json(const Ratchet& ratchet, const RatchetOutcome& outcome) {
  Json json = {{"schema", "axiscert-held/1"}, {"file", ratchet.name},     {"plan", ratchet.plan},
               {"failures", Json::array()},   {"better", outcome.better}, {"accepted", outcome.accepted}};
  for (const auto& [key, text] : outcome.failures) {
    json["failures"].push_back({{"fingerprint", fingerprint(key)},
                                {"kernel", key[0]},
                                {"precision", key[1]},
                                {"family", key[2]},
                                {"cell", key[3]},
                                {"text", text}});
  }
  return json;
}

std::string ratchet_text(const Json& record) {
  const std::string plan = plan_fingerprint(record["plan"]);
  if (plan.empty())
    return "# The queries of this run depended on the time available: no other run can be compared with it.\n";
  std::string text = head(plan, std::string(test_of(record["plan"]).id));
  for (const Cell& cell : cells_of(record)) {
    if (is_held(cell)) text += open_line(cell) + "\n";
  }
  return text;
}

}  // namespace axiscert
