// The pipe's reply stream: header, plan and replies. It is either refused by Error that names the stream, or read; then
// the plan's own header is read to the same plan, and every reply is at its position.
//
// Input: the plan's JSON, a zero byte, the replies. Lengths, counts and hashes are computed from those, because
// otherwise no input would pass their checks. An input that begins like a header is taken as it is.
#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fuzz/text/file_bytes.h"
#include "fuzz/files/streams.h"
#include "fuzz/text/json.h"
#include "kernel/base/sha256.h"
#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/target.h"
#include "kernel/sphere_triangle/query.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;
using Json = nlohmann::json;

// The one file that a plan may name here; seeds.py has a plan that does.
constexpr std::string_view given_file =
    R"({"id":"ok","precision":"binary32","a":[0,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,1],"r":0.5})"
    "\n";

// A plan's `path` is opened, whatever it names; the target must not open files other than its own.
bool names_only_the_given_file(const std::string& plan) {
  const Json json = Json::parse(plan, nullptr, false);
  if (!json.is_object() || !json.contains("sources") || !json["sources"].is_structured()) return true;
  for (const Json& part : json["sources"]) {
    if (part.is_object() && part.contains("path") && part.value("name", Json()) != "given.jsonl") return false;
  }
  return true;
}

std::uint64_t count_of(const std::string& plan) {
  const Json json = Json::parse(plan, nullptr, false);
  std::uint64_t count = 0;
  if (!json.is_object() || !json.contains("sources") || !json["sources"].is_structured()) return count;
  for (const Json& part : json["sources"]) {
    if (part.is_object() && part.contains("queries") && part["queries"].is_number_unsigned()) {
      count += part["queries"].get<std::uint64_t>();
    }
  }
  return count;
}

std::string stream_of(std::string_view input) {
  const std::size_t end = std::min(input.find('\0'), input.size());
  std::string plan(input.substr(0, end));
  const std::string_view replies = input.substr(std::min(end + 1, input.size()));
  const std::size_t whole = sizeof(pipe::Head) + plan.size();
  const auto precision = plan.find("binary64") == plan.npos ? Precision::binary32 : Precision::binary64;
  const std::uint64_t count = count_of(plan);
  plan.append(pipe::header_multiple - whole % pipe::header_multiple, ' ');
  const pipe::Head head{pipe::magic,
                        pipe::version,
                        pipe::code_of(precision),
                        count,
                        static_cast<std::uint32_t>(sizeof(pipe::Head) + plan.size()),
                        pipe::record_size_of(precision, sphere_triangle_predicate().entries.front().columns.size()),
                        sha256(std::as_bytes(std::span(plan)))};
  std::string stream(sizeof head, '\0');
  std::memcpy(stream.data(), &head, sizeof head);
  return stream.append(plan).append(replies);
}

void check(const std::string& stream, const FilePlaces& places) {
  ReplyStream read;
  const bool is_read = accepts([&] {
    std::istringstream in(stream);
    read = read_replies(in, "fuzzed", places);
  });
  if (!is_read) return;
  if (const auto size = read.replies.size(); size != read.plan.queries()) {
    report_fault(fmt::format("{} replies to the {} queries of the plan", size, read.plan.queries()));
  }
  if (read.numbers.size() != read.plan.queries() * read.plan.measures)
    report_fault("not as many measures as the plan says");
  std::string again;
  if (!accepts([&] { again = header_of(read.plan); }))
    report_fault("the header of a plan that was read cannot be written");
  std::istringstream in(again);
  PipeHeader header;
  if (!accepts([&] { header = read_header(in, "written", places); }))
    report_fault("a header that was written cannot be read");
  if (header_of(header.plan) != again) report_fault("a header changes when it is written, read and written again");

  const ReplyStream replies = read;
  std::vector<ReplyStream> streams;
  streams.push_back(std::move(read));
  if (!accepts([&] { StoredReplies(std::vector(streams)); })) return;  // a source appears twice
  const StoredReplies stored(std::move(streams));
  std::size_t next = 0;
  for (const PipePlan::Part& part : header.plan.parts) {
    for (std::uint64_t i = 0; i < part.queries; ++i, ++next) {
      const Source* source = nullptr;
      for (const SourcePtr& one : stored.sources()) {
        if (one->name() == part.source->name()) source = one.get();
      }
      const Answer answer = stored.at(*source, header.plan.precision, i);
      if (answer.verdict != replies.at(next).verdict) report_fault("a reply is not at its position");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = text_of(data, size);
  const bool is_whole = input.starts_with(std::string_view(pipe::magic.data(), pipe::magic.size()));
  const std::string stream = is_whole ? std::string(input) : stream_of(input);
  // libFuzzer discards an input for which this returns -1.
  if (is_whole ? input.find("path") != input.npos
               : !names_only_the_given_file(std::string(input.substr(0, input.find('\0'))))) {
    return -1;
  }
  const MemoryFile file(given_file);
  check(stream, {{"given.jsonl", file.path()}});
  return 0;
}

// Changes the plan by its structure, up to the zero byte; the replies by their bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return mutate_json_until(data, size, room, seed, '\0');
}
