#include "plans/output_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "fuzz/files/query_file.h"
#include "kernel/base/error.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {

void make_folder(const std::string& path) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  const auto probe = std::filesystem::path(path) / ".writable";
  if (problem || !std::ofstream(probe)) {
    throw Error(fmt::format("--out {}: cannot write there{}; give a folder that can be made or written", path,
                            problem ? ": " + problem.message() : ""));
  }
  std::filesystem::remove(probe, problem);
}

OutputFolder::OutputFolder(const std::string& path) : path_(path) { make_folder(path); }

void OutputFolder::write_text(const std::string& file, const std::string& text) const {
  std::filesystem::create_directories((path_ / file).parent_path());
  write_files(path_, {{file, text}});
}

void OutputFolder::remove(const std::string& file) const {
  std::error_code problem;
  std::filesystem::remove(path_ / file, problem);
  if (problem) throw Error(fmt::format("{}: cannot be removed: {}", (path_ / file).string(), problem.message()));
}

void OutputFolder::write(const std::string& file, const Json& json) const { write_text(file, json.dump(1) + "\n"); }

std::string OutputFolder::save(const OracleDisagreement& d) const {
  const auto numbers = [&]<class Real>(Real) {
    Numbers<Real> values(d.query.size());
    std::transform(d.query.begin(), d.query.end(), values.begin(), [](double x) { return static_cast<Real>(x); });
    return values;
  };
  StoredQuery stored{"disagreement", d.precision, numbers(double()), d.predicate, d.entry};
  if (d.precision == Precision::binary32) stored.numbers = numbers(float());
  write_text("disagreement.jsonl", query_line(stored) + "\n");
  return path("disagreement.jsonl");
}

std::string iso_time(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace axiscert
