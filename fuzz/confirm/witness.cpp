#include "fuzz/confirm/witness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/judge/oracles.h"
#include "fuzz/files/query_object.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"

namespace axiscert {
namespace {

ErrorNumber error_number(const Decimal6& decimal) { return read_as<ErrorNumber>(json_of(decimal)); }

std::optional<ErrorNumber> depth_of(const std::optional<Tunnel>& tunnel) {
  return tunnel ? std::optional(error_number(tunnel->depth)) : std::nullopt;
}

PlaceNumbers place_numbers(const std::array<double, 3>& at) {
  return {SignedNumber{at[0]}, SignedNumber{at[1]}, SignedNumber{at[2]}};
}

}  // namespace

namespace {

void put_motion(MeasuresRecord& record, const ContactJudgement& contact) {
  record.tunnel.emplace(depth_of(contact.missed ? contact.missed : contact.tunnel));
  if (contact.missed) return;
  const bool is_off = contact.time == TimeVerdict::early || contact.time == TimeVerdict::late;
  record.time.emplace(contact.time);
  record.ulps.emplace(is_off ? std::optional(error_number(contact.ulps)) : std::nullopt);
  record.in_u.emplace(is_off ? std::optional(error_number(contact.in_u)) : std::nullopt);
  record.share.emplace(is_off ? std::optional(contact.share) : std::nullopt);
  record.length.emplace(is_off ? std::optional(contact.length) : std::nullopt);
  record.gap.emplace(contact.time == TimeVerdict::early ? std::optional(contact.gap) : std::nullopt);
}

void put_bodies(MeasuresRecord& record, const Predicate& predicate, const ContactJudgement& contact) {
  const std::optional<SeparationError>& error = contact.separation;
  record.consistency.emplace(contact.consistency);
  record.separation_error.emplace(error ? std::optional(error->share) : std::nullopt);
  record.separation_length.emplace(error ? std::optional(error->length) : std::nullopt);
  record.separation_ulps.emplace(error ? std::optional(error_number(error->ulps)) : std::nullopt);
  record.separation_u.emplace(error ? std::optional(error_number(error->in_u)) : std::nullopt);
  record.left.emplace(contact.pushed ? std::optional(error_number(contact.pushed->left)) : std::nullopt);
  record.is_flip.emplace(contact.pushed ? std::optional(contact.pushed->is_flip) : std::nullopt);
  if (!has_measure(predicate, MeasureKind::point_b)) return;
  record.point_a_error.emplace(contact.point_a_error);
  record.point_b_error.emplace(contact.point_b_error);
  record.points_apart.emplace(contact.points_apart);
}

}  // namespace

std::optional<MeasuresRecord> measures_of(const Predicate& predicate, const Examination& found) {
  const bool moves = is_of_motions(predicate), is_missed = found.contact && found.contact->missed;
  const bool is_given =
      !found.measures.empty() && (moves ? found.answer.verdict == Verdict::contact : found.contact.has_value());
  if (!is_given && !is_missed) return std::nullopt;
  MeasuresRecord record;
  for (std::size_t k = 0; is_given && k < found.measures.size(); ++k) {
    record.given.put(predicate.measures[k].name) = format_number(found.measures[k]);
  }
  if (moves && !found.contact) record.tunnel.emplace();
  if (!found.contact) return record;
  const ContactJudgement& contact = *found.contact;
  if (moves) put_motion(record, contact);
  else put_bodies(record, predicate, contact);
  if (is_missed) return record;
  if (has_measure(predicate, MeasureKind::feature)) {
    record.feature_is_right.emplace(contact.feature_is_right);
    const bool is_finite = contact.feature_error && std::isfinite(*contact.feature_error);
    record.feature_error.emplace(is_finite ? contact.feature_error : std::nullopt);
  }
  record.normal_angle.emplace(contact.normal_angle);
  record.normal_length_error.emplace(contact.normal_length_error);
  if (has_measure(predicate, MeasureKind::point)) record.point_error.emplace(contact.point_error);
  return record;
}

template <class Real>
std::optional<ExactContactRecord> exact_contact_of(const Oracles& oracles, const Truth& truth,
                                                   const Numbers<Real>& numbers) {
  if (truth.verdict == Verdict::invalid) return std::nullopt;
  const Predicate& predicate = oracles.predicate();
  ExactContactRecord record;
  if (is_of_motions(predicate)) {
    Json details = Json::object();
    for (const Detail& detail : oracles.details(numbers)) details[std::string(detail.name)] = detail_json(detail);
    record = read_as<ExactContactRecord>(details);
    if (truth.verdict != Verdict::contact) return record;
  } else if (const NearestFeatures* const features = capabilities_of(predicate).nearest_features) {
    std::vector<Name> names;
    for (const std::string_view name : features->of(numbers)) names.push_back(name);
    record.features.emplace(std::move(names));
  }
  const std::unique_ptr<ContactJudge> judge = oracles.contact_judge(numbers);
  if (judge == nullptr) return record;
  const ContactPlace place = judge->place();
  record.after_time = place.after_best;
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (place.separation && is_finite(*place.separation)) record.separation = SignedNumber{*place.separation};
  const auto put = [&](std::optional<PlaceNumbers>& into, const std::optional<std::array<double, 3>>& at) {
    if (at && std::ranges::all_of(*at, is_finite)) into = place_numbers(*at);
  };
  put(record.point, place.point);
  put(record.point_b, place.point_b);
  put(record.point_from_a, place.from_a);
  record.normal.emplace(place.normal ? std::optional(place_numbers(*place.normal)) : std::nullopt);
  return record;
}
template std::optional<ExactContactRecord> exact_contact_of(const Oracles&, const Truth&, const Numbers<float>&);
template std::optional<ExactContactRecord> exact_contact_of(const Oracles&, const Truth&, const Numbers<double>&);

namespace {

// The class of a query with a wrong verdict, which was counted as this one if as any. Throws OracleDisagreement.
template <class Real>
InputClass class_of_wrong(const Predicate& predicate, const Numbers<Real>& numbers, std::optional<InputClass> counted) {
  const std::string_view found = capabilities_of(predicate).input_classes->of(numbers).front();
  for (const InputClass which : enumerators<InputClass>) {
    if (name(which) == found && counted.value_or(which) == which) return which;
  }
  throw OracleDisagreement(
      fmt::format("the input was counted as {}, and is {}", counted ? name(*counted) : "none", found), numbers,
      predicate);
}

}  // namespace

template <class Real>
NamedValues<GroupNumbers> groups_of_numbers(const PredicateEntry& entry, const Numbers<Real>& numbers) {
  NamedValues<GroupNumbers> groups;
  for (const auto& [name, first, size] : groups_of(entry)) {
    for (std::size_t k = first; k < first + size; ++k) groups.put(name).numbers.push_back(format_number(numbers[k]));
  }
  return groups;
}
template NamedValues<GroupNumbers> groups_of_numbers<float>(const PredicateEntry&, const Numbers<float>&);
template NamedValues<GroupNumbers> groups_of_numbers<double>(const PredicateEntry&, const Numbers<double>&);

std::vector<FlipRecord> flips_of(const Predicate& predicate, const Judgement& judgement) {
  std::vector<FlipRecord> flips;
  for (const Flip& flip : judgement.flips()) {
    flips.push_back(
        {flip.level, name(predicate, flip), flip.kind, flip.decisive, {flip.links.begin(), flip.links.end()}});
  }
  return flips;
}

void WitnessWriter::add(const Kernel& kernel, const SeededSource& of, const Tally& tally,
                        const std::optional<Asymmetry>& asymmetry) {
  ShownReasons shown;
  const auto note = [&](const auto& leaders, auto&& what) {
    for (const auto& candidate : leaders.candidates()) shown[candidate.position].texts.push_back(what(candidate));
  };
  note(tally.verdict.deepest_false_separation, [](const auto&) { return "deepest false_separation"; });
  note(tally.verdict.deepest_false_contact, [](const auto&) { return "deepest false_contact"; });
  note(tally.verdict.farthest_false_separation, [](const auto&) { return "farthest false_separation"; });
  note(tally.verdict.farthest_false_contact, [](const auto&) { return "farthest false_contact"; });
  for (std::size_t i = 0; i < link_count; ++i) {
    note(tally.verdict.deepest_by_link[i],
         [i](const auto&) { return fmt::format("deepest wrong verdict with a broken {} link", link_names[i]); });
  }
  note(tally.verdict.clear->first_missed, [](const auto&) { return "first false_separation on a clear query"; });
  note(tally.verdict.clear->first_phantom, [](const auto&) { return "first false_contact on a clear query"; });
  for (const InputClass which : enumerators<InputClass>) {
    note(tally.classes.classes[which].deepest, [which](const auto&) {
      return fmt::format("deepest wrong verdict on input of class {}", input_class_names[which]);
    });
    for (const auto& candidate : tally.classes.classes[which].deepest.candidates()) {
      shown[candidate.position].input_class = which;
    }
  }
  const Predicate& predicate = *kernel.predicate;
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    const ComparisonTally& comparison = tally.comparisons[i];
    const auto flip = [&](const char* kind) {
      return [&predicate, kind, i](const Candidate<bool>& c) {
        return fmt::format("{} {} of {}", c.rank ? "decisive" : "masked", kind, predicate.comparisons[i].name);
      };
    };
    note(comparison.false_witness, flip("false_separation"));
    note(comparison.missed_witness, flip("missed_separation"));
    note(comparison.largest_error, [&predicate, i](const Candidate<Decimal6>& c) {
      return fmt::format("largest error of {}: {} u", predicate.comparisons[i].name, c.rank.text());
    });
    for (const auto& candidate : comparison.largest_error.candidates()) {
      shown[candidate.position].largest_errors |= one_bit<ComparisonBits>(i);
    }
  }
  note_contacts(tally.contacts, shown);
  if (asymmetry) add_pairs(of, *asymmetry, shown);
  if (!examiner_ || &examiner_->kernel() != &kernel) examiner_.emplace(kernel, target_);
  if (of.precision == Precision::binary32) write<float>(kernel, of, shown);
  else write<double>(kernel, of, shown);
}

void WitnessWriter::add_pairs(const SeededSource& of, const Asymmetry& asymmetry, ShownReasons& shown) {
  const auto note = [&](const std::optional<ImagePair>& pair, auto&& of_base, auto&& of_image) {
    if (!pair) return;
    shown[pair->base].texts.push_back(of_base(of.address(pair->image)));
    shown[pair->image].texts.push_back(of_image(of.address(pair->base)));
  };
  const auto note_difference = [&](const std::optional<ImagePair>& pair, const std::string& what) {
    note(
        pair,
        [&](const std::string& image) {
          return fmt::format("asymmetry: another {} than of its image {}", what, image);
        },
        [&](const std::string& base) { return fmt::format("asymmetry: another {} than of its base {}", what, base); });
  };
  note_difference(asymmetry.first_verdict, "verdict");
  note_difference(asymmetry.first_comparison, "comparison");
  const Invariance& invariance = asymmetry.invariance;
  for (const ImageKind kind : enumerators<ImageKind>) {
    note_difference(invariance.kinds[kind].first, fmt::format("verdict by {}", image_kind_names[kind]));
  }
  const ImageChanges& wrong = invariance.units.wrong;
  note(
      wrong.first,
      [&](const std::string& image) {
        return fmt::format("right, and wrong times 2^{}: its image {}", wrong.first_size, image);
      },
      [&](const std::string& base) {
        return fmt::format("wrong times 2^{} of its base {}, which is right", wrong.first_size, base);
      });
}

void WitnessWriter::note_contacts(const ContactTally& contacts, ShownReasons& shown) {
  const auto note = [&](const auto& leaders, auto&& what) {
    for (const auto& candidate : leaders.candidates()) shown[candidate.position].texts.push_back(what(candidate.rank));
  };
  const auto worst = [](const char* what, const char* unit) {
    return [=](const Decimal6& size) { return fmt::format("{}: {}{}", what, size.text(), unit); };
  };
  const auto largest = [](const char* what, const char* unit) {
    return [=](double size) { return fmt::format("{}: {:.6g}{}", what, size, unit); };
  };
  // More ulps than say anything are left out; the number stands in the witness.
  const auto note_errors = [&](const TimeErrors& errors, const char* what) {
    note(errors.largest_ulps, [what](const Decimal6& ulps) {
      return is_told_in_ulps(ulps) ? fmt::format("{}: {} ulps", what, ulps.text()) : fmt::format("{} in ulps", what);
    });
    note(errors.largest_in_u, worst(what, " u of the displacement"));
    note(errors.largest_share, largest(what, " of the way"));
    note(errors.largest_length, largest(what, " in length"));
  };
  if (const auto& time = contacts.time) {
    note(time->no_time, [](bool given) { return given ? "a time outside [0, 1]" : "a contact without a time"; });
    note_errors(time->late_errors, "latest time");
    note(time->late_tunnels.deepest, worst("deepest tunnel of a late time", ""));
  }
  if (contacts.missed) note(contacts.missed->deepest, worst("deepest tunnel of a missed contact", ""));
  if (const auto& time = contacts.time) {
    note_errors(time->early_errors, "earliest time");
    note(time->largest_gap, largest("largest gap of an early time", " of the scene"));
  }
  if (contacts.consistency) {
    for (const Consistency which : enumerators<Consistency>) {
      note(contacts.consistency->first[which], [which](bool) { return std::string(consistency_words[which]); });
    }
  }
  // Those of motions fail nothing: a rounding may take one for an overlap at the start.
  const auto note_missing = [&](const auto& part, std::string_view what) {
    if (part && !contacts.missed) note(part->first_none, [what](bool) { return missing_texts::of_answer(what); });
  };
  note_missing(contacts.separation, missing_texts::separation);
  note_missing(contacts.feature, missing_texts::feature);
  note_missing(contacts.normal, missing_texts::normal);
  note_missing(contacts.pushed, missing_texts::push);
  note_missing(contacts.point ? contacts.point : contacts.point_a, missing_texts::point);
  if (const auto& separation = contacts.separation) {
    note(separation->largest_error, largest("largest error of a separation", " of the scene"));
    note(separation->largest_length, largest("largest error of a separation", " in length"));
    note(separation->largest_ulps, worst("largest error of a separation", " ulps"));
    note(separation->largest_in_u, worst("largest error of a separation", " u of the scene"));
  }
  if (const auto& feature = contacts.feature) {
    note(feature->first_wrong, [](bool) { return "a wrong feature"; });
    note(feature->largest_error, largest("wrong feature farthest from its region", " of the scene"));
  }
  if (const auto& normal = contacts.normal) {
    note(normal->largest_angle, largest("largest angle of a normal", " radians"));
    note(normal->largest_length_error, largest("largest error of a normal's length", ""));
  }
  if (const auto& pushed = contacts.pushed) {
    note(pushed->first_flip, [](bool) { return "a normal to the other side"; });
    note(pushed->largest_left, worst("most penetration left along a normal", " of the depth"));
  }
  const auto note_points = [&](const auto& points, const char* what) {
    if (points) note(points->largest_error, largest(what, " of the scene"));
  };
  note_points(contacts.point, "largest error of a contact's point");
  note_points(contacts.point_a, "largest error of the first point");
  note_points(contacts.point_b, "largest error of the second point");
  note_points(contacts.points, "largest difference between points and separation");
}

template <class Real>
Examination WitnessWriter::examined(const Kernel& kernel, const Source& source, std::uint64_t position,
                                    const Numbers<Real>& numbers) {
  if (!replies_) return examiner_->examine(numbers);
  const Answer reply = replies_->at(source, precision_of<Real>, position);
  return examine(numbers, kernel, reply, replies_->measures(source, precision_of<Real>, position));
}

template <class Real>
void WitnessWriter::write(const Kernel& kernel, const SeededSource& of, const ShownReasons& shown) {
  const Source& source = of.source;
  const Predicate& predicate = *kernel.predicate;
  const WitnessSides* const sides = capabilities_of(predicate).witness_sides;
  for (const auto& [position, what] : shown) {
    const Numbers<Real> numbers = source.make<Real>(of.seed, position);
    const Examination found = examined(kernel, source, position, numbers);
    WitnessRecord& witness = witnesses_.emplace_back();
    witness.id = fmt::format("w{}", witnesses_.size());
    witness.precision = precision_of<Real>;
    witness.numbers = groups_of_numbers(source.predicate().entries[source.entry()], numbers);
    witness.kernel = kernel.id;
    witness.family = source.name();
    witness.address = of.address(position);
    witness.truth = found.truth.verdict;
    witness.computed = found.answer.verdict;
    witness.touching = found.truth.touching;
    witness.depth = found.depth;
    witness.length = found.length;
    if (has_input_classes(kernel) && found.judgement.verdict_flip) {
      witness.input_class = class_of_wrong(predicate, numbers, what.input_class);
    }
    const auto bits = [&](const std::optional<ComparisonBits>& all) {
      return all ? std::optional(BitText(bit_string(*all, predicate.comparisons.size()))) : std::nullopt;
    };
    witness.exact_comparisons = bits(found.judgement.exact);
    witness.computed_comparisons = bits(found.answer.bits);
    witness.shows = what.texts;
    witness.flips = flips_of(predicate, found.judgement);
    if (sides != nullptr) witness.sides = sides->of(numbers, kernel, found, what.largest_errors);
    if (says_contacts(kernel)) {
      witness.measures.emplace(measures_of(predicate, found));
      witness.exact_contact.emplace(exact_contact_of(oracles_of(predicate, source.entry()), found.truth, numbers));
    }
  }
}

}  // namespace axiscert
