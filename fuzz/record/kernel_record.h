// One kernel in one precision: what it says of itself, and its results.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/cause_record.h"
#include "fuzz/record/family_record.h"
#include "fuzz/record/plan_record.h"
#include "fuzz/record/slack_record.h"
#include "fuzz/record/window_record.h"
#include "kernel/kernel.h"

namespace axiscert {

struct DigestRecord {
  Name kind;
  Sha256 sha256;

  bool operator==(const DigestRecord&) const = default;
  static constexpr std::string_view about = "The bytes of one file of a kernel.";
  static constexpr auto fields(auto&& visit) {
    return visit(
        field(&DigestRecord::kind,
              {"kind",
               "The part of the kernel that the file is: plugin, its shared object; manifest, program, program-2 "
               "and so on, lock: a program's."}),
        field(&DigestRecord::sha256, {"sha256", "SHA-256 of the file's bytes."}));
  }
};

// Bounds, inclusive; null: none.
struct LimitsRecord {
  std::optional<double> least_coordinate, greatest_coordinate, least_area, least_radius, greatest_radius, margin;
  std::optional<SidesPolicy> sides;

  static constexpr std::string_view about =
      "Bounds, inclusive; null: none. Queries outside are counted in verdict.outside_limits alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = LimitsRecord;
    return visit(
        field(&Of::least_coordinate,
              {"least_coordinate", "Bound of |x| for each coordinate of A, B, C and P that is not zero."}),
        field(&Of::greatest_coordinate, {"greatest_coordinate", "Bound of |x| for each coordinate of A, B, C and P."}),
        field(&Of::least_area, {"least_area", "Bound of the triangle's area."}),
        field(&Of::least_radius, {"least_radius", "Bound of the sphere's radius."}),
        field(&Of::greatest_radius, {"greatest_radius", "Bound of the sphere's radius."}),
        field(&Of::margin,
              {"margin", "A length: either answer is promised where the two are apart by at most this.", "length"}),
        field(&Of::sides,
              {"sides",
               "front: only where the centre of the sphere or box is in front of the triangle, (P - A).(AB x AC) > 0. "
               "Of motions it stands in `motion`."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = NearestRecord;
    return visit(field(&Of::kernel, {"kernel", "The built-in kernel."}),
                 field(&Of::queries, {"queries", "Queries on which the two were compared."}),
                 field(&Of::wrong, {"wrong", "Those on which the kernel of this entry is wrong."}),
                 field(&Of::both, {"both", "Those on which both are wrong."}),
                 field(&Of::either, {"either", "Those on which one of the two is wrong, or both."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = PolicyRecord;
    return visit(
        field(&Of::start,
              {"start",
               "Of two with a point in common before the motion: contact at time 0; that where they approach; or "
               "nothing."}),
        field(&Of::still, {"still", "Of a displacement of zero."}),
        field(&Of::sides,
              {"sides", "Triangles that the motion meets from either side, or from the front: D.(AB x AC) < 0."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = KernelRecord;
    return visit(
        field(&Of::id, {"id", "The kernel as given to --kernel, or to judge --as."}),
        field(&Of::name, {"name",
                          "The name that a plug-in or program given by its path declares, that of its first kernel: "
                          "two runs know it "
                          "by this name, whatever its path. Null for every other kernel, which is known by its id."}),
        field(&Of::digest, {"digest",
                            "The files of which it consists, which tell whether it was changed: a plug-in has one, a "
                            "program a manifest "
                            "and what that names. Null where the name is null."}),
        field(&Of::precision, {"precision", "The precision of the queries and of the kernel's arithmetic."}),
        field(&Of::summary, {"summary", "A description of what it computes, in one line."}),
        field(&Of::formulae,
              {"formulae", "The formulae that it claims to compute, judged as its own; null: it claims none."}),
        field(&Of::arithmetic,
              {"arithmetic", "The arithmetic in which it claims to compute them; null where the formulae are null."}),
        field(&Of::strictness,
              {"strictness", "The relation of its nine side comparisons; null for a kernel without comparisons."}),
        field(
            &Of::reference,
            {"reference",
             "Whether it claims the scalar reference of its formulae bit for bit; false: it evaluates them in its own "
             "way, and a difference from them is unattributed. Null where the formulae are null."}),
        field(&Of::exposes,
              {"exposes",
               "The results that it shows besides its verdict: the comparison bits, and the computed sides of each."}),
        field(&Of::touching, {"touching",
                              "Its intended answer for a sphere that touches the triangle, at distance exactly r; "
                              "either: neither answer "
                              "is wrong."}),
        field(&Of::limits, {"limits", "The limits within which it promises to be right; null: everywhere."}),
        field(&Of::may_decline,
              {"may_decline",
               "Whether it declares that it may answer `undecided`. Where it does not, such an answer to a valid query "
               "within its limits stands against every level."}),
        field(&Of::critical_radius, {"critical_radius", "Results over all families."}),
        field(&Of::families, {"families", "The families that ran, by name."}),
        field(&Of::nearest, {.name = "nearest", .about = NearestRecord::about, .may_be_absent = true}),
        field(
            &Of::measures,
            {.name = "measures",
             .about =
                 "The names of the measures that it gives beside its verdict. Absent for a predicate without measures.",
             .may_be_absent = true}),
        field(&Of::motion, {.name = "motion", .about = PolicyRecord::about, .may_be_absent = true}),
        field(&Of::slack, {"slack", SlacksRecord::about}), field(&Of::cause, {"cause", CauseRecord::about}),
        field(&Of::window, {"window", WindowRecord::about}));
  }
};

}  // namespace axiscert
