#include "reports/certificate/statement/statement.h"

#include <fmt/format.h>

#include <span>

#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/plugin/load.h"
#include "reports/certificate/statement/canonical.h"

namespace axiscert {
namespace {

std::string sha256_of(const std::string& bytes) { return sha256_hex(std::as_bytes(std::span(bytes))); }

}  // namespace

KernelKind kind_of_kernel(const Kernel& kernel) {
  if (kernel.file.empty()) return KernelKind::built_in;
  if (!plugin::is_given_by_file(kernel.id)) return KernelKind::peer;
  return plugin::is_program(kernel) ? KernelKind::program : KernelKind::plugin;
}

SubjectStatement file_subject(const std::string& path, const std::string& what) {
  return {base_name(path), {sha256_of(read_bytes(path))}, {what}};
}

SubjectStatement built_in_subject(const std::string& id) { return {id, {source_digests().kernels}, {"built-in"}}; }

std::vector<SubjectStatement> subjects_of(const Kernel& kernel) {
  if (kernel.file.empty()) return {built_in_subject(kernel.id)};
  std::vector<SubjectStatement> subjects;
  for (const plugin::KernelFile& file : plugin::files_of(kernel))
    subjects.push_back(file_subject(file.path, file.kind));
  return subjects;
}

Json without_fractions(const Json& value) {
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_structured()) return value;
  Json whole = value.is_array() ? Json::array() : Json::object();
  for (const auto& [name, part] : value.items()) {
    if (value.is_array()) whole.push_back(without_fractions(part));
    else whole[name] = without_fractions(part);
  }
  return whole;
}

Json portable_plan(Json plan) {
  plan["kernels"][0] = portable_id;
  Json files = Json::array();
  for (const Json& file : plan["files"]) {
    if (file["kind"] == "mesh" || file["kind"] == "queries") files.push_back(file);
  }
  plan["files"] = files;
  plan["units_done"] = nullptr;
  plan.erase("axiscert");
  return without_fractions(plan);
}

std::string digest_of_json(const Json& value) {
  const std::string text = canonical_json(value);
  return sha256_hex(std::as_bytes(std::span(text)));
}

}  // namespace axiscert
