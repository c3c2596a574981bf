// Queries that a record keeps: witnesses of wrong answers and extremes, and findings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "exact/judge/contact_judgement.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/text/values.h"
#include "kernel/outcome.h"
#include "kernel/names.h"

namespace axiscert {

// A C hex-float, exact in the query's precision.
struct HexRule {
  static constexpr std::size_t longest = 40;
  static constexpr std::string_view pattern = "^(-?0x[01]([.][0-9a-f]+)?p[-+][0-9]+|nan|-?inf)$";
};
using HexNumber = Text<HexRule>;
// At most 17 significant digits.
struct DigitsRule {
  static constexpr std::size_t longest = 40;
  static constexpr std::string_view pattern = "^-?[0-9]+([.][0-9]+)?(e[-+][0-9]+)?$";
};
using Digits = Text<DigitsRule>;
// One 0 or 1 for each comparison of the predicate, in their order.
struct BitsRule {
  static constexpr std::size_t longest = 64;
  static constexpr std::string_view pattern = "^[01]+$";
};
using BitText = Text<BitsRule>;

// One number of a query, or those of a group of columns that belong together: JSON has text or an array of it.
struct GroupNumbers {
  std::vector<HexNumber> numbers;
  bool operator==(const GroupNumbers&) const = default;
};
template <>
struct JsonForm<GroupNumbers> {
  static Json write(const GroupNumbers& value);
  static void read(const JsonPlace& place, GroupNumbers& into);
  static Json schema();
};

struct FlipRecord {
  Level level = Level::verdict;
  Name name;
  FlipKind kind = FlipKind::false_separation;
  bool decisive = false;
  std::vector<Link> links;

  bool operator==(const FlipRecord&) const = default;
  static constexpr std::string_view about =
      "One place where the kernel differs: from the truth at the verdict, from its own exact formulae elsewhere.";
  AXISCERT_FIELDS(FlipRecord, AXISCERT_FIELD(level, "The level at which it shows."),
                  AXISCERT_FIELD(name, "verdict, an axis or a comparison."),
                  AXISCERT_FIELD(kind, "The direction: the kernel wrongly says yes, or wrongly says no."),
                  AXISCERT_FIELD(decisive, "Whether the verdict is wrong because of it; otherwise it is masked."),
                  AXISCERT_FIELD(links, "The links broken here."))
};

struct ExactSidesRecord {
  Digits lhs, rhs, margin;

  AXISCERT_FIELDS(ExactSidesRecord, AXISCERT_FIELD(lhs, "Left side."), AXISCERT_FIELD(rhs, "Right side."),
                  AXISCERT_FIELD(margin, "lhs - rhs, rounded once: not the difference of the two texts."))
};
struct ComputedSidesRecord {
  HexNumber lhs, rhs;

  AXISCERT_FIELDS(ComputedSidesRecord, AXISCERT_FIELD(lhs, "Left side."), AXISCERT_FIELD(rhs, "Right side."))
};
struct SidesRecord {
  std::optional<ExactSidesRecord> exact;
  std::optional<ComputedSidesRecord> computed;
  std::optional<ErrorNumber> lhs_ulps, rhs_ulps, error_u;

  static constexpr std::string_view about = "The sides of one comparison.";
  AXISCERT_FIELDS(
      SidesRecord,
      AXISCERT_FIELD(exact,
                     "The kernel's own formulae in exact arithmetic, to 17 significant digits; null where they are "
                     "undefined (0/0)."),
      AXISCERT_FIELD(computed, "The sides as computed by the kernel; null where it does not show them."),
      AXISCERT_FIELD(lhs_ulps,
                     "|computed - exact| lhs, in ulps of the exact one, rounded up, to 1e-300 where it is less but not "
                     "zero; null: not finite, not shown, or a root.",
                     "ulps"),
      AXISCERT_FIELD(rhs_ulps, "The same for rhs.", "ulps"),
      AXISCERT_FIELD(error_u, "The error of the comparison on this query, as in max_error_u; null where it has none.",
                     "u"))
};

struct MeasuresRecord {
  NamedValues<HexNumber> given;
  std::optional<std::optional<ErrorNumber>> tunnel;
  // Absent together, where nothing of the motion was judged; null each where the kernel does not give it.
  std::optional<std::optional<TimeVerdict>> time;
  std::optional<std::optional<ErrorNumber>> ulps, in_u;
  std::optional<std::optional<double>> share, length, gap;
  // Members of a predicate without motions.
  std::optional<std::optional<Consistency>> consistency;
  std::optional<std::optional<double>> separation_error, separation_length;
  std::optional<std::optional<ErrorNumber>> separation_ulps, separation_u;
  std::optional<std::optional<ErrorNumber>> left;
  std::optional<std::optional<bool>> is_flip;
  // Members of any predicate.
  std::optional<std::optional<bool>> feature_is_right;
  std::optional<std::optional<double>> feature_error, normal_angle, normal_length_error, point_error;
  // Members of a predicate with two such points.
  std::optional<std::optional<double>> point_a_error, point_b_error, points_apart;

  static constexpr std::string_view about =
      "What a kernel said beside its verdict on this query, and how it is wrong. Absent for a predicate without "
      "measures; "
      "null where it gave none, and of motions where it gave none beside a contact, and missed none.";
  AXISCERT_FIELDS(
      MeasuresRecord, AXISCERT_FIELD(given, "The measures by name."),
      AXISCERT_OPTIONAL_FIELD(tunnel, "Of motions: of a late time or a missed contact.", "radii"),
      AXISCERT_OPTIONAL_FIELD(
          time, "What is said of the time: none, invalid, early, best, late; null where the kernel gives no times."),
      AXISCERT_OPTIONAL_FIELD(
          ulps, "The error of an early or late time in units in the last place of the best one, rounded up.", "ulps"),
      AXISCERT_OPTIONAL_FIELD(in_u, "The same in u of the displacement.", "u"),
      AXISCERT_OPTIONAL_FIELD(share, "The error of an early or late time as a share of the way.", "of the way"),
      AXISCERT_OPTIONAL_FIELD(length, "How far the centre then is from where it is at the first contact.", "length"),
      AXISCERT_OPTIONAL_FIELD(gap, "Of an early time, relative to the scene.", "of the scene"),
      AXISCERT_OPTIONAL_FIELD(consistency,
                              "The numbers of the answer against its verdict and each other: consistent, positive, a "
                              "contact with a separation above 0, negative, separated with one below 0, missing, "
                              "without one of them that there is; null where the kernel gives no separation."),
      AXISCERT_OPTIONAL_FIELD(separation_error, "The error of the separation, relative to the scene.", "of the scene"),
      AXISCERT_OPTIONAL_FIELD(separation_length, "The same as a length.", "length"),
      AXISCERT_OPTIONAL_FIELD(separation_ulps,
                              "The same in units in the last place of the number nearest to the exact one, rounded up.",
                              "ulps"),
      AXISCERT_OPTIONAL_FIELD(separation_u, "The same in u of the scene.", "u"),
      AXISCERT_OPTIONAL_FIELD(
          left,
          "What is left of the penetration when the second body is pushed by the exact depth along the normal, as a "
          "share of that depth, rounded up; null where there is no depth or no normal.",
          "of the depth"),
      AXISCERT_OPTIONAL_FIELD(is_flip, "Whether that is a flip: a normal to the other side."),
      AXISCERT_OPTIONAL_FIELD(feature_is_right, "Null where no feature is given."),
      AXISCERT_OPTIONAL_FIELD(feature_error,
                              "Of a wrong feature: how far the centre is beyond the region in which that part is "
                              "nearest, relative to the scene; null where there is none.",
                              "of the scene"),
      AXISCERT_OPTIONAL_FIELD(normal_angle, "In radians; null where it is not judged.", "radians"),
      AXISCERT_OPTIONAL_FIELD(normal_length_error, "The difference of its length from 1; null where it is not judged.",
                              "of its length"),
      AXISCERT_OPTIONAL_FIELD(point_error, "Relative to the scene; null where it is not judged.", "of the scene"),
      AXISCERT_OPTIONAL_FIELD(point_a_error, "How far the first point is from the first body, relative to the scene.",
                              "of the scene"),
      AXISCERT_OPTIONAL_FIELD(point_b_error, "The same of the second.", "of the scene"),
      AXISCERT_OPTIONAL_FIELD(
          points_apart,
          "How far the distance of the two points is from that of the separation from 0, relative to the scene.",
          "of the scene"))
};

// Three numbers: x, y and z.
using PlaceNumbers = std::array<SignedNumber, 3>;

struct ExactContactRecord {
  std::optional<std::optional<HexNumber>> time;
  std::optional<std::optional<std::vector<Name>>> features;
  std::optional<Name> start;
  std::optional<double> after_time;
  std::optional<SignedNumber> separation;
  std::optional<PlaceNumbers> point, point_b, point_from_a;
  std::optional<std::optional<PlaceNumbers>> normal;

  static constexpr std::string_view about =
      "The exact contact: of motions the first, else where the two bodies are nearest, or least parted. Absent where "
      "`measures` are; null where the query is invalid.";
  AXISCERT_FIELDS(
      ExactContactRecord,
      AXISCERT_OPTIONAL_FIELD(time,
                              "Of motions, the best time: the greatest number of the precision that is not late; null "
                              "where there is no contact."),
      AXISCERT_OPTIONAL_FIELD(features,
                              "All parts of the triangle that are nearest to the centre, of motions then; null where "
                              "these have no contact."),
      AXISCERT_OPTIONAL_FIELD(start, "Sphere and triangle before the motion: overlap, touching or clear."),
      AXISCERT_OPTIONAL_FIELD(after_time,
                              "The exact time less the best one. It and what follows is there where motions have "
                              "contact, each number the nearest of binary64."),
      AXISCERT_OPTIONAL_FIELD(separation,
                              "Of a predicate without motions: the distance where the two are apart, less the "
                              "penetration where not. It and the points are absent where beyond binary64."),
      AXISCERT_OPTIONAL_FIELD(point,
                              "The triangle's point that is nearest to the centre, of motions then; of two bodies the "
                              "first's. Absent where it is not the only one."),
      AXISCERT_OPTIONAL_FIELD(point_b, "Of two bodies the second's."),
      AXISCERT_OPTIONAL_FIELD(point_from_a,
                              "The same point less A: rounded after the subtraction, so that it has all its digits "
                              "however far both are from the origin."),
      AXISCERT_OPTIONAL_FIELD(normal,
                              "The unit vector from there to the centre; of two bodies that in which the second is "
                              "pushed. Null where there is none, or more than one."))
};

struct WitnessRecord {
  Name id;
  Precision precision = Precision::binary32;
  NamedValues<GroupNumbers> numbers;  // of the query, by group of columns
  Name kernel, family, address;
  Verdict truth = Verdict::contact, computed = Verdict::contact;
  bool touching = false;
  std::optional<double> depth, length;
  std::optional<InputClass> input_class;
  std::optional<BitText> exact_comparisons, computed_comparisons;
  std::vector<std::string> shows;
  std::vector<FlipRecord> flips;
  std::optional<NamedValues<SidesRecord>> sides;
  std::optional<std::optional<MeasuresRecord>> measures;
  std::optional<std::optional<ExactContactRecord>> exact_contact;

  static constexpr std::string_view about =
      "A query, with one kernel's results on it. The numbers of the query have the names of the groups of columns of "
      "its "
      "predicate.";
  AXISCERT_FIELDS(
      WitnessRecord, AXISCERT_FIELD(id, "Unique in this record."), AXISCERT_FIELD(precision, "Of the query."),
      rest(&Of::numbers), AXISCERT_FIELD(kernel, "The kernel that shows it."),
      AXISCERT_FIELD(family, "The family it came from."),
      AXISCERT_FIELD(address, "The address from which `axiscert query` makes it again."),
      AXISCERT_FIELD(truth, "The geometric truth."), AXISCERT_FIELD(computed, "The kernel's verdict."),
      AXISCERT_FIELD(touching, "Whether the exact distance equals r."),
      AXISCERT_FIELD(depth, "The depth of a wrong verdict; null where the verdict is right.", "of the scene"),
      AXISCERT_OPTIONAL_FIELD(length, "The same as a length, in the queries' unit; absent where there is none.",
                              "length"),
      field(&Of::input_class,
            {.name = "class",
             .about = "The class of the input of a wrong verdict; absent for a kernel without family.classes.",
             .may_be_absent = true}),
      AXISCERT_FIELD(exact_comparisons,
                     "The comparisons of the kernel's own formulae in exact arithmetic, one 0 or 1 each; null where "
                     "there are none."),
      AXISCERT_FIELD(computed_comparisons,
                     "The comparisons as computed by the kernel; null where it does not show them."),
      AXISCERT_FIELD(shows, "The reasons for which it was kept."),
      AXISCERT_FIELD(flips, "Flips in the order verdict, axes, comparisons."),
      AXISCERT_FIELD(sides,
                     "The two sides of each comparison of the axes that flip and of those with the largest error. Null "
                     "where the kernel claims no formulae with comparisons."),
      AXISCERT_OPTIONAL_FIELD(measures, MeasuresRecord::about),
      AXISCERT_OPTIONAL_FIELD(exact_contact, ExactContactRecord::about))
};

struct FindingRecord {
  Name kernel;
  std::optional<Precision> precision;
  std::optional<Name> family;
  FindingKind kind = FindingKind::load;
  std::uint64_t count = 0;
  std::string detail;
  std::optional<Name> address;
  NamedValues<std::optional<GroupNumbers>> numbers;  // of the query, by group of columns

  static constexpr std::string_view about =
      "One kind of fault of a plug-in, other than a wrong answer, on one family; it was found in loading where "
      "precision, "
      "family, address and query are null. The numbers of the query have the names of the groups of columns of its "
      "predicate.";
  AXISCERT_FIELDS(
      FindingRecord, AXISCERT_FIELD(kernel, "The kernel at fault."),
      AXISCERT_FIELD(precision, "The precision in which it occurred; null: in loading."),
      AXISCERT_FIELD(family, "The family on which it occurred; null: in loading."),
      AXISCERT_FIELD(
          kind,
          "load: cannot be loaded, or declares something that cannot be true; abi: made for another version of the "
          "interface; crash: a signal, or the process exited; hang: no answer in time; out_of_bounds: touched memory "
          "next to an array, or wrote to an input; nondeterministic: another answer to the same batch; "
          "batch_dependent: another answer depending on the query's place in the batch; order_dependent: another "
          "answer with the batch in another order, or to the query alone; environment: left the floating-point "
          "environment changed; inconsistent: no verdict, or one that its own comparisons contradict; exchanged: "
          "contact where the two are apart, and separated where they are in contact, nearly everywhere."),
      AXISCERT_FIELD(count, "Number of occurrences."),
      AXISCERT_FIELD(detail, "The observation at the first occurrence."),
      AXISCERT_FIELD(address, "The address of the first query that showed it; null: in loading."), rest(&Of::numbers))
};

}  // namespace axiscert
