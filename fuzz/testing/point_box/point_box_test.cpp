// A second predicate from end to end: listed, run, judged, recorded, and piped through a program.
#include "fuzz/testing/point_box/point_box.h"
#include "fuzz/text/json_form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "exact/judge/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"
#include "fuzz/files/query_file.h"
#include "fuzz/files/streams.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::atomic<bool> never = false;
constexpr std::uint64_t queries_of_each = 3000;

Plan toy_plan(std::vector<const Kernel*> kernels) {
  Plan plan;
  plan.answerers.kernels = std::move(kernels);
  for (const Family* family : families_of(point_box_predicate()))
    plan.questions.sources.push_back(family_source(*family));
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.questions.trials = [](const Source&, Precision) { return queries_of_each; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 2;
  return plan;
}

Json toy_record(const Plan& plan) {
  return json_of(record_of(plan, run_campaign(plan, never, [](const Progress&) {}), {}));
}

const Json& entry_of(const Json& record, std::string_view kernel, Precision precision) {
  for (const Json& entry : record["kernels"]) {
    if (entry["id"] == kernel && entry["precision"] == name(precision)) return entry;
  }
  throw Error("the record has no such kernel");
}

// The kinds of wrong verdict, summed over a kernel's families.
struct Wrong {
  std::uint64_t separations = 0, contacts = 0, by_implementation = 0, flips_of_z_above = 0, other_flips = 0;
};
Wrong wrong_in(const Json& entry) {
  Wrong sum;
  for (const auto& [family, result] : entry["families"].items()) {
    // Null where no verdict could be wrong so.
    const auto wrong = [&verdict = result["verdict"]](const char* kind) {
      return verdict[kind].is_null() ? std::uint64_t{0} : verdict[kind].get<std::uint64_t>();
    };
    sum.separations += wrong("false_separation");
    sum.contacts += wrong("false_contact");
    sum.by_implementation += result["verdict"]["links"]["implementation"].get<std::uint64_t>();
    for (const auto& [comparison, found] : result["comparisons"].items()) {
      const std::uint64_t flips =
          found["false_separation"].get<std::uint64_t>() + found["missed_separation"].get<std::uint64_t>();
      (comparison == "z.above" ? sum.flips_of_z_above : sum.other_flips) += flips;
    }
  }
  return sum;
}

TEST(PointBox, IsListedAfterThePredicatesOfTheProgram) {
  EXPECT_EQ(predicates().front(), &sphere_triangle_predicate());
  EXPECT_EQ(predicates().back(), &point_box_predicate());
  EXPECT_EQ(sphere_triangle_predicate().id, "sphere-triangle");
  EXPECT_EQ(&find_predicate("point-box"), &point_box_predicate());
  EXPECT_EQ(kernels().front().id, "published");
  EXPECT_EQ(&kernels().back(), &find_kernel("point-box/fault"));
  EXPECT_EQ(find_kernel("point-box/strict").predicate, &point_box_predicate());
  EXPECT_EQ(families_of(point_box_predicate()).size(), 2u);
  EXPECT_EQ(families().back(), families_of(point_box_predicate()).back());
  EXPECT_EQ(&oracles_of(point_box_predicate()).predicate(), &point_box_predicate());
  EXPECT_EQ(&oracles_of(sphere_triangle_predicate()).predicate(), &sphere_triangle_predicate());
  EXPECT_THAT(oracles_of(point_box_predicate()).formulae(), ElementsAre("faces"));
}

TEST(PointBox, DepthIsTheDistanceFromTheSurfaceInScenes) {
  const Oracles& oracles = oracles_of(point_box_predicate());
  const auto at = [&](double z) { return Numbers<double>{1, 1, z, 0, 0, 0, 2, 2, 4}; };
  EXPECT_EQ(oracles.truth(at(4)).touching, true);
  EXPECT_EQ(oracles.depth(at(4)), 0);
  EXPECT_EQ(oracles.truth(at(1)).verdict, Verdict::contact);
  EXPECT_EQ(oracles.depth(at(1)), std::sqrt(1.0 / 24));
  EXPECT_EQ(oracles.truth(at(6)).verdict, Verdict::separated);
  EXPECT_EQ(oracles.depth(at(6)), std::sqrt(4.0 / 44));
  EXPECT_EQ(oracles.truth(Numbers<float>{1, 1, 1, 0, 0, 4, 2, 2, 0}).verdict, Verdict::invalid);
}

TEST(PointBox, ACampaignFindsThePlantedFaultAndNoOther) {
  const Json record = toy_record(toy_plan({&find_kernel("point-box/strict"), &find_kernel("point-box/fault")}));
  EXPECT_EQ(record["plan"]["predicate"], "point-box");
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const Json& right = entry_of(record, "point-box/strict", precision);
    const Wrong none = wrong_in(right);
    EXPECT_EQ(none.separations + none.contacts + none.by_implementation + none.flips_of_z_above + none.other_flips, 0u);
    EXPECT_EQ(right["formulae"], "faces");
    EXPECT_EQ(right["reference"], true);
    EXPECT_TRUE(right["arithmetic"].is_null() && right["strictness"].is_null());
    const Json& surface = right["families"]["point-box/surface"];
    EXPECT_EQ(surface["truth"]["touching"], queries_of_each);
    EXPECT_EQ(surface["comparisons"].size(), 6u);
    EXPECT_GE(surface["comparisons"]["z.above"]["ties"].get<std::uint64_t>(), queries_of_each / 6);
    EXPECT_EQ(surface["comparisons"]["z.above"]["max_error_u"], 0.0);
    EXPECT_GT(right["families"]["point-box/general"]["axes"]["x_below"]["sole_separator"].get<std::uint64_t>(), 50u);

    const Wrong found = wrong_in(entry_of(record, "point-box/fault", precision));
    EXPECT_GT(found.separations, 100u);
    EXPECT_GT(found.contacts, 20u);
    EXPECT_EQ(found.by_implementation, found.separations + found.contacts);
    EXPECT_GT(found.flips_of_z_above, 0u);
    EXPECT_EQ(found.other_flips, 0u);
  }
}

TEST(PointBox, AWitnessShowsItsNumbersAndTheComparison) {
  const Json record = toy_record(toy_plan({&find_kernel("point-box/fault")}));
  bool named = false;
  ASSERT_FALSE(record["witnesses"].empty());
  for (const Json& witness : record["witnesses"]) {
    EXPECT_EQ(witness["kernel"], "point-box/fault");
    for (const char* group : {"p", "l", "h"}) EXPECT_EQ(witness[group].size(), 3u) << group;
    EXPECT_TRUE(witness["sides"].is_null());
    for (const Json& flip : witness["flips"]) {
      EXPECT_EQ(flip["links"], Json({"implementation"}));
      named |= flip["name"] == "z.above" && flip["decisive"] == true;
    }
  }
  EXPECT_TRUE(named);
  EXPECT_GT(entry_of(record, "point-box/fault",
                     Precision::binary64)["families"]["point-box/general"]["verdict"]["deepest_false_separation"]
                .get<double>(),
            0.01);
}

TEST(PointBox, AResultDependsOnNoThread) {
  Plan plan = toy_plan({&find_kernel("point-box/fault")});
  plan.questions.trials = [](const Source&, Precision) { return unit_size + 1000; };
  plan.questions.precisions = {Precision::binary32};
  plan.questions.sources.resize(1);
  const std::string with_two = toy_record(plan).dump();
  plan.running.threads = 1;
  EXPECT_EQ(toy_record(plan).dump(), with_two);
}

// A user's program that computes as `kernel` does: it reads the queries and writes its replies.
template <class Real>
std::string replied(const Kernel& kernel, const std::string& queries) {
  pipe::Head head;
  std::memcpy(&head, queries.data(), sizeof head);
  QueryBatch<Real> batch(head.count, 9);
  for (std::size_t i = 0; i < head.count; ++i) {
    Numbers<Real> numbers(9);
    std::memcpy(numbers.data(), queries.data() + head.header_size + i * head.record_size, head.record_size);
    batch.push_back(numbers);
  }
  Reply<Real> reply;
  ask(kernel.on<Real>(scalar_target), batch.columns(), reply);
  std::string bytes = queries.substr(0, head.header_size);
  for (std::size_t i = 0; i < head.count; ++i) {
    const pipe::ReplyRecord record{
        static_cast<std::uint8_t>(reply.verdicts[i]), pipe::has_bits, {}, reply.answers.bits[i]};
    bytes.append(reinterpret_cast<const char*>(&record), sizeof record);
  }
  return bytes;
}

TEST(PointBox, APipedProgramIsJudgedAsTheKernelThatItComputes) {
  const Kernel& fault = find_kernel("point-box/fault");
  Plan plan = toy_plan({&fault});
  plan.questions.precisions = {Precision::binary32};
  const Json built_in = toy_record(plan);

  PipePlan piped{1, Precision::binary32, {}};
  for (const SourcePtr& source : plan.questions.sources) piped.parts.push_back({source, queries_of_each});
  std::string queries;
  write_queries(piped, QueryEncoding::binary, 1, [&](std::string_view bytes) { queries += bytes; });
  std::istringstream in(replied<float>(fault, queries));
  std::vector<ReplyStream> streams;
  streams.push_back(read_replies(in, "replies.bin", {}));
  const Kernel program = [&] {
    Kernel claimed = fault;
    claimed.exposes = Exposure::comparisons;
    return claimed;
  }();
  plan.answerers.kernels = {&program};
  plan.answerers.replies = std::make_shared<const StoredReplies>(std::move(streams));
  plan.questions.sources = plan.answerers.replies->sources();
  const Json judged = toy_record(plan);

  for (const Family* family : families_of(point_box_predicate())) {
    const auto result = [&](const Json& record) {
      return entry_of(record, "point-box/fault", Precision::binary32)["families"][std::string(family->name)];
    };
    const Json before = result(built_in), after = result(judged);
    for (const char* part : {"trials", "truth", "verdict"}) EXPECT_EQ(before[part], after[part]) << part;
    for (const auto& [comparison, counts] : before["comparisons"].items()) {
      for (const char* count : {"false_separation", "missed_separation", "masked", "decisive", "ties", "links"}) {
        EXPECT_EQ(counts[count], after["comparisons"][comparison][count]) << comparison << ' ' << count;
      }
    }
  }
}

TEST(PointBox, ALineOfAQueryReadsBackTheSame) {
  const Family& family = find_family("point-box/surface");
  const StoredQuery query{"q", Precision::binary64, family.make<double>(1, 7), &point_box_predicate()};
  const std::string line = query_line(query);
  EXPECT_THAT(line, HasSubstr(R"("predicate":"point-box")"));
  const std::vector<StoredQuery> read = parse_queries(line, "f", Precision::binary32, predicates());
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].predicate, &point_box_predicate());
  EXPECT_EQ(query_line(read[0]), line);
}

}  // namespace
}  // namespace axiscert
