#include "fuzz/files/pipe_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>

#include "fuzz/text/file_bytes.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/sha256.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/plugin/pipe_format.h"

namespace axiscert {
namespace {

using Json = nlohmann::ordered_json;
using KnownPredicates = std::span<const Predicate* const>;

// The greatest count of queries: JSON readers represent no greater integer.
constexpr std::uint64_t greatest_count = (std::uint64_t{1} << 53) - 1;

// One part of the plan: a family, or a file with its kind, its names and its hash.
Json part_json(const PipePlan::Part& part) {
  const auto file = part.source->file();
  Json json = {{"kind", file ? file->kind : "family"}, {"name", file ? file->name : part.source->name()}};
  if (file) {
    if (file->path == "-") {
      throw Error("--queries -: `axiscert judge` cannot read standard input again; give a file");
    }
    json["path"] = file->path;
    json["sha256"] = file->sha256;
  }
  json["version"] = part.source->version();
  json["queries"] = part.queries;
  return json;
}

// A source whose queries are not of the given predicate and entry, and what it has instead; empty if there is none.
std::string other_predicate(const PipePlan& plan, const Predicate& predicate, std::size_t entry) {
  for (const PipePlan::Part& part : plan.parts) {
    const Source& source = *part.source;
    if (&source.predicate() == &predicate && source.entry() == entry) continue;
    return fmt::format("{} has queries of {}, entry {}", source.name(), source.predicate().id,
                       source.predicate().entries[source.entry()].name);
  }
  return "";
}

// The fault of a plan that asks for more measures than its predicate has; empty if there is none.
std::string too_many_measures(const Predicate& predicate, std::size_t measures) {
  if (measures <= predicate.measures.size()) return "";
  if (predicate.measures.empty())
    return fmt::format("{} measures, but the predicate {} has none", measures, predicate.id);
  return fmt::format("{} measures, but the predicate {} has {}, from {} to {} (`axiscert predicates`)", measures,
                     predicate.id, predicate.measures.size(), predicate.measures.front().name,
                     predicate.measures.back().name);
}

std::array<std::byte, 32> hash_of(std::string_view text) { return sha256(std::as_bytes(std::span(text))); }

// Detects everything that can be wrong with one header, in the order in which it is read.
class Reader {
 public:
  Reader(std::istream& in, const std::string& name, const FilePlaces& places, KnownPredicates known)
      : in_(in), name_(name), places_(places), known_(known) {}

  PipeHeader read() {
    read_head();
    const std::string text = read_plan();
    PipePlan plan;
    try {
      plan = plan_of(Json::parse(text));
    } catch (const Json::exception& wrong) {
      fail(fmt::format("the plan in the header is not one that this axiscert writes: {}", wrong.what()));
    }
    const std::uint64_t count = plan.queries();
    const std::uint32_t record_size = pipe::record_size_of(plan.precision, plan.columns().columns.size());
    if (head_.precision != pipe::code_of(plan.precision) || head_.record_size != record_size || head_.count != count) {
      fail(fmt::format(
          "the header was changed: it says {} queries of {} bytes in binary{}, its plan {} of {} in {}; a "
          "program has to copy it unchanged",
          head_.count, head_.record_size, head_.precision, count, record_size, axiscert::name(plan.precision)));
    }
    return {plan, head_.header_size};
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: {}", name_, what)); }

  [[noreturn]] void fail_truncated(std::size_t got, std::size_t due) const {
    fail(fmt::format("ends after {} bytes, inside the header of {}", got, due));
  }

  void read_head() {
    std::array<char, sizeof head_> bytes;
    const std::size_t got = read_block(in_, bytes, name_);
    if (got == 0) fail("empty; a reply stream begins with the header of the queries (docs/pipe.md)");
    const std::string_view start(bytes.data(), got);
    if (!std::string_view(pipe::magic.data(), pipe::magic.size()).starts_with(start.substr(0, pipe::magic.size()))) {
      fail_magic(start);
    }
    if (got < bytes.size()) fail_truncated(got, bytes.size());
    std::memcpy(&head_, bytes.data(), sizeof head_);
    if (head_.version != pipe::version) {
      fail(
          fmt::format("version {} of the format, but this axiscert reads version {}: generate the queries again, and "
                      "reply as docs/pipe.md says",
                      head_.version, pipe::version));
    }
    if (head_.header_size <= sizeof head_ || head_.header_size > pipe::greatest_header ||
        head_.header_size % pipe::header_multiple != 0) {
      fail(fmt::format("the header was changed: it cannot be {} bytes long; a program has to copy it unchanged",
                       head_.header_size));
    }
  }

  [[noreturn]] void fail_magic(std::string_view start) const {
    if (const std::string text = printed_text(start); !text.empty()) {
      fail(
          fmt::format("begins with text, \"{}\", and not with the header; did the program print to standard output? "
                      "Messages go to standard error",
                      text));
    }
    fail(
        "does not begin with AXISCERT: a reply stream is the header of the queries, copied unchanged, and then 16 "
        "bytes "
        "a query");
  }

  std::string read_plan() {
    std::string text(head_.header_size - sizeof head_, '\0');
    const std::size_t got = read_block(in_, text, name_);
    if (got < text.size()) fail_truncated(sizeof head_ + got, head_.header_size);
    if (hash_of(text) != head_.plan_sha256) {
      fail(fmt::format(
          "the header was changed: the SHA-256 of its plan is not the one it states; a program has to copy all "
          "{} bytes unchanged",
          head_.header_size));
    }
    return text;
  }

  PipePlan plan_of(const Json& json) const {
    const auto version = json.at("axiscert").get<std::string>();
    if (version != axiscert_version) {
      fail(fmt::format("these queries were made by axiscert {}, and this is {}: generate them again", shown(version),
                       axiscert_version));
    }
    PipePlan plan{whole<std::uint64_t>(json, "seed"), Precision::binary32, {}, 0};
    if (json.at("precision") == axiscert::name(Precision::binary64)) plan.precision = Precision::binary64;
    const Predicate& predicate = predicate_of(json);
    const std::size_t entry = entry_of(json, predicate);
    for (const Json& part : json.at("sources")) {
      plan.parts.push_back({source_of(part, plan.precision, predicate), whole<std::uint64_t>(part, "queries")});
      check(part, plan.parts.back(), plan.precision);
    }
    if (const std::string other = other_predicate(plan, predicate, entry); !other.empty()) {
      fail(fmt::format("its plan is of the predicate {}, entry {}, but {} here", predicate.id,
                       predicate.entries[entry].name, other));
    }
    if (json.contains("measures")) plan.measures = whole<std::size_t>(json, "measures");
    if (const std::string wrong = too_many_measures(predicate, plan.measures); !wrong.empty()) {
      fail("its plan has " + wrong);
    }
    return plan;
  }

  const Predicate& predicate_of(const Json& json) const {
    try {
      return find_predicate(shown(json.at("predicate").get<std::string>()), known_);
    } catch (const Error& unknown) {
      fail(unknown.what());
    }
  }

  std::size_t entry_of(const Json& json, const Predicate& predicate) const {
    std::size_t entry = 0;
    try {
      entry = find_entry(predicate, shown(json.at("entry").get<std::string>()));
    } catch (const Error& unknown) {
      fail(unknown.what());
    }
    const std::size_t columns = predicate.entries[entry].columns.size();
    if (const auto said = whole<std::size_t>(json, "columns"); said != columns) {
      fail(fmt::format("its plan has {} columns, but {}, entry {}, has {} here", said, predicate.id,
                       predicate.entries[entry].name, columns));
    }
    return entry;
  }

  template <class Whole>
  Whole whole(const Json& json, const char* member) const {
    try {
      return whole_number<Whole>(json.at(member));
    } catch (const Error& wrong) {
      fail(fmt::format("in its plan '{}': {}", member, wrong.what()));
    }
  }

  SourcePtr source_of(const Json& part, Precision precision, const Predicate& predicate) const {
    const auto kind = part.at("kind").get<std::string>(), base = part.at("name").get<std::string>();
    if (kind != "family" && kind != "mesh" && kind != "queries") {
      fail(fmt::format("its plan has a source of unknown kind '{}'", shown(kind)));
    }
    try {
      if (kind == "family") return family_source(find_family(base));
      const auto place = places_.find(base);
      const std::string path = place != places_.end() ? place->second : part.at("path").get<std::string>();
      return kind == "mesh" ? mesh_source(path, predicate) : query_file_source(path, precision, known_);
    } catch (const Error& wrong) {
      if (kind == "family") fail(wrong.what());
      fail(fmt::format("its queries come from a file. {}; give its present path with --{} FILE", wrong.what(), kind));
    }
  }

  void check(const Json& json, const PipePlan::Part& part, Precision precision) const {
    const Source& source = *part.source;
    if (const auto version = whole<int>(json, "version"); version != source.version()) {
      fail(
          fmt::format("these queries are from version {} of the generator {}, which is at version {} here: generate "
                      "them again",
                      version, source.name(), source.version()));
    }
    if (const auto file = source.file(); file && json.at("sha256") != file->sha256) {
      fail(fmt::format("{} is not the file that the queries come from: its SHA-256 is {}, not {}", file->path,
                       file->sha256, shown(json.at("sha256").get<std::string>())));
    }
    if (source.fixed_size(precision).value_or(part.queries) != part.queries) {
      fail(fmt::format("{} has {} queries in {}, but the plan says {}", source.name(), *source.fixed_size(precision),
                       axiscert::name(precision), part.queries));
    }
  }

  std::istream& in_;
  const std::string& name_;
  const FilePlaces& places_;
  KnownPredicates known_;
  pipe::Head head_{};
};

}  // namespace

std::uint64_t PipePlan::queries() const {
  std::uint64_t all = 0;
  for (const Part& part : parts) {
    if (part.queries > greatest_count - all) {
      throw Error(fmt::format("more queries than the {} that a stream can count", greatest_count));
    }
    all += part.queries;
  }
  return all;
}

std::string printed_text(std::string_view bytes) {
  constexpr std::ptrdiff_t least = 4;  // three bytes can look like letters by chance
  const auto end = std::find_if(bytes.begin(), bytes.end(),
                                [](unsigned char c) { return std::isprint(c) == 0 && std::isspace(c) == 0; });
  return end - bytes.begin() < least ? "" : shown(std::string_view(bytes.begin(), end));
}

std::string header_of(const PipePlan& plan) {
  if (const std::string other = other_predicate(plan, plan.predicate(), plan.entry()); !other.empty()) {
    throw Error(fmt::format("a stream is of one predicate and one entry: {} has queries of {}, entry {}, but {}",
                            plan.parts.front().source->name(), plan.predicate().id, plan.columns().name, other));
  }
  if (const std::string wrong = too_many_measures(plan.predicate(), plan.measures); !wrong.empty()) throw Error(wrong);
  Json json = {{"axiscert", axiscert_version},      {"seed", plan.seed},
               {"precision", name(plan.precision)}, {"predicate", plan.predicate().id},
               {"entry", plan.columns().name},      {"columns", plan.columns().columns.size()}};
  if (plan.measures != 0) json["measures"] = plan.measures;
  json["sources"] = Json::array();
  std::string text;
  try {
    for (const PipePlan::Part& part : plan.parts) json["sources"].push_back(part_json(part));
    text = json.dump();
  } catch (const Json::exception&) {
    throw Error(
        "the path of a mesh or query file is not UTF-8, which the plan in a stream's header is: rename the file");
  }
  text += '\n';
  std::string bytes =
      pipe::stream_header(std::move(text), plan.columns().columns.size(), plan.precision, plan.queries());
  if (bytes.size() > pipe::greatest_header) {
    throw Error(fmt::format("the plan takes more than the {} bytes of a header: name fewer files in one stream",
                            pipe::greatest_header));
  }
  return bytes;
}

PipeHeader read_header(std::istream& in, const std::string& name, const FilePlaces& places, KnownPredicates known) {
  return Reader(in, name, places, known).read();
}

}  // namespace axiscert
