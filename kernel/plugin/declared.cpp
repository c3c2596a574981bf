#include "kernel/plugin/declared.h"

#include <fmt/format.h>

#include <cmath>

#include "kernel/base/error.h"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/supervisor.h"

namespace axiscert::plugin {
namespace {

static_assert(most_columns == AXISCERT_MOST_COLUMNS && most_comparisons == AXISCERT_MOST_COMPARISONS &&
              most_measures == AXISCERT_MOST_MEASURES);

template <class Enum>
Enum one_of(std::uint32_t value, std::size_t count, const char* member) {
  if (value >= count) refuse(fmt::format("its {} is {}; known: 0 to {}", member, value, count - 1));
  return static_cast<Enum>(value);
}

bool may_decline(const Description& d) {
  constexpr const char* known = "0, it decides every query; 1, it may answer undecided";
  if (d.may_decline > 1) refuse(fmt::format("its may_decline is {}; known: {}", d.may_decline, known));
  return d.may_decline == 1;
}

// The kernel that a plug-in claims to be like: a built-in one that exists in its precision.
const Kernel& builtin(const char* member, const std::string& id, Precision precision) {
  const Kernel* kernel = nullptr;
  try {
    kernel = &find_kernel(id);
  } catch (const Error&) {
  }
  if (kernel == nullptr || !kernel->file.empty()) {
    refuse(fmt::format("its {} is '{}', which is not a built-in kernel; `axiscert kernels` lists those", member, id));
  }
  if (!kernel->has(precision)) {
    refuse(fmt::format("its {} is '{}', which does not exist in {}", member, id, name(precision)));
  }
  return *kernel;
}

// The check comes first, because nothing else is known of a struct that is too short.
void check_sizes(const Description& d) {
  const auto check = [](const char* of, const char* type, std::size_t size, std::size_t least) {
    if (size < least) {
      refuse(fmt::format("{} has the size {}; sizeof({}) was expected, at least {}", of, size, type, least));
    }
  };
  check("it", "axiscert_kernel", d.size, d.least_size);
  if (d.has_limits) check("its `limits`", "axiscert_limits", d.limits_size, d.least_limits_size);
}

// The predicate and entry of the kernel. Refuses unknown ones, and counts that differ from theirs.
void describe_subject(const Description& d, Kernel& kernel) {
  try {
    kernel.predicate = &predicate_named(printable_line(d.predicate));
    kernel.entry = find_entry(*kernel.predicate, printable_line(d.entry));
  } catch (const Error& unknown) {
    refuse(fmt::format("what it answers: {}; `axiscert predicates` lists them", unknown.what()));
  }
  const PredicateEntry& entry = kernel.predicate->entries[kernel.entry];
  if (d.column_count != entry.columns.size()) {
    refuse(fmt::format("it reads {} columns; predicate '{}' in entry '{}' has {}", d.column_count, kernel.predicate->id,
                       entry.name, entry.columns.size()));
  }
  if (d.measure_count > kernel.predicate->measures.size()) {
    refuse(fmt::format("it gives {} measures; predicate '{}' has {}", d.measure_count, kernel.predicate->id,
                       kernel.predicate->measures.size()));
  }
  kernel.measure_count = d.measure_count;
}

// In a predicate without motions `sides` is a limit; where it has no triangle either, it is refused.
Limits limits_of(const Description& d, const Predicate& predicate) {
  Limits limits{d.limits[0], d.limits[1], d.limits[2], d.limits[3], d.limits[4], d.limits[5]};
  for (const double limit : d.limits) {
    if (!(limit >= 0) || !std::isfinite(limit)) refuse(fmt::format("a limit is {}; known: finite, from 0 on", limit));
  }
  const auto sides = one_of<SidesPolicy>(d.sides, sides_policy_names.size(), "policy for sides");
  if (is_of_motions(predicate) || sides == SidesPolicy::both) return limits;
  if (!predicate.has_front)
    refuse(fmt::format("it declares the sides of a triangle; predicate '{}' has none", predicate.id));
  limits.sides = sides;
  return limits;
}

// Contact from a distance on that is more than 0, and none at 0, is no promise.
void require_touching_within_margin(const Kernel& kernel) {
  if (kernel.limits.margin == 0 || kernel.touching != TouchingPolicy::separated) return;
  refuse(
      fmt::format("it may report contact within a margin of {}, and says that for it touching is 'separated'; known "
                  "with a margin: contact, either",
                  kernel.limits.margin));
}

MotionPolicy motion_of(const Description& d, const Predicate& predicate) {
  MotionPolicy motion{one_of<StartPolicy>(d.start, start_policy_names.size(), "policy for the start"),
                      one_of<StillPolicy>(d.still, still_policy_names.size(), "policy for no motion"),
                      one_of<SidesPolicy>(d.sides, sides_policy_names.size(), "policy for sides")};
  if (!is_of_motions(predicate)) motion.sides = SidesPolicy::both;  // stands among the limits there
  if (motion != MotionPolicy{} && !is_of_motions(predicate))
    refuse(fmt::format("it declares what it promises of motions; predicate '{}' has none", predicate.id));
  return motion;
}

// A kernel claims to compute as another does, and both answer the same question.
void require_same_question(const char* member, const Kernel& own, const Kernel& kernel) {
  if (own.predicate == kernel.predicate && own.entry == kernel.entry) return;
  refuse(fmt::format("its {} is '{}' of the predicate {}, entry {}; it answers {}, entry {}", member, own.id,
                     own.predicate->id, own.predicate->entries[own.entry].name, kernel.predicate->id,
                     kernel.predicate->entries[kernel.entry].name));
}

void claim(const Description& d, Kernel& kernel) {
  const Precision precision = d.precision == 32 ? Precision::binary32 : Precision::binary64;
  kernel.is_reference = d.has_conforms_to;
  if (d.has_conforms_to) {
    const Kernel& own = builtin("conforms_to", printable_line(d.conforms_to), precision);
    kernel.formulae = own.formulae;
    kernel.strictness = own.strictness;
    kernel.arithmetic = own.arithmetic;
    require_same_question("conforms_to", own, kernel);
    if (!own.is_reference) refuse(fmt::format("it conforms_to '{}', whose bits depend on its target", own.id));
  } else if (d.has_formulae || (kernel.exposes != Exposure::verdict && !kernel.predicate->usual_formulae.empty())) {
    const std::string named =
        d.has_formulae ? printable_line(d.formulae) : std::string(kernel.predicate->usual_formulae);
    const Kernel& own = builtin("formulae", named, precision);
    kernel.formulae = own.formulae;
    kernel.strictness = own.strictness;
    require_same_question("formulae", own, kernel);
  }
  if (kernel.is_reference && kernel.touching != TouchingPolicy::contact) {
    refuse(fmt::format("it conforms_to '{}', for which touching is contact, and says that for it touching is '{}'",
                       printable_line(d.conforms_to), name(kernel.touching)));
  }
  if (kernel.exposes != Exposure::verdict && !has_comparisons(kernel)) {
    refuse(
        kernel.predicate->usual_formulae.empty()
            ? fmt::format("it exposes comparisons of {}: give `formulae` or `conforms_to` a built-in kernel of it that "
                          "has comparisons",
                          kernel.predicate->id)
            : fmt::format("it exposes comparisons, but formulae '{}' have none", kernel.formulae));
  }
}

}  // namespace

void refuse(std::string detail) { throw RefusedClaim{FindingKind::load, std::move(detail)}; }

void add_declared(const Description& d, std::uint32_t index, const HostedPlugin& hosted, Kernel& kernel) {
  if (d.abi != AXISCERT_PLUGIN_ABI) {
    throw RefusedClaim{FindingKind::abi,
                       fmt::format("it was made for version {} of the plug-in interface, but this axiscert takes {}: "
                                   "build it again with this axiscert's <axiscert/plugin.h>",
                                   d.abi, AXISCERT_PLUGIN_ABI)};
  }
  check_sizes(d);
  if (d.precision != 32 && d.precision != 64) refuse(fmt::format("its precision is {}; known: 32, 64", d.precision));
  if (!d.has_run) refuse("it has no function `run`");
  if (d.is_truncated) refuse("one of its texts is too long");
  Kernel described;
  describe_subject(d, described);
  described.source = printable_line(d.source);
  described.exposes = one_of<Exposure>(d.exposes, exposure_names.size(), "exposure");
  described.touching = one_of<TouchingPolicy>(d.touching, touching_names.size(), "touching convention");
  described.limits = limits_of(d, *described.predicate);
  require_touching_within_margin(described);
  described.motion = motion_of(d, *described.predicate);
  described.may_decline = may_decline(d);
  described.summary = d.summary[0] != 0 ? fmt::format("{}: {}", printable_line(d.name), printable_line(d.summary))
                                        : printable_line(d.name);
  if (d.name[0] == 0) refuse("it has no name");
  described.declared_name = kernel.declared_name.empty() ? printable_line(d.name) : kernel.declared_name;
  claim(d, described);
  const bool is_first = !kernel.binary32 && !kernel.binary64;
  if (!is_first && (described.exposes != kernel.exposes || described.touching != kernel.touching ||
                    described.limits != kernel.limits || described.motion != kernel.motion ||
                    described.may_decline != kernel.may_decline || described.measure_count != kernel.measure_count ||
                    described.predicate != kernel.predicate || described.entry != kernel.entry ||
                    described.formulae != kernel.formulae || described.strictness != kernel.strictness ||
                    described.arithmetic != kernel.arithmetic || described.is_reference != kernel.is_reference)) {
    refuse("its kernels in binary32 and in binary64 say different things of themselves; make two plug-ins of them");
  }
  const SupervisedKernel supervised{{hosted, index, {described.predicate, described.entry, described.measure_count}},
                                    described.exposes,
                                    described.strictness,
                                    described.measure_count};
  if (d.precision == 32 ? kernel.binary32 != nullptr : kernel.binary64 != nullptr) {
    refuse(fmt::format("it has two kernels of precision {}", d.precision));
  }
  if (d.precision == 32) {
    described.binary32 = [=](std::string_view) { return supervised_implementation<float>(supervised); };
    described.binary64 = kernel.binary64;
  } else {
    described.binary64 = [=](std::string_view) { return supervised_implementation<double>(supervised); };
    described.binary32 = kernel.binary32;
  }
  described.id = kernel.id;
  described.file = kernel.file;
  kernel = std::move(described);
}

}  // namespace axiscert::plugin
