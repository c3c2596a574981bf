// What a compiler made of a form's operations: a planted kernel for each, and
// kernels of which nothing can be said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/diagnosis/made_kernels_testing.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/text/json.h"
#include "kernel/base/environment.h"

namespace axiscert {
namespace {

using namespace made;

diagnosis::ProbeFinding evaluation_of(const Kernel& kernel) {
  DiagnosisOptions options;
  options.target = scalar_target;
  diagnosis::Subject<float> subject(kernel, options);
  return diagnosis::evaluation(subject);
}

// The answers of a built-in kernel, in this environment.
Kernel answering_as(const std::string& id, bool is_flushed = false) {
  return kernel_of("hidden",
                   [inner = find_kernel(id).on<float>(scalar_target), is_flushed](const auto& q, const auto&) {
                     const FloatingEnvironment environment(Rounding::nearest, is_flushed);
                     const auto numbers = coordinates(narrowed(q));
                     QueryBatch<float> batch(1, coordinate_count);
                     Numbers<float> one(coordinate_count);
                     for (std::size_t k = 0; k < coordinate_count; ++k) one[k] = numbers[k];
                     batch.push_back(one);
                     Verdict said = Verdict::unanswered;
                     inner.verdicts(batch.columns(), &said);
                     return said;
                   });
}

// The plane's normal from vertices that were not translated: B - A and C - A as
// their compiler may have them.
Kernel undone_translation() {
  return kernel_of("undone-translation", [](const auto& given, const auto&) {
    const Query<float> q = narrowed(given);
    const Vec3<float> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p, V = cross(q.b - q.a, q.c - q.a);
    const float rr = q.r * q.r, d = dot(A, V);
    const float aa = dot(A, A), ab = dot(A, B), ac = dot(A, C), bb = dot(B, B), bc = dot(B, C), cc = dot(C, C);
    const auto vertex = [&](float square, float one, float other) {
      return square > rr && one >= square && other >= square;
    };
    const auto edge = [&](const Vec3<float>& from, const Vec3<float>& to, const Vec3<float>& along) {
      const Vec3<float> N = cross(from, to);
      return dot(N, N) > rr * dot(along, along) && 0 >= dot(N, V);
    };
    const bool separated = d * d > rr * dot(V, V) || vertex(aa, ab, ac) || vertex(bb, ab, bc) || vertex(cc, ac, bc) ||
                           edge(A, B, q.b - q.a) || edge(B, C, q.c - q.b) || edge(C, A, q.a - q.c);
    return separated ? Verdict::separated : Verdict::contact;
  });
}

TEST(Evaluation, OfEachPlantedCompilerIsTold) {
  const std::vector<std::pair<Kernel, std::string>> planted = {{answering_as("published"), "as_written"},
                                                               {answering_as("reduced-nonstrict"), "as_written"},
                                                               {answering_as("closest-point"), "as_written"},
                                                               {answering_as("published+fma"), "fused"},
                                                               {answering_as("published", true), "flushed"},
                                                               {answering_as("published+up"), "faithful"},
                                                               {answering_as("published+dot-yz-x"), "reassociated"},
                                                               {undone_translation(), "reassociated"},
                                                               {answering_as("published+dot-yz-x", true), "several"}};
  for (const auto& [kernel, value] : planted) {
    const diagnosis::ProbeFinding found = evaluation_of(kernel);
    EXPECT_EQ(found.value, value) << found.sentence << found.measured.dump();
  }
}

// A form without barriers is told what these save. Two boxes have nothing that is translated.
TEST(Evaluation, WhatAShaderMissesWithoutBarriersIsTold) {
  const auto misses = [](const char* id) {
    const Json measured = evaluation_of(find_kernel(id)).measured["shader_misses"];
    return std::pair(measured["without_barriers"].get<double>(), measured["behind_barriers"].get<double>());
  };
  const auto [without, behind] = misses("reduced-nonstrict");
  EXPECT_GT(without, 1e-3);
  EXPECT_LT(behind, 1e-5);
  EXPECT_GT(behind, 0);
  EXPECT_EQ(misses("box-box/cofactor").first, misses("box-box/cofactor").second);
  EXPECT_THAT(evaluation_of(find_kernel("closest-point")).sentence, testing::HasSubstr("behind barriers"));
}

TEST(Evaluation, OfAnotherPredicateIsTold) {
  EXPECT_EQ(evaluation_of(find_kernel("moving-sphere/twenty-nonstrict")).value, "as_written");
  EXPECT_EQ(evaluation_of(find_kernel("box-box/cofactor")).value, "as_written");
}

TEST(Evaluation, OfWhatIsNoFormIsNotKnown) {
  EXPECT_EQ(evaluation_of(find_kernel("certified")).value, not_known);
  EXPECT_EQ(evaluation_of(find_kernel("conservative")).value, not_known);
  EXPECT_EQ(evaluation_of(find_kernel("first-publication")).value,
            "as_written");  // a form, whatever it answers
}

}  // namespace
}  // namespace axiscert
