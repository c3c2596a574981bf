#include "reports/run_folder/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/motion_policy.h"
#include "kernel/names.h"
#include "reports/page/embedded.h"
#include "reports/run_folder/parsed_json.h"
#include "reports/run_folder/plan_queries.h"
#include "reports/run_folder/record_classes.h"
#include "reports/run_folder/record_names.h"
#include "reports/run_folder/schema.h"

namespace axiscert {
namespace {

constexpr const char* advice = "run it again, or restore the file as it was written";

// Conditions that the schema cannot express: sums, and names that refer to each other.
class RecordCheck {
 public:
  RecordCheck(const Json& record, const std::string& name)
      : record_(record), name_(name), test_(test_of(record["plan"])) {}

  void check() const {
    const Json& plan = record_["plan"];
    std::set<Json> entries, cells, families(plan["families"].begin(), plan["families"].end()), ids;
    for (const Json& kernel : record_["kernels"]) {
      const Json entry = Json::array({kernel["id"], kernel["precision"]});
      const std::string where = fmt::format("kernel {} in {}", entry[0].dump(), kernel["precision"].get<std::string>());
      require(entries.insert(entry).second, where, "appears twice");
      for (const auto& [family, result] : kernel["families"].items()) {
        require(families.count(family) != 0, where, fmt::format("family {} is not in the plan", Json(family).dump()));
        cells.insert(Json::array({kernel["id"], kernel["precision"], family}));
        check_counts(kernel, result, fmt::format("{}, family {}", where, Json(family).dump()));
      }
      require(kernel["reference"].is_null() == kernel["formulae"].is_null(), where,
              "formulae and reference go together: both are null, or neither");
    }
    check_findings(cells);
    for (const Json& witness : record_["witnesses"]) {
      const std::string where = fmt::format("witness {}", witness["id"].dump());
      require(ids.insert(witness["id"]).second, where, "appears twice");
      check_numbers(witness, where);
      require(cells.count(Json::array({witness["kernel"], witness["precision"], witness["family"]})) != 0, where,
              "its kernel, precision and family are not in the record");
    }
  }

 private:
  void require(bool holds, const std::string& where, const std::string& problem) const {
    if (!holds) throw Error(fmt::format("{}: {}: {}; restore the file as it was written", name_, where, problem));
  }
  void require_no(const std::optional<std::string>& fault, const std::string& where) const {
    require(!fault, where, fault.value_or(""));
  }

  void check_findings(const std::set<Json>& cells) const {
    std::set<Json> kinds, explained;
    for (const Json& finding : record_["findings"]) {
      const Json kind = Json::array({finding["kernel"], finding["precision"], finding["family"], finding["kind"]});
      const std::string where =
          fmt::format("finding {} of kernel {}", finding["kind"].dump(), finding["kernel"].dump());
      const bool of_loading = finding["family"].is_null();
      const auto goes_together = [&](const std::string& member) {
        require(finding[member].is_null() == of_loading, where,
                fmt::format("family and {} go together: both are null, or neither", member));
      };
      for (const char* member : {"precision", "address"}) goes_together(member);
      for (const ColumnGroup& group : groups_of(*entry_of(test_, finding))) goes_together(std::string(group.name));
      if (of_loading) {
        explained.insert(finding["kernel"]);
        continue;
      }
      require(kinds.insert(kind).second, where, "appears twice");
      require(finding["count"] != 0, where, "a count of zero");
      require(cells.count(Json::array({kind[0], kind[1], kind[2]})) != 0, where,
              "its kernel, precision and family are not in the record");
      check_numbers(finding, where);
    }
    std::set<Json> planned(record_["plan"]["kernels"].begin(), record_["plan"]["kernels"].end()), judged;
    for (const Json& kernel : record_["kernels"]) judged.insert(kernel["id"]);
    for (const Json& id : planned) {
      require(judged.count(id) + explained.count(id) != 0, fmt::format("kernel {}", id.dump()),
              "is only in the plan, and no finding of loading says why");
    }
    for (const Json& id : explained) {
      require(planned.count(id) != 0, fmt::format("kernel {}", id.dump()), "has a finding and is not in the plan");
    }
  }

  // The kernel's convention for touching spheres decides which verdicts can be wrong there.
  void check_verdict(const Json& kernel, const Json& family, const std::string& where) const {
    const auto number = [](const Json& count) { return count.get<std::uint64_t>(); };
    const Json &truth = family["truth"], &verdict = family["verdict"], &outside = verdict["outside_limits"];
    const std::uint64_t touching = number(truth["touching"]), contact = number(truth["contact"]);
    const std::uint64_t separated = number(truth["separated"]), valid = contact + separated;
    const std::string convention = kernel["touching"];
    const bool is_complete = record_["complete"];
    const std::uint64_t must_touch = convention == name(Touching::contact) ? contact : contact - touching;
    const std::uint64_t must_not = convention == name(Touching::separated) ? separated + touching : separated;
    require(outside.is_null() == !has_limits(kernel), where,
            "outside_limits is counted where the kernel declares limits, and only there");
    std::uint64_t missed = number(verdict["false_separation"]), phantom = number(verdict["false_contact"]);
    const std::uint64_t wrong = missed + phantom;
    std::uint64_t outside_trials = 0;
    if (!outside.is_null()) {
      outside_trials = number(outside["trials"]);
      missed += number(outside["false_separation"]);
      phantom += number(outside["false_contact"]);
      require(outside_trials <= valid, where, "more queries outside the limits than valid ones");
      require(number(outside["contact"]) <= std::min(outside_trials, contact) &&
                  number(outside["touching"]) <= std::min(number(outside["contact"]), touching) &&
                  outside_trials - number(outside["contact"]) <= separated,
              where, "more contacts, touching or separated queries outside the limits than there are");
      require(number(outside["false_separation"]) + number(outside["false_contact"]) + number(outside["unanswered"]) <=
                  outside_trials,
              where, "more wrong and missing answers outside the limits than queries there");
    }
    require(missed <= must_touch, where, "more false_separation verdicts than contacts");
    require(phantom <= must_not, where, "more false_contact verdicts than separated queries");
    require(wrong + number(verdict["undecided"]) + number(verdict["invalid"]) + number(verdict["unanswered"]) <=
                valid - outside_trials,
            where, "more wrong, undecided, invalid and unanswered verdicts than valid queries");
    require(number(verdict["undecided_contact"]) <= std::min(number(verdict["undecided"]), contact) &&
                number(verdict["undecided_touching"]) <= std::min(number(verdict["undecided_contact"]), touching) &&
                number(verdict["undecided"]) - number(verdict["undecided_contact"]) <= separated,
            where, "undecided_contact and undecided_touching do not fit undecided and the truth");
    require(number(verdict["touching_flips"]) <= wrong, where, "more touching_flips than wrong verdicts");
    require_no(fault_of_depths(verdict, valid), where);
    for (const auto& [link, count] : verdict["links"].items()) {
      const std::uint64_t of_touching = number(verdict["touching_links"][link]);
      require(number(count) <= wrong, where, fmt::format("more broken {} links than wrong verdicts", link));
      require(of_touching <= number(count) && of_touching <= number(verdict["touching_flips"]), where,
              fmt::format("more broken {} links of touching queries than there can be", link));
      const Json& first = verdict["first_by_link"][link];
      const std::uint64_t apart = link == "implementation" ? 0 : of_touching;
      require(first.is_null() == (apart == number(count)), where,
              fmt::format("first_by_link and links do not agree on {}", link));
      // An interrupted run may have judged queries from anywhere in the plan.
      require(first.is_null() || (first != 0 && (!is_complete || number(first) <= number(family["trials"]))), where,
              fmt::format("first_by_link of {} is not a query of the family", link));
    }
  }

  void check_numbers(const Json& witness, const std::string& where) const {
    for (const ColumnGroup& group : groups_of(*entry_of(test_, witness))) {
      const std::string member(group.name);
      const Json list = witness[member].is_array() ? witness[member] : Json::array({witness[member]});
      for (const Json& number : list) {
        try {
          if (witness["precision"] == name(Precision::binary32)) parse_number<float>(number.get<std::string>());
          else parse_number<double>(number.get<std::string>());
        } catch (const Error& wrong) {
          require(false, where + ", " + member, wrong.what());
        }
      }
    }
  }

  void check_counts(const Json& kernel, const Json& family, const std::string& where) const {
    const auto number = [](const Json& count) { return count.get<std::uint64_t>(); };
    const Json& truth = family["truth"];
    const std::uint64_t trials = number(family["trials"]), contact = number(truth["contact"]);
    const std::uint64_t separated = number(truth["separated"]);
    require(separated + contact + number(truth["invalid"]) == trials, where, "the truths do not add up to the trials");
    require(number(truth["touching"]) <= contact, where, "more touching queries than contacts");
    require(number(family["base_triangles"]) <= trials, where, "more base_triangles than trials");
    check_verdict(kernel, family, where);
    require_no(fault_of_classes(kernel, family), where);
    for (const char* level : {"axes", "comparisons"}) {
      if (family[level].is_null()) continue;
      for (const auto& [sign, tally] : family[level].items()) {
        require(number(tally["masked"]) + number(tally["decisive"]) ==
                    number(tally["false_separation"]) + number(tally["missed_separation"]),
                where + ", " + sign, "masked and decisive do not add up to the flips");
      }
    }
  }

  const Json& record_;
  const std::string& name_;
  const TestDescription& test_;
};

// Names first: the other conditions go by them.
void check_names(const Json& record, const std::string& name) {
  std::optional<std::string> fault;
  try {
    fault = fault_of_names(record);
  } catch (const Error& unknown_test) {
    throw Error(fmt::format("{}: /plan/test: {}", name, unknown_test.what()));
  }
  if (fault) throw Error(fmt::format("{}: {}; {}", name, *fault, advice));
}

}  // namespace

void check_record(const Json& record, const std::string& name) {
  check_schema(Json::parse(embedded::record_schema_json), record, name, advice);
  check_names(record, name);
  RecordCheck(record, name).check();
}

void check_run_info(const Json& info, const std::string& name) {
  check_schema(Json::parse(embedded::run_schema_json), info, name, advice);
}

const TestDescription& test_of(const Json& plan) { return find_test(plan["test"].get<std::string>()); }

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
  Run run{read_json(record), nullptr, nullptr, folder};
  check_record(run.record, record.string());
  if (const auto held = folder / ratchet_outcome_file; std::filesystem::exists(held, ignored)) {
    run.ratchet = read_json(held);
    check_schema(Json::parse(embedded::ratchet_schema_json), run.ratchet, held.string(), advice);
    if (run.ratchet["plan"] != plan_fingerprint(run.record["plan"]))
      throw Error(fmt::format("{}: belongs to another plan than the record next to it; remove it", held.string()));
  }
  if (std::filesystem::exists(info, ignored)) {
    run.info = read_json(info);
    check_run_info(run.info, info.string());
  }
  return run;
}

bool has_limits(const Json& kernel) {
  const auto policy = kernel.find("motion");
  const bool promises_all_motions =
      policy == kernel.end() || ((*policy)["start"] == start_policy_names[StartPolicy::reported] &&
                                 (*policy)["still"] == still_policy_names[StillPolicy::reported] &&
                                 (*policy)["sides"] == sides_policy_names[SidesPolicy::both]);
  return !kernel["limits"].is_null() || !promises_all_motions;
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
    std::ofstream out(part.path, std::ios::binary);
    out << text;
    out.close();
    if (!out) {
      throw Error(fmt::format("{}: cannot be written: {}; reports go into the run's own folder", part.path.string(),
                              std::strerror(errno)));
    }
  }
  for (const Part& part : parts) {
    std::error_code problem;
    std::filesystem::rename(part.path, part.target, problem);
    if (problem) {
      throw Error(fmt::format("{}: cannot be replaced: {}", part.target.string(), problem.message()));
    }
  }
}

}  // namespace axiscert
