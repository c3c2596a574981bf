// One kernel in one precision: what it says of itself, and its results.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/cause_record.h"
#include "fuzz/record/family_record.h"
#include "fuzz/record/plan_record.h"
#include "fuzz/record/slack_record.h"
#include "fuzz/text/values.h"
#include "kernel/kernel.h"

namespace axiscert {

// The units of length in which a kernel answers as in that of its queries.

// Exponents of powers of two, by which every length of a query is multiplied.
struct WindowRecord {
  int low = 0, high = 0, scanned_low = 0, scanned_high = 0;
  std::uint64_t queries = 0;

  bool is_whole() const { return low == scanned_low && high == scanned_high; }

  static constexpr std::string_view about =
      "The powers of two times which the kernel answers as at scale 1, on clear queries that this scales exactly. Null "
      "where it was not asked: answers of a program, an interrupted run, a predicate without such queries, a kernel "
      "that "
      "does not give both answers to them.";
  AXISCERT_FIELDS(WindowRecord, AXISCERT_FIELD(low, "From 2^low on, every answer is that of scale 1."),
                  AXISCERT_FIELD(high, "Up to 2^high."), AXISCERT_FIELD(scanned_low, "The least power that was asked."),
                  AXISCERT_FIELD(scanned_high, "The greatest."),
                  AXISCERT_FIELD(queries, "The clear queries, each asked at every power."))
};

struct DigestRecord {
  Name kind;
  Sha256 sha256;

  bool operator==(const DigestRecord&) const = default;
  static constexpr std::string_view about = "The bytes of one file of a kernel.";
  AXISCERT_FIELDS(DigestRecord,
                  AXISCERT_FIELD(kind,
                                 "The part of the kernel that the file is: plugin, its shared object; manifest, "
                                 "program, program-2 and so on, lock: a program's."),
                  AXISCERT_FIELD(sha256, "SHA-256 of the file's bytes."))
};

// Bounds, inclusive; null: none.
struct LimitsRecord {
  std::optional<double> least_coordinate, greatest_coordinate, least_area, least_radius, greatest_radius, margin;
  std::optional<SidesPolicy> sides;

  static constexpr std::string_view about =
      "Bounds, inclusive; null: none. Queries outside are counted in verdict.outside_limits alone.";
  AXISCERT_FIELDS(LimitsRecord,
                  AXISCERT_FIELD(least_coordinate,
                                 "Bound of |x| for each coordinate of A, B, C and P that is not zero."),
                  AXISCERT_FIELD(greatest_coordinate, "Bound of |x| for each coordinate of A, B, C and P."),
                  AXISCERT_FIELD(least_area, "Bound of the triangle's area."),
                  AXISCERT_FIELD(least_radius, "Bound of the sphere's radius."),
                  AXISCERT_FIELD(greatest_radius, "Bound of the sphere's radius."),
                  AXISCERT_FIELD(margin, "A length: either answer is promised where the two are apart by at most this.",
                                 "length"),
                  AXISCERT_FIELD(sides,
                                 "front: only where the centre of the sphere or box is in front of the triangle, (P - "
                                 "A).(AB x AC) > 0. Of motions it stands in `motion`."))
};

struct NearestRecord {
  Name kernel;
  std::uint64_t queries = 0, wrong = 0, both = 0, either = 0;

  static constexpr std::string_view about =
      "For a kernel whose links do not say why it is wrong: the built-in kernel that is wrong on most of the queries "
      "on "
      "which one of the two is wrong, among the first 1024 of each family and the deepest wrong verdicts. Null where "
      "it is "
      "never wrong, or no built-in kernel is where it is; absent for a kernel with a reference.";
  AXISCERT_FIELDS(NearestRecord, AXISCERT_FIELD(kernel, "The built-in kernel."),
                  AXISCERT_FIELD(queries, "Queries on which the two were compared."),
                  AXISCERT_FIELD(wrong, "Those on which the kernel of this entry is wrong."),
                  AXISCERT_FIELD(both, "Those on which both are wrong."),
                  AXISCERT_FIELD(either, "Those on which one of the two is wrong, or both."))
};

struct PolicyRecord {
  StartPolicy start = StartPolicy::reported;
  StillPolicy still = StillPolicy::reported;
  SidesPolicy sides = SidesPolicy::both;

  bool operator==(const PolicyRecord&) const = default;
  static constexpr std::string_view about =
      "What it promises of motions; queries beyond that are counted in verdict.outside_limits. Absent for a predicate "
      "without "
      "measures.";
  AXISCERT_FIELDS(
      PolicyRecord,
      AXISCERT_FIELD(
          start,
          "Of two with a point in common before the motion: contact at time 0; that where they approach; or nothing."),
      AXISCERT_FIELD(still, "Of a displacement of zero."),
      AXISCERT_FIELD(sides, "Triangles that the motion meets from either side, or from the front: D.(AB x AC) < 0."))
};

struct KernelRecord {
  Name id;
  std::optional<Name> name;
  std::optional<std::vector<DigestRecord>> digest;
  Precision precision = Precision::binary32;
  std::string summary;
  std::optional<std::string> formulae, arithmetic;
  std::optional<Strictness> strictness;
  std::optional<bool> reference;
  std::vector<Exposure> exposes;
  TouchingPolicy touching = TouchingPolicy::contact;
  std::optional<LimitsRecord> limits;
  bool may_decline = false;
  CriticalRadiusRecord critical_radius;
  NamedValues<FamilyRecord> families;
  std::optional<std::optional<NearestRecord>> nearest;
  std::optional<std::vector<Name>> measures;
  std::optional<PolicyRecord> motion;
  std::optional<SlacksRecord> slack;
  std::optional<CauseRecord> cause;
  std::optional<WindowRecord> window;

  static constexpr std::string_view about = "One kernel in one precision.";
  AXISCERT_FIELDS(
      KernelRecord, AXISCERT_FIELD(id, "The kernel as given to --kernel, or to judge --as."),
      AXISCERT_FIELD(
          name,
          "The name that a plug-in or program given by its path declares, that of its first kernel: two runs know it "
          "by this name, whatever its path. Null for every other kernel, which is known by its id."),
      AXISCERT_FIELD(digest,
                     "The files of which it consists, which tell whether it was changed: a plug-in has one, a program "
                     "a manifest and what that names. Null where the name is null."),
      AXISCERT_FIELD(precision, "The precision of the queries and of the kernel's arithmetic."),
      AXISCERT_FIELD(summary, "A description of what it computes, in one line."),
      AXISCERT_FIELD(formulae, "The formulae that it claims to compute, judged as its own; null: it claims none."),
      AXISCERT_FIELD(arithmetic,
                     "The arithmetic in which it claims to compute them; null where the formulae are null."),
      AXISCERT_FIELD(strictness, "The relation of its nine side comparisons; null for a kernel without comparisons."),
      AXISCERT_FIELD(reference,
                     "Whether it claims the scalar reference of its formulae bit for bit; false: it evaluates them in "
                     "its own way, and a difference from them is unattributed. Null where the formulae are null."),
      AXISCERT_FIELD(
          exposes,
          "The results that it shows besides its verdict: the comparison bits, and the computed sides of each."),
      AXISCERT_FIELD(touching,
                     "Its intended answer for a sphere that touches the triangle, at distance exactly r; either: "
                     "neither answer is wrong."),
      AXISCERT_FIELD(limits, "The limits within which it promises to be right; null: everywhere."),
      AXISCERT_FIELD(may_decline,
                     "Whether it declares that it may answer `undecided`. Where it does not, such an answer to a valid "
                     "query within its limits stands against every level."),
      AXISCERT_FIELD(critical_radius, "Results over all families."),
      AXISCERT_FIELD(families, "The families that ran, by name."),
      AXISCERT_OPTIONAL_FIELD(nearest, NearestRecord::about),
      AXISCERT_OPTIONAL_FIELD(
          measures,
          "The names of the measures that it gives beside its verdict. Absent for a predicate without measures."),
      AXISCERT_OPTIONAL_FIELD(motion, PolicyRecord::about), AXISCERT_FIELD(slack, SlacksRecord::about),
      AXISCERT_FIELD(cause, CauseRecord::about), AXISCERT_FIELD(window, WindowRecord::about))
};

}  // namespace axiscert
