// The kernel under diagnosis, as every probe asks it: verdicts alone, in batches, counted.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/files/query_file.h"
#include "kernel/ask.h"

namespace axiscert::diagnosis {

// Thrown where the user interrupts, and caught by diagnose().
struct Interruption {};

inline bool is_decided(Verdict v) { return v == Verdict::contact || v == Verdict::separated; }

template <class Real>
using Queries = std::vector<Numbers<Real>>;

// The numbers that a kernel gave beside a verdict, as they were judged.
template <class Real>
struct JudgedContact {
  Numbers<Real> query;
  Numbers<double> wide;
  Verdict said = Verdict::unanswered;
  std::vector<double> measures;
  ContactJudgement found;
  ContactPlace exact;
  double extent = 0;  // the query's greatest coordinate or length, or the scene where this is more
  double reach = 1;   // that as a share of the scene

  // A NaN has several representations, none of which is judged otherwise.
  bool is_of(Verdict verdict, const std::vector<double>& given) const {
    const auto same = [](double x, double y) { return x == y ? std::signbit(x) == std::signbit(y) : x != x && y != y; };
    return said == verdict && std::ranges::equal(measures, given, same);
  }
};

template <class Real>
class Subject {
 public:
  // Without `counts` nothing is counted: whether a kernel with a policy promises a query takes exact arithmetic.
  Subject(const Kernel& kernel, const DiagnosisOptions& options, bool counts = true)
      : kernel_(kernel),
        options_(options),
        implementation_(kernel.on<Real>(options.target)),
        counter_(kernel, true),
        counts_(counts) {}

  const Kernel& kernel() const { return kernel_; }
  const Predicate& predicate() const { return *kernel_.predicate; }
  const PredicateEntry& entry() const { return predicate().entries[kernel_.entry]; }
  bool is_built_in() const { return kernel_.file.empty(); }
  std::uint64_t seed() const { return options_.seed; }
  const std::string& target() const { return options_.target; }
  const DiagnosisOptions& options() const { return options_; }

  // One batch of these queries, in this order.
  std::vector<Verdict> ask_batch(std::span<const Numbers<Real>> queries) {
    return answers_of(implementation_, queries);
  }
  // The same of any number of queries, in batches of at most 1024.
  std::vector<Verdict> ask(std::span<const Numbers<Real>> queries) { return ask(implementation_, queries); }
  // What it says beside its verdicts too, in one batch; counted.
  Reply<Real> ask_measures(std::span<const Numbers<Real>> queries) {
    answers_of(implementation_, queries);  // which counts them
    QueryBatch<Real> batch(queries.size(), entry().columns.size());
    for (const Numbers<Real>& query : queries) batch.push_back(query);
    Reply<Real> reply;
    axiscert::ask(implementation_, batch.columns(), reply);
    return reply;
  }
  // The answers of another implementation, for comparison; not counted.
  std::vector<Verdict> ask(const Implementation<Real>& of, std::span<const Numbers<Real>> queries) {
    std::vector<Verdict> said;
    for (std::size_t first = 0; first < queries.size(); first += most_at_once) {
      const auto part = answers_of(of, queries.subspan(first, std::min(most_at_once, queries.size() - first)));
      said.insert(said.end(), part.begin(), part.end());
    }
    return said;
  }
  // By clear query: each probe of these numbers asks for them again, and a judgement is dearer than a hundred answers.
  std::vector<JudgedContact<Real>>& judged_contacts(bool of_families) { return judged_contacts_[of_families]; }
  // The clear ones of every family, once they were made.
  Queries<Real>& queries_of_families() { return queries_of_families_; }
  // Answers that others asked the kernel for.
  void count(std::uint64_t answers) { asked_ += answers; }
  // The answers of the kernel that were counted since the last call.
  std::uint64_t take_count() { return std::exchange(asked_, 0); }
  // Answers that a probe of numbers could not judge; those of them since the last call.
  void leave_out(std::uint64_t answers) { left_out_ += answers; }
  std::uint64_t take_left_out() { return std::exchange(left_out_, 0); }
  // These by answer, without those that others asked for.
  LookedAt take_looked_at() { return std::exchange(looked_at_, {}); }

  Truth truth(const Numbers<Real>& query) const { return oracles_of(kernel_).truth(query); }

  // A query that shows something, with what was answered.
  DiagnosisWitness witness(const Numbers<Real>& query, std::string answered, std::string shows) const {
    const Truth truth_of = truth(query);
    return {query_line({"diagnosis", precision_of<Real>, query, kernel_.predicate, kernel_.entry}), std::move(answered),
            std::string(truth_of.touching ? "touching" : name(truth_of.verdict)), std::move(shows)};
  }
  DiagnosisWitness witness(const Numbers<Real>& query, Verdict said, std::string shows) const {
    return witness(query, std::string(name(said)), std::move(shows));
  }

 private:
  static constexpr std::size_t most_at_once = 1024;

  std::vector<Verdict> answers_of(const Implementation<Real>& of, std::span<const Numbers<Real>> queries) {
    if (options_.interrupted && *options_.interrupted) throw Interruption{};
    QueryBatch<Real> batch(queries.size(), entry().columns.size());
    for (const Numbers<Real>& query : queries) batch.push_back(query);
    std::vector<Verdict> said(queries.size(), Verdict::unanswered);
    of.verdicts(batch.columns(), said.data());
    if (&of != &implementation_ || !counts_) return said;
    for (std::size_t i = 0; i < queries.size(); ++i) counter_.add(looked_at_, queries[i], said[i], place_++);
    asked_ += queries.size();
    return said;
  }

  const Kernel& kernel_;
  const DiagnosisOptions& options_;
  Implementation<Real> implementation_;
  AnswerCounter<Real> counter_;
  bool counts_;
  LookedAt looked_at_;
  std::array<std::vector<JudgedContact<Real>>, 2> judged_contacts_;
  Queries<Real> queries_of_families_;
  std::uint64_t asked_ = 0, left_out_ = 0, place_ = 0;
};

// A finding of a probe; the name is put by diagnose().
struct ProbeFinding {
  std::string value, sentence;
  std::vector<DiagnosisWitness> witnesses = {};
  Json measured = nullptr;
};

template <Enumeration Value>
ProbeFinding decided(Value value, std::string sentence, std::vector<DiagnosisWitness> witnesses = {},
                     Json measured = nullptr) {
  return {std::string(name(value)), std::move(sentence), std::move(witnesses), std::move(measured)};
}
inline ProbeFinding undecided(std::string sentence, Json measured = nullptr) {
  return {std::string(not_known), std::move(sentence), {}, std::move(measured)};
}
inline ProbeFinding unasked(std::string sentence) { return {std::string(not_asked), std::move(sentence)}; }

}  // namespace axiscert::diagnosis
