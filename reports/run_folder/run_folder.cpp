#include "reports/run_folder/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/names.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/count_checks.h"
#include "reports/run_folder/record_checks.h"

namespace axiscert {
Json parsed_json(std::string_view text) {
  // Stops in the middle of the text; what was read up to there is not deeper either.
  return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
    if (depth <= greatest_json_depth) return true;
    throw Json::other_error::create(
        500,
        fmt::format("deeper than {} levels, which is deeper than anything that axiscert writes", greatest_json_depth),
        nullptr);
  });
}

namespace {

// Errors name the file, say what would be right, and end with `advice`: what to do about a damaged file.
void require_format(const Json& value, std::string_view format, const std::string& name, const std::string& advice) {
  if (!value.is_object() || !value.contains("schema"))
    throw Error(fmt::format("{}: has no \"schema\": \"{}\", which axiscert writes; {}", name, format, advice));
  if (value["schema"] != format) {
    throw Error(fmt::format(
        "{}: its schema is {}, but this axiscert reads \"{}\"; make the folder again with `axiscert run`, or "
        "use the axiscert that wrote it",
        name, shown(value["schema"].dump()), format));
  }
}

[[noreturn]] void refuse_file(std::string_view format, const std::string& fault, const std::string& name,
                              const std::string& advice) {
  throw Error(fmt::format("{}: does not conform to {}: {}; {}", name, format, fault, advice));
}

// A file as its struct, whose fields it has to have.
template <Fielded File>
File read_file(const Json& value, const std::string& name, const std::string& advice) {
  require_format(value, File::format, name, advice);
  try {
    return read_as<File>(value);
  } catch (const JsonFault& fault) {
    refuse_file(File::format, fault.what(), name, advice);
  }
}

constexpr const char* advice = "run it again, or restore the file as it was written";

// Conditions that the fields cannot express: sums, and names that refer to each other.
class RecordCheck {
 public:
  RecordCheck(const Record& record, const std::string& name)
      : record_(record), plan_(record.plan), name_(name), predicate_(predicate_of(record.plan)) {}

  void check() const {
    check_plan();
    std::set<std::pair<std::string, Precision>> entries;
    std::set<Place> places;
    for (const KernelRecord& kernel : record_.kernels) {
      const std::string where = fmt::format("kernel {} in {}", shown_name(kernel.id), name(kernel.precision));
      require(entries.emplace(kernel.id, kernel.precision).second, where, "appears twice");
      for (const auto& [family, result] : kernel.families) {
        require(contains(plan_.families, family), where,
                fmt::format("family {} is not in the plan", shown_name(family)));
        places.emplace(kernel.id, kernel.precision, family);
        check_counts(kernel, result, fmt::format("{}, family {}", where, shown_name(family)));
      }
      require(kernel.reference.has_value() == kernel.formulae.has_value(), where,
              "formulae and reference go together: both are null, or neither");
      require(!kernel.digest || !kernel.digest->empty(), where, "a digest of no file");
      require(!kernel.exposes.empty(), where, "it exposes nothing");
      require_once(kernel.exposes, where + "/exposes");
    }
    check_findings(places);
    std::set<std::string> ids;
    for (const WitnessRecord& witness : record_.witnesses) {
      const std::string where = fmt::format("witness {}", shown_name(witness.id));
      require(ids.insert(witness.id).second, where, "appears twice");
      for (const ColumnGroup& group : groups_of(*entry_of(predicate_, witness)))
        check_numbers(witness.precision, witness.numbers.at(group.name), fmt::format("{}, {}", where, group.name));
      require(places.contains({witness.kernel, witness.precision, witness.family}), where,
              "its kernel, precision and family are not in the record");
    }
  }

 private:
  using Place = std::tuple<std::string, Precision, std::string>;  // kernel, precision and family

  static std::string shown_name(const std::string& name) { return json_of(name).dump(); }
  static bool contains(const std::vector<Name>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  }

  void require(bool holds, const std::string& where, const std::string& problem) const {
    if (!holds) throw Error(fmt::format("{}: {}: {}; restore the file as it was written", name_, where, problem));
  }
  void require_no(const std::optional<std::string>& fault, const std::string& where) const {
    require(!fault, where, fault.value_or(""));
  }
  template <class One>
  void require_once(const std::vector<One>& all, const std::string& where) const {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto end = all.begin() + static_cast<std::ptrdiff_t>(i);
      require(std::find(all.begin(), end, all[i]) == end, fmt::format("{}/{}", where, i),
              json_of(all[i]).dump() + " appears twice");
    }
  }

  void check_plan() const {
    require(!plan_.kernels.empty(), "/plan/kernels", "has no kernel");
    require(!plan_.planned || !record_.complete || plan_.units_done, "/plan/planned",
            "is of a run that was interrupted or had a time limit");
    for (const auto& [family, by_precision] : plan_.planned.value_or(CountsByFamily{})) {
      const auto* const asked = plan_.trials.find(family);
      for (const auto& [precision, count] : by_precision) {
        require(asked != nullptr && asked->contains(precision) && asked->at(precision) <= count,
                fmt::format("/plan/planned/{}/{}", family, name(precision)),
                "is less than what was asked, or of nothing");
      }
    }
    require_once(plan_.kernels, "/plan/kernels");
    require_once(plan_.precisions, "/plan/precisions");
    require_once(plan_.families, "/plan/families");
  }

  void check_findings(const std::set<Place>& places) const {
    std::set<std::tuple<std::string, Precision, std::string, FindingKind>> kinds;
    std::set<std::string> explained;
    for (const FindingRecord& finding : record_.findings) {
      const std::string where =
          fmt::format("finding {} of kernel {}", json_of(finding.kind).dump(), shown_name(finding.kernel));
      const auto goes_together = [&](std::string_view member, bool has_it) {
        require(has_it == finding.family.has_value(), where,
                fmt::format("family and {} go together: both are null, or neither", member));
      };
      goes_together("precision", finding.precision.has_value());
      goes_together("address", finding.address.has_value());
      const std::vector<ColumnGroup> groups = groups_of(*entry_of(predicate_, finding));
      for (const ColumnGroup& group : groups) goes_together(group.name, finding.numbers.at(group.name).has_value());
      if (!finding.family) {
        explained.insert(finding.kernel);
        continue;
      }
      require(kinds.emplace(finding.kernel, *finding.precision, *finding.family, finding.kind).second, where,
              "appears twice");
      require(finding.count != 0, where, "a count of zero");
      require(places.contains({finding.kernel, *finding.precision, *finding.family}), where,
              "its kernel, precision and family are not in the record");
      for (const ColumnGroup& group : groups)
        check_numbers(*finding.precision, *finding.numbers.at(group.name), fmt::format("{}, {}", where, group.name));
    }
    std::set<std::string> judged;
    for (const KernelRecord& kernel : record_.kernels) judged.insert(kernel.id);
    for (const std::string& id : std::set<std::string>(plan_.kernels.begin(), plan_.kernels.end())) {
      require(judged.contains(id) || explained.contains(id), "kernel " + shown_name(id),
              "is only in the plan, and no finding of loading says why");
    }
    for (const std::string& id : explained)
      require(contains(plan_.kernels, id), "kernel " + shown_name(id), "has a finding and is not in the plan");
  }

  void check_verdict(const KernelRecord& kernel, const FamilyRecord& family, const std::string& where) const {
    const VerdictTally& verdict = family.verdict;
    require(verdict.outside_limits.has_value() == has_limits(kernel), where,
            "outside_limits is counted where the kernel declares limits, and only there");
    require(verdict.clear.has_value() != kernel.reference.value_or(false), where,
            "clear is counted where the kernel has no reference, and only there");
    require_no(fault_of_verdicts(kernel.touching, family), where);
    const std::uint64_t valid = family.truth.contact + family.truth.separated,
                        wrong = verdict.false_separation + verdict.false_contact;
    require_no(fault_of_depths(verdict, valid), where);
    for (const Link link : enumerators<Link>) {
      const std::uint64_t count = verdict.links[link], of_touching = verdict.touching_links[link];
      require(count <= wrong, where, fmt::format("more broken {} links than wrong verdicts", name(link)));
      require(of_touching <= count && of_touching <= verdict.touching_flips, where,
              fmt::format("more broken {} links of touching queries than there can be", name(link)));
      const std::optional<std::uint64_t> first = verdict.first_by_link[link].position;
      const std::uint64_t apart = link == Link::implementation ? 0 : of_touching;
      require(first.has_value() == (apart != count), where,
              fmt::format("first_by_link and links do not agree on {}", name(link)));
      // An interrupted run may have judged queries from anywhere in the plan.
      require(!first || !record_.complete || *first < family.trials, where,
              fmt::format("first_by_link of {} is not a query of the family", name(link)));
    }
  }

  void check_numbers(Precision precision, const GroupNumbers& group, const std::string& where) const {
    for (const std::string& number : group.numbers) {
      try {
        if (precision == Precision::binary32) parse_number<float>(number);
        else parse_number<double>(number);
      } catch (const Error& wrong) {
        require(false, where, wrong.what());
      }
    }
  }

  void check_counts(const KernelRecord& kernel, const FamilyRecord& family, const std::string& where) const {
    require(family.base_triangles <= family.trials, where, "more base_triangles than trials");
    check_verdict(kernel, family, where);
    require_no(fault_of_classes(kernel, family), where);
    require(!kernel.measures || kernel.measures->empty() ||
                (family.contacts && (!family.contacts->missed || family.contacts->time)),
            where, "without what the kernel says beside its verdicts, though it gives measures");
    require_no(fault_of_contacts(kernel.touching, family), where);
    if (family.contacts) {
      require_no(fault_of_sizes(*family.contacts), where);
      if (kernel.measures) require_no(fault_of_parts(*family.contacts, predicate_, kernel.measures->size()), where);
    }
    if (family.asymmetry) require_no(fault_of_asymmetry(*family.asymmetry), where);
    const std::uint64_t promised =
        family.truth.contact + family.truth.separated - family.verdict.outside_limits.value_or(OutsideTally()).trials;
    const auto check_signs = [&](const auto& signs) {
      if (!signs) return;
      for (const auto& [sign, tally] : *signs) {
        const std::uint64_t flips = tally.false_separation + tally.missed_separation;
        require(tally.masked + tally.decisive == flips, where + ", " + sign,
                "masked and decisive do not add up to the flips");
        require(flips <= tally.judged && tally.judged <= promised, where + ", " + sign,
                "more flips than judged queries, or more of these than valid ones");
      }
    };
    check_signs(family.axes);
    check_signs(family.comparisons);
  }

  const Record& record_;
  const PlanRecord& plan_;
  const std::string& name_;
  const Predicate& predicate_;
};

// Names first: the other conditions go by them.
void check_names(const Record& record, const std::string& name) {
  std::optional<std::string> fault;
  try {
    fault = fault_of_names(record);
  } catch (const Error& unknown_predicate) {
    throw Error(fmt::format("{}: /plan/predicate: {}", name, unknown_predicate.what()));
  }
  if (fault) throw Error(fmt::format("{}: {}; {}", name, *fault, advice));
}

}  // namespace

Record read_record(const Json& json, const std::string& name) {
  const auto record = read_file<Record>(json, name, advice);
  check_names(record, name);
  RecordCheck(record, name).check();
  return record;
}

RunInfo read_run_info(const Json& info, const std::string& name) { return read_file<RunInfo>(info, name, advice); }

const Predicate& predicate_of(const PlanRecord& plan) { return find_predicate(plan.predicate); }

const LengthUnit* unit_of(const PlanRecord& plan) {
  return plan.unit ? find_length_unit(static_cast<const std::string&>(*plan.unit)) : nullptr;
}

double metres_of(const PlanRecord& plan) {
  const LengthUnit* const unit = unit_of(plan);
  return unit == nullptr ? 1 : unit->metres;
}

Json read_json(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!in.is_open() || in.bad())
    throw Error(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  try {
    return parsed_json(text.view());
  } catch (const Json::exception& problem) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: ...": the bracket means nothing to a user.
    std::string what = problem.what();
    if (const auto end = what.find("] "); end != what.npos) what.erase(0, end + 2);
    throw Error(fmt::format("{}: not JSON, cut off or edited: {} (byte {} is its end)", path.string(), what,
                            text.view().size()));
  }
}

Run read_run(const std::filesystem::path& folder) {
  const auto record = folder / "record.json", info = folder / "run.json";
  std::error_code ignored;
  if (!std::filesystem::exists(record, ignored)) {
    throw Error(fmt::format("{}: does not exist; give the folder that `axiscert run --out` wrote", record.string()));
  }
  Run run{read_record(read_json(record), record.string()), std::nullopt, std::nullopt, folder};
  if (const auto held = folder / ratchet_outcome_file; std::filesystem::exists(held, ignored)) {
    run.ratchet = read_file<RatchetOutcome>(read_json(held), held.string(), advice);
    if (run.ratchet->plan != plan_fingerprint(run.record.plan))
      throw Error(fmt::format("{}: belongs to another plan than the record next to it; remove it", held.string()));
  }
  if (std::filesystem::exists(info, ignored)) run.info = read_run_info(read_json(info), info.string());
  return run;
}

bool has_limits(const KernelRecord& kernel) {
  return kernel.limits.has_value() || kernel.motion.value_or(PolicyRecord()) != PolicyRecord();
}

void write_files(const std::filesystem::path& folder, const std::map<std::string, std::string>& texts) {
  struct Part {
    std::filesystem::path path, target;
    ~Part() {
      std::error_code ignored;
      std::filesystem::remove(path, ignored);  // after the rename the file no longer exists
    }
  };
  std::vector<Part> parts;
  parts.reserve(texts.size());  // a Part that moved would remove its file
  for (const auto& [file, text] : texts) {
    Part& part = parts.emplace_back(Part{folder / (file + ".part"), folder / file});
    errno = 0;
    std::ofstream out(part.path, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw Unwritable(part.target.string(), errno, text.size());
  }
  for (const Part& part : parts) {
    std::error_code problem;
    std::filesystem::rename(part.path, part.target, problem);
    if (problem) throw Unwritable(part.target.string(), problem.value(), std::nullopt);
  }
}

}  // namespace axiscert
