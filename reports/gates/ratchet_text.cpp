#include "fuzz/text/json.h"
#include "reports/gates/ratchet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include "kernel/base/error.h"
#include "reports/comparison/cells.h"

namespace axiscert {
namespace {

constexpr std::string_view ratchet_schema = "axiscert-ratchet/5", any_ratchet = "axiscert-ratchet/";
constexpr std::string_view queries_word = "queries=";
constexpr std::string_view open_expiry = "EXPIRY", open_owner = "OWNER", open_reason = "REASON";

std::string word(const std::string& text) {
  const bool needs_no_quotes =
      !text.empty() && text[0] != '#' &&
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return c > 0x20 && c < 0x7f && c != '"'; });
  return needs_no_quotes ? text : Json(text).dump();
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

Waiver waiver_of(const std::string& expiry, const std::string& owner, const std::string& reason, const Line& line) {
  if (expiry != "never" && !is_date(expiry))
    line.fail(fmt::format("EXPIRY '{}' is neither a day, YYYY-MM-DD, nor never", expiry));
  if (owner.empty() || owner == open_owner) line.fail("OWNER is not filled in: name who is responsible for this");
  if (reason.empty() || reason == open_reason) line.fail("REASON is not filled in: say why this is accepted");
  return {expiry, owner, reason};
}

Json figure_of(const std::string& text, const Line& line) {
  Json figure = Json::parse(text, nullptr, false);
  if (!figure.is_number() || figure < 0) line.fail(fmt::format("FIGURE '{}' is not a number >= 0", text));
  return figure;
}

// The lines after the head.
class Lines {
 public:
  explicit Lines(Ratchet& ratchet) : ratchet_(ratchet) {}

  void add(const std::vector<std::string>& words, const Line& line) {
    const std::string& first = words[0];
    const auto has = [&](std::size_t n, const char* form) {
      if (words.size() == n + 1) return;
      line.fail(fmt::format("{} words after {}, but it has {}: {}; put words with spaces in \"...\"", words.size() - 1,
                            first, n, form));
    };
    if (first == "accept:") {
      has(3, "EXPIRY OWNER REASON");
      waiver_ = waiver_of(words[1], words[2], words[3], line);
    } else if (first == "kernel:") {
      add_kernel(words, line);
    } else if (first == "promise:") {
      add_promise(words, line);
    } else if (first == "family:") {
      has(2, "PRECISION FAMILY");
      require_precision(words[1], line);
      family_ = {words[1], words[2]};
    } else if (first == "loading:") {
      has(0, "it stands alone");
      family_ = {"", ""};
    } else {
      add_figures(words, line);
    }
  }

 private:
  static void require_precision(const std::string& precision, const Line& line) {
    if (precision != "binary32" && precision != "binary64")
      line.fail(fmt::format("PRECISION '{}' is neither binary32 nor binary64", precision));
  }

  void add_promise(const std::vector<std::string>& words, const Line& line) {
    if (!kernel_) line.fail("promise: before kernel: says whose promise it is");
    if (words.size() < 3 || !words[2].starts_with(queries_word))
      line.fail("promise: without its form: PRECISION queries=NUMBER touching=ANSWER [PART]...");
    require_precision(words[1], line);
    if (const HeldPromise* const other = find_promise(ratchet_.promises, *kernel_, words[1]))
      line.fail(fmt::format("{} {} has two promises, the first in line {}", *kernel_, words[1], other->line));
    const Json queries = Json::parse(words[2].substr(queries_word.size()), nullptr, false);
    if (!queries.is_number_unsigned()) line.fail(fmt::format("'{}' is not queries=NUMBER", words[2]));
    Promise promise;
    std::vector<Shown> shows;
    try {
      std::vector<std::string> promised;
      for (const std::string& word : std::span(words).subspan(3)) {
        if (!add_shown_word(word, known_predicate(), shows)) promised.push_back(word);
      }
      promise = promise_of_words(promised);
    } catch (const Error& wrong) {
      line.fail(wrong.what());
    }
    ratchet_.promises.push_back({*kernel_, words[1], promise, shows, queries.get<std::uint64_t>(), line.number});
  }

  void add_kernel(const std::vector<std::string>& words, const Line& line) {
    if (words.size() < 2) line.fail("kernel: without a kernel: KERNEL [FILE:SHA256]...");
    kernel_ = words[1];
    family_.reset();
    Digests digests;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::size_t colon = words[i].rfind(':');
      const std::string hash = colon == words[i].npos ? "" : words[i].substr(colon + 1);
      if (colon == 0 || hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != hash.npos)
        line.fail(fmt::format("'{}' is not FILE:SHA256 with 64 hex digits", words[i]));
      digests.push_back({words[i].substr(0, colon), hash});
    }
    if (!digests.empty()) ratchet_.digests[*kernel_] = digests;
  }

  void add_figures(const std::vector<std::string>& words, const Line& line) {
    if (!waiver_ || !kernel_ || !family_) {
      line.fail(fmt::format("'{}' before {} says {}", words[0],
                            !waiver_   ? "accept:"
                            : !kernel_ ? "kernel:"
                                       : "family:",
                            !waiver_   ? "until when and why it is accepted"
                            : !kernel_ ? "whose error it is"
                                       : "on which queries"));
    }
    const std::string& place = words[0];
    check_place(place, line);
    if (words.size() == 1) line.fail(fmt::format("'{}' without a FIGURE=NUMBER", place));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      const std::string member = words[i].substr(0, equals);
      const auto members = members_of(place);
      if (equals == words[i].npos || std::find(members.begin(), members.end(), member) == members.end()) {
        line.fail(fmt::format("'{}' is not FIGURE=NUMBER with a figure of '{}': {}", words[i], place,
                              fmt::join(members, ", ")));
      }
      const Json key = Json::array({*kernel_, family_->first, family_->second, place + "." + member});
      put({key, figure_of(words[i].substr(equals + 1), line), *waiver_, line.number}, line);
    }
  }

  // A predicate that is not known here is refused where the plan is compared.
  const Predicate* known_predicate() const {
    const auto all = predicates();
    const auto found = std::ranges::find(all, std::string_view(ratchet_.predicate), &Predicate::id);
    return found == all.end() ? nullptr : *found;
  }

  void check_place(const std::string& place, const Line& line) const {
    const Predicate* const predicate = known_predicate();
    if (predicate == nullptr) return;
    std::vector<std::string_view> known = {"verdict", "finding"};
    for (const std::string_view of_contacts : places_of_contacts(*predicate)) known.push_back(of_contacts);
    for (const PredicateComparison& comparison : predicate->comparisons) known.push_back(comparison.name);
    if (std::find(known.begin(), known.end(), place) != known.end()) return;
    line.fail(
        fmt::format("'{}' is no place of a figure; those are: {}; other lines begin with accept:, kernel:, "
                    "promise:, family: or loading:",
                    place, fmt::join(known, ", ")));
  }

  void put(RatchetEntry entry, const Line& line) {
    const auto [at_entry, is_new] = ratchet_.entries.emplace(fingerprint(entry.key), entry);
    if (!is_new)
      line.fail(fmt::format("{} appears twice, first in line {}", cell_text(entry.key), at_entry->second.line));
  }

  Ratchet& ratchet_;
  std::optional<Waiver> waiver_;
  std::optional<std::string> kernel_;
  std::optional<std::pair<std::string, std::string>> family_;  // precision and family
};

// Whether a figure, PLACE.MEMBER, counts answers without a number.
bool is_about_silence(const std::string& figure) {
  return figure.ends_with(".none") || figure.ends_with(".missing") || figure.ends_with(".invalid");
}

}  // namespace

const Waiver& open_waiver() {
  static const Waiver open{std::string(open_expiry), std::string(open_owner), std::string(open_reason)};
  return open;
}

Ratchet parse_ratchet(std::string_view text, const std::string& name) {
  Ratchet ratchet;
  ratchet.name = name;
  Lines lines(ratchet);
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
      if (words[0] != ratchet_schema && words[0].starts_with(any_ratchet)) {
        line.fail(
            fmt::format("'{}' is of another version than '{}', which this axiscert reads; run without --ratchet, and "
                        "review the ratchet.txt that the run writes",
                        words[0].substr(0, 80), ratchet_schema));
      }
      if (words[0] != ratchet_schema || words.size() < 2 || words.size() > 3) {
        line.fail(
            fmt::format("begins with '{}', but a ratchet begins with '{} PLAN [PREDICATE]'; a run writes one as "
                        "ratchet.txt",
                        words[0].substr(0, 80), ratchet_schema));
      }
      ratchet.plan = words[1];
      ratchet.predicate = words.size() == 3 ? words[2] : std::string(predicate_named("").id);
    } else {
      lines.add(words, line);
    }
  }
  if (ratchet.plan.empty()) throw Error(fmt::format("{}: empty; a run writes a ratchet as ratchet.txt", name));
  if (ratchet.promises.empty())
    throw Error(
        fmt::format("{}: without a promise: line it holds no kernel; a run writes a ratchet as ratchet.txt", name));
  for (const auto& [fingerprint, entry] : ratchet.entries) {
    const std::string kernel = entry.key[0], precision = entry.key[1], place = entry.key[3];
    if (precision.empty()) continue;
    const HeldPromise* const promise = find_promise(ratchet.promises, kernel, precision);
    if (promise == nullptr) {
      Line{name, entry.line}.fail(
          fmt::format("a figure of {} {} without a promise: of it; take that line too from the ratchet.txt of a run",
                      kernel, precision));
    }
    const std::size_t dot = place.rfind('.');
    for (const std::string_view shown : shown_of(place.substr(0, dot), std::string_view(place).substr(dot + 1))) {
      const auto found = std::ranges::find(promise->shows, shown, &Shown::name);
      const bool is_shown = found != promise->shows.end() &&
                            (!found->beside || (*found->beside)[0].given + (*found->beside)[1].given != 0);
      if (is_shown || is_about_silence(place)) continue;
      Line{name, entry.line}.fail(
          fmt::format("a figure of {} {}, and its promise: in line {} does not show {}; take that line from the "
                      "ratchet.txt of a run",
                      kernel, precision, promise->line, shown));
    }
  }
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
  return parse_ratchet(text.view(), printable_line(path));
}

std::string ratchet_file(const std::string& plan, const Predicate& predicate, const std::vector<HeldPromise>& promises,
                         const std::vector<RatchetEntry>& entries, const std::map<std::string, Digests>& digests) {
  const std::string_view named = written_name(predicate);
  std::string text = fmt::format(
      "{} {}{}\n# promise: on what each kernel is held to be right; accept: until when, by whom, why; docs/ci.md\n",
      ratchet_schema, plan, named.empty() ? "" : " " + word(std::string(named)));
  std::set<std::string> written;  // kernels whose digests are there
  const auto kernel_line = [&](const std::string& kernel) {
    std::string line = "kernel: " + word(kernel);
    const auto digest = digests.find(kernel);
    if (!written.insert(kernel).second || digest == digests.end()) return line;
    for (const DigestRecord& file : digest->second) line += " " + word(file.kind + ":" + file.sha256);
    return line;
  };
  std::string kernel;
  for (const HeldPromise& held : promises) {
    if (held.kernel != kernel) text += kernel_line(kernel = held.kernel) + "\n";
    std::vector<std::string> words = words_of_promise(held.promise);
    std::ranges::copy(words_of_shown(held.shows), std::back_inserter(words));
    text += fmt::format("promise: {} {}{} {}\n", held.precision, queries_word, held.queries, fmt::join(words, " "));
  }

  std::vector<Waiver> waivers;
  for (const bool are_open : {false, true}) {
    for (const RatchetEntry& entry : entries) {
      const bool is_new = std::find(waivers.begin(), waivers.end(), entry.waiver) == waivers.end();
      if (is_new && (entry.waiver == open_waiver()) == are_open) waivers.push_back(entry.waiver);
    }
  }
  for (const Waiver& waiver : waivers) {
    text += fmt::format("accept: {} {} {}", waiver.expiry, word(waiver.owner), word(waiver.reason));
    std::string family, place;  // those of the line before
    kernel.clear();
    for (const RatchetEntry& entry : entries) {
      if (entry.waiver != waiver) continue;
      const std::string name = entry.key[3];
      const std::size_t dot = name.rfind('.');
      if (std::string now = entry.key[0]; now != kernel || family.empty()) {
        kernel = std::move(now);
        text += "\n" + kernel_line(kernel);
        family.clear();
      }
      const std::string precision = entry.key[1];
      std::string now = precision.empty()
                            ? "loading:"
                            : fmt::format("family: {} {}", precision, word(entry.key[2].get<std::string>()));
      if (now != family) {
        family = std::move(now);
        text += "\n" + family;
        place.clear();
      }
      if (const std::string here = name.substr(0, dot); here != place) {
        place = here;
        text += "\n" + place;
      }
      text += fmt::format(" {}={}", name.substr(dot + 1), entry.figure.dump());
    }
    text += "\n";
  }
  return text;
}

}  // namespace axiscert
