#include "kernel/plugin/supervisor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "kernel/plugin/caller.h"

namespace axiscert::plugin {
namespace {

constexpr std::uint8_t filling = 0xa5, other_filling = 0x5a;  // neither is a verdict
constexpr std::uint64_t rearranged_every = 8;                 // chunks

constexpr std::uint64_t batches_of_unit = 64;  // of a full one: the second that is reordered is one of these

// A batch in pieces of every length up to two vectors of sixteen lanes and one more, so that each query comes to other
// lanes and other alignments, the last of a ragged batch among them.
constexpr std::size_t longest_piece = 33;
constexpr Placement piece_placements[] = {{Anchor::begin, 0}, {Anchor::end, 0},    {Anchor::middle, 1},
                                          {Anchor::begin, 3}, {Anchor::middle, 2}, {Anchor::end, 0},
                                          {Anchor::middle, 5}};

// A program knows no lanes, and each piece may be a start: 1, 2, 4, ... queries.
std::size_t piece_size(std::size_t number, bool is_program) {
  return is_program ? std::size_t{1} << std::min<std::size_t>(number, 10) : 1 + number % longest_piece;
}

double seconds_for(std::size_t queries) {
  return batch_seconds * std::max(0.1, static_cast<double>(queries) / static_cast<double>(batch_capacity));
}

std::string placement_text(const Placement& placement) {
  if (placement.anchor == Anchor::end) return "arrays ending with a page";
  if (placement.shift == 0) return "arrays beginning with a page";
  return fmt::format("arrays {} past an alignment of 64 bytes",
                     placement.shift == 1 ? "1 entry" : fmt::format("{} entries", placement.shift));
}

}  // namespace

// A part of a batch that one call can take, and where what is learned of it goes.
template <class Real>
struct Supervisor<Real>::Chunk {
  const QueryColumns<Real>& batch;
  Verdict* out;
  Answers<Real>* explained;  // null: not asked
  Watched* watched;          // null: the answers alone
  std::size_t first, size;

  Chunk part(std::size_t from, std::size_t count) const {
    return {batch, out, explained, watched, first + from, count};
  }
};

template <class Real>
Arrangement Supervisor<Real>::whole(const Chunk& chunk, std::uint8_t with) const {
  if (!chunk.explained) return {{anchor_}, Exposure::verdict, 0, with};
  return {{anchor_}, kernel_.exposes, kernel_.measures, with};
}

template <class Real>
auto Supervisor<Real>::ask(const Chunk& chunk, const Arrangement& arrangement, Outputs<Real>& outputs) -> Result {
  Result result = caller_.call(chunk.batch, chunk.first, chunk.size, arrangement, seconds_for(chunk.size), outputs);
  if (result.stop && (!is_program() || (result.stop->kind == FindingKind::hang && chunk.size > 1))) ++stops_;
  nanoseconds_ += static_cast<double>(result.reply.nanoseconds);
  return result;
}

template <class Real>
void Supervisor<Real>::tell(const Chunk& chunk, FindingKind kind, std::size_t query, std::string detail) {
  const bool is_stop = kind == FindingKind::crash || kind == FindingKind::hang;
  if (!chunk.watched || (told_.contains(kind) && !is_stop)) return;
  told_.insert(kind);
  chunk.watched->findings.push_back({kind, chunk.first + query, std::move(detail)});
}

template <class Real>
void Supervisor<Real>::tell(const Chunk& chunk, const Stop& stop, const std::string& where) {
  if (is_program() && (stop.kind != FindingKind::hang || chunk.size == 1)) ++stops_;
  tell(chunk, stop.kind, stop.query.value_or(0), stop.detail + where);
}

template <class Real>
void Supervisor<Real>::leave_unanswered(const Chunk& chunk) {
  std::fill_n(chunk.out + chunk.first, chunk.size, Verdict::unanswered);
}

template <class Real>
void Supervisor<Real>::take(const Chunk& chunk, const Outputs<Real>& outputs) {
  std::transform(outputs.verdicts.begin(), outputs.verdicts.end(), chunk.out + chunk.first, [](std::uint8_t verdict) {
    return is_verdict(verdict) ? static_cast<Verdict>(verdict) : Verdict::unanswered;
  });
  if (!chunk.explained) return;
  const auto put = [&](const auto& from, auto& to) {
    std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(chunk.first));
  };
  put(outputs.bits, chunk.explained->bits);
  for (std::size_t k = 0; k < outputs.lhs.size(); ++k) {
    put(outputs.lhs[k], chunk.explained->lhs[k]);
    put(outputs.rhs[k], chunk.explained->rhs[k]);
  }
  for (std::size_t k = 0; k < outputs.measures.size(); ++k) put(outputs.measures[k], chunk.explained->measures[k]);
}

template <class Real>
void Supervisor<Real>::run_chunk(const Chunk& chunk) {
  if (stops_ >= most_stops) return leave_unanswered(chunk);
  Outputs<Real> outputs;
  Result result = ask(chunk, whole(chunk, filling), outputs);
  if (result.stop && result.stop->kind == FindingKind::out_of_bounds && anchor_ == Anchor::end) {
    // With room around its arrays it may yet answer.
    tell(chunk, *result.stop);
    anchor_ = Anchor::middle;
    result = ask(chunk, whole(chunk, filling), outputs);
  }
  if (result.stop) {
    if (chunk.size > 1) return is_program() ? run_parts(chunk, *result.stop) : run_singly(chunk, *result.stop);
    tell(chunk, *result.stop);
    return leave_unanswered(chunk);
  }
  take(chunk, outputs);
  if (!chunk.watched) return;
  if (result.stray) tell(chunk, *result.stray);
  if (result.reply.changed != 0) look_for_changed_environment(chunk, result.reply.changed);
  if (repeats(chunk, outputs) && chunk.size > 1) {
    if (chunks_ % rearranged_every == 0) rearrange(chunk, outputs);
    if (is_to_be_reordered(chunk)) reorder(chunk, outputs);
  }
  chunks_ += chunk.size > 1;
  look_for_contradictions(chunk, outputs);
}

template <class Real>
void Supervisor<Real>::run_singly(const Chunk& chunk, const Stop& of_batch) {
  asks_singly_ = true;
  const int stops = stops_;
  for (std::size_t i = 0; i < chunk.size; ++i) run_chunk(chunk.part(i, 1));
  if (stops_ == stops && stops < most_stops) {
    tell(chunk, of_batch, fmt::format(" for a batch of {}; none for its queries one by one", chunk.size));
  }
}

// The query without a reply comes first, by itself: it may be the one, if the program does not keep its replies back.
// Where it is not, the batch is halved.
template <class Real>
void Supervisor<Real>::run_parts(const Chunk& chunk, const Stop& of_batch) {
  const int stops = stops_;
  const std::size_t suspect = of_batch.query.value_or(0);
  if (suspect > 0 && suspect < chunk.size) {
    run_chunk(chunk.part(suspect, 1));
    run_chunk(chunk.part(0, suspect));
    if (suspect + 1 < chunk.size) run_chunk(chunk.part(suspect + 1, chunk.size - suspect - 1));
  } else {
    const std::size_t half = chunk.size / 2;
    run_chunk(chunk.part(0, half));
    run_chunk(chunk.part(half, chunk.size - half));
  }
  if (stops_ == stops && stops < most_stops) {
    tell(chunk, of_batch, fmt::format(" for a batch of {}; none for its parts", chunk.size));
  }
}

template <class Real>
bool Supervisor<Real>::repeats(const Chunk& chunk, const Outputs<Real>& outputs) {
  Outputs<Real> again;
  const Result result = ask(chunk, whole(chunk, other_filling), again);
  if (result.stop) {
    tell(chunk, *result.stop, ", asked the same again");
    return false;
  }
  for (std::size_t i = 0; i < chunk.size; ++i) {
    if (outputs.verdicts[i] != filling || again.verdicts[i] != other_filling) continue;
    tell(chunk, FindingKind::inconsistent, i, "it wrote no verdict");
    return false;
  }
  const auto difference = first_difference(*kernel_.callee.subject.predicate, outputs, 0, again);
  if (!difference) return true;
  tell_with_cause(chunk, FindingKind::nondeterministic, difference->query, difference->detail + " for the same batch");
  return false;
}

template <class Real>
void Supervisor<Real>::rearrange(const Chunk& chunk, const Outputs<Real>& outputs) {
  Outputs<Real> found;
  std::size_t number = 0;
  for (std::size_t first = 0, size; first < chunk.size && rearranges_; first += size, ++number) {
    size = std::min(piece_size(number, is_program()), chunk.size - first);
    const Chunk piece = chunk.part(first, size);
    Placement placement = piece_placements[number % std::size(piece_placements)];
    if (anchor_ == Anchor::middle) placement.anchor = anchor_;
    const std::string where = is_program() ? "" : ", " + placement_text(placement);
    const bool verdict_alone = !chunk.explained || (number % 2 == 1 && !is_program());
    Arrangement arrangement{placement, Exposure::verdict, 0, filling};
    if (!verdict_alone) {
      arrangement.asked = kernel_.exposes;
      arrangement.measures = kernel_.measures;
    }
    const Result result = ask(piece, arrangement, found);
    if (result.stop) {
      tell(piece, *result.stop, fmt::format(" (a batch of {}{})", size, where));
      rearranges_ = false;
      return;
    }
    if (result.stray) tell(piece, *result.stray);
    if (const auto difference = first_difference(*kernel_.callee.subject.predicate, outputs, first, found)) {
      tell_with_cause(chunk, FindingKind::batch_dependent, first + difference->query,
                      fmt::format("{}: as query {} of {}{}{}", difference->detail, difference->query + 1, size, where,
                                  verdict_alone && chunk.explained ? ", asked for the verdict alone" : ""));
    }
  }
}

// The first batch, and of a plug-in one more, which follows from the seed since the queries do. A program may be
// started for each call.
template <class Real>
bool Supervisor<Real>::is_to_be_reordered(const Chunk& chunk) {
  if (chunks_ != 0) return chunks_ == reordered_at_;
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (std::size_t k = 0; k < chunk.batch.count; ++k) {
    for (const std::byte byte : std::as_bytes(std::span(chunk.batch.column[k] + chunk.first, 1)))
      hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
  }
  if (!is_program()) reordered_at_ = 1 + (hash >> 32) % (batches_of_unit - 1);
  return true;
}

template <class Real>
Reordering<Real> Supervisor<Real>::reordering_of(const Chunk& chunk) {
  const auto ask_in_order = [this, chunk](std::span<const std::size_t> order, Outputs<Real>& outputs) {
    QueryBatch<Real> batch(order.size(), chunk.batch.count);
    for (const std::size_t i : order) {
      Numbers<Real> query(chunk.batch.count);
      for (std::size_t k = 0; k < query.size(); ++k) query[k] = chunk.batch.column[k][chunk.first + i];
      batch.push_back(query);
    }
    const QueryColumns<Real> columns = batch.columns();
    const Chunk made{columns, nullptr, chunk.explained, nullptr, 0, order.size()};
    return ask(made, whole(made, filling), outputs).stop;
  };
  return {*kernel_.callee.subject.predicate, chunk.size, is_program(), ask_in_order};
}

template <class Real>
void Supervisor<Real>::reorder(const Chunk& chunk, const Outputs<Real>& outputs) {
  // A finding in pieces of a batch would be found again.
  for (const FindingKind kind :
       {FindingKind::nondeterministic, FindingKind::batch_dependent, FindingKind::order_dependent}) {
    if (told_.contains(kind)) return;
  }
  chunk.watched->asked_again += chunk.size;
  const auto found = first_by_order(reordering_of(chunk), outputs);
  if (!found) return;
  if (found->stop) tell(chunk, *found->stop, fmt::format(", {}", found->where));
  else tell_with_cause(chunk, FindingKind::order_dependent, found->query, found->detail);
}

template <class Real>
void Supervisor<Real>::tell_with_cause(const Chunk& chunk, FindingKind kind, std::size_t query, std::string detail) {
  if (told_.contains(kind)) return;
  std::string cause = cause_of_difference(reordering_of(chunk), query);
  // Something that its copies did not have, such as an alignment, may have changed its answer in another place.
  if (cause.empty() && kind != FindingKind::batch_dependent)
    cause = ": it did not do so again: it keeps state from call to call, such as a counter, or is random";
  tell(chunk, kind, query, detail + cause);
}

template <class Real>
void Supervisor<Real>::look_for_changed_environment(const Chunk& chunk, std::uint32_t changed) {
  if (told_.contains(FindingKind::environment)) return;
  std::size_t which = 0;
  Outputs<Real> outputs;
  for (std::size_t i = 0; i < chunk.size && chunk.size > 1; ++i) {
    const Result result = ask(chunk.part(i, 1), {{anchor_}, Exposure::verdict, 0, filling}, outputs);
    if (!result.stop && result.reply.changed == 0) continue;
    which = result.stop ? 0 : i;
    break;
  }
  tell(chunk, FindingKind::environment, which, "left changed: " + changed_modes_text(changed));
}

// Whether a comparison's bit is one that its computed sides allow; equal sides allow both where the predicate does not
// say how its kernels compare them.
template <class Real>
bool could_follow(const SupervisedKernel& kernel, std::size_t comparison, Real lhs, Real rhs, bool bit) {
  const Predicate& predicate = *kernel.callee.subject.predicate;
  if (!predicate.has_strictness) return lhs == rhs || (lhs > rhs) == bit;
  if (predicate.comparisons[comparison].ties_at_touching) return (lhs > rhs) == bit;
  switch (kernel.strictness) {
    case Strictness::strict:
      return (lhs > rhs) == bit;
    case Strictness::nonstrict:
      return (lhs >= rhs) == bit;
    case Strictness::not_less:
      return !(rhs > lhs) == bit;
  }
  return false;
}

template <class Real>
void Supervisor<Real>::look_for_contradictions(const Chunk& chunk, const Outputs<Real>& outputs) {
  const auto contradiction = [&](std::size_t i) -> std::string {
    if (!is_verdict(outputs.verdicts[i])) return "verdict " + verdict_text(outputs.verdicts[i]);
    const auto verdict = static_cast<Verdict>(outputs.verdicts[i]);
    if (outputs.bits.empty()) return {};
    const Predicate& predicate = *kernel_.callee.subject.predicate;
    const std::size_t count = predicate.comparisons.size();
    const ComparisonBits bits = outputs.bits[i];
    if (const ComparisonBits beyond = bits & ~all_comparisons(predicate); beyond != 0) {
      return fmt::format("its comparison bit {} is 1; there are comparisons 0 to {}", std::countr_zero(beyond),
                         count - 1);
    }
    if (verdict != Verdict::contact && verdict != Verdict::separated) return {};
    if (const Verdict meant = verdict_of(predicate, bits); meant != verdict) {
      return fmt::format("verdict {}, but its comparisons say {}", name(verdict), name(meant));
    }
    for (std::size_t k = 0; k < count && !outputs.lhs[k].empty(); ++k) {
      const Real lhs = outputs.lhs[k][i], rhs = outputs.rhs[k][i];
      const bool bit = has_bit(bits, k);
      if (could_follow(kernel_, k, lhs, rhs, bit)) continue;
      return fmt::format("comparison {} is {}, but its sides are {:a} and {:a}", predicate.comparisons[k].name,
                         int{bit}, lhs, rhs);
    }
    return {};
  };
  for (std::size_t i = 0; i < chunk.size; ++i) {
    std::string detail = contradiction(i);
    if (!detail.empty()) return tell(chunk, FindingKind::inconsistent, i, std::move(detail));
  }
}

template <class Real>
void Supervisor<Real>::run(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>* explained, Watched* watched) {
  const std::lock_guard lock(mutex_);
  for (std::size_t first = 0, step; first < batch.size; first += step) {
    step = std::min(asks_singly_ ? 1 : batch_capacity, batch.size - first);
    run_chunk({batch, out, explained, watched, first, step});
  }
}

template class Supervisor<float>;
template class Supervisor<double>;

template <class Real>
Implementation<Real> supervised_implementation(const SupervisedKernel& kernel) {
  // Two processes, so unwatched calls cannot affect the watched one.
  const auto unwatched = std::make_shared<Supervisor<Real>>(kernel),
             watched = std::make_shared<Supervisor<Real>>(kernel);
  const bool verdict_alone = kernel.exposes == Exposure::verdict && kernel.measures == 0;
  Implementation<Real> implementation;
  implementation.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    unwatched->run(batch, out, nullptr, nullptr);
  };
  implementation.timed = [=](const QueryColumns<Real>& batch, Verdict* out) {
    const double before = unwatched->nanoseconds();
    unwatched->run(batch, out, nullptr, nullptr);
    return unwatched->nanoseconds() - before;
  };
  implementation.supervised = [=](const QueryColumns<Real>& batch, Verdict* out, Answers<Real>& answers,
                                  Watched& seen) {
    watched->run(batch, out, verdict_alone ? nullptr : &answers, &seen);
  };
  const auto explain = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    std::vector<Verdict> verdicts(batch.size);
    unwatched->run(batch, verdicts.data(), &out, nullptr);
  };
  if (kernel.exposes != Exposure::verdict) implementation.explain = explain;
  if (kernel.measures != 0) implementation.measure = explain;
  return implementation;
}
template Implementation<float> supervised_implementation(const SupervisedKernel&);
template Implementation<double> supervised_implementation(const SupervisedKernel&);

}  // namespace axiscert::plugin
