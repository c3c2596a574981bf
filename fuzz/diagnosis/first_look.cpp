#include "fuzz/diagnosis/beside_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/judge/oracles.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/record/wrong_verdicts.h"
#include "kernel/ask.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

constexpr std::size_t most_queries = 251;
constexpr std::uint64_t most_right = most_queries / 20;  // of exchanged verdicts

// Why queries have no answer: the first thing that is found where they are asked again and watched.
template <class Real>
std::string why_unanswered(const Kernel& kernel, const QueryBatch<Real>& batch, const std::vector<Verdict>& said) {
  const auto first = static_cast<std::size_t>(std::ranges::find(said, Verdict::unanswered) - said.begin());
  const auto count = static_cast<std::size_t>(std::ranges::count(said, Verdict::unanswered));
  std::string why;
  const Implementation<Real> again = kernel.on<Real>(scalar_target);
  for (const Finding& finding : ask(again, batch[first]).watched.findings) {
    if (why.empty()) why = fmt::format(": {}: {}", name(finding.kind), finding.detail);
  }
  Reply<Real> reply;
  if (why.empty()) ask(again, batch.columns(), reply);
  for (const Finding& finding : reply.watched.findings) {
    if (why.empty()) why = fmt::format(": {}: {}", name(finding.kind), finding.detail);
  }
  const std::string_view of = name(precision_of<Real>);
  return count == said.size()
             ? fmt::format("it answers none of {} queries in {}{}", count, of, why)
             : fmt::format("it leaves {} of {} queries in {} without an answer{}", count, said.size(), of, why);
}

template <class Real>
std::string look(const Kernel& kernel) {
  const auto queries = diagnosis::queries_of_general<Real>(kernel, 1, most_queries);
  if (queries.empty()) return "";
  QueryBatch<Real> batch(queries.size(), queries.front().size());
  for (const Numbers<Real>& query : queries) batch.push_back(query);
  std::vector<Verdict> said(queries.size(), Verdict::unanswered);
  kernel.on<Real>(scalar_target).verdicts(batch.columns(), said.data());
  if (std::ranges::find(said, Verdict::unanswered) != said.end()) return why_unanswered(kernel, batch, said);
  WrongBothWays wrong;
  std::uint64_t right = 0;
  const Oracles& oracles = oracles_of(kernel);
  for (std::size_t i = 0; i < queries.size() && right <= most_right; ++i) {
    const Truth truth = oracles.truth(queries[i]);
    if (truth.touching || truth.verdict == Verdict::invalid || !is_promised(kernel, queries[i])) continue;
    const bool is_contact = truth.verdict == Verdict::contact;
    const bool is_other = said[i] == (is_contact ? Verdict::separated : Verdict::contact);
    ++(is_contact ? wrong.contact : wrong.separated);
    if (is_other) ++(is_contact ? wrong.false_separation : wrong.false_contact);
    else ++right;
  }
  return right <= most_right && wrong.are_exchanged() ? wrong.text(kernel) : "";
}

}  // namespace

std::string first_look(const Kernel& kernel) {
  std::string found;
  if (kernel.has(Precision::binary32)) found = look<float>(kernel);
  if (!found.empty() || (plugin::is_program(kernel) && kernel.has(Precision::binary32))) return found;
  return kernel.has(Precision::binary64) ? look<double>(kernel) : found;
}

}  // namespace axiscert
