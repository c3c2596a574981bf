// Shared parts of the tests of peers that are asked about a sphere that moves.
#pragma once

#include <bit>
#include <cstring>

#include "kernel/peers/moving_sphere/sweep.h"
#include "kernel/peers/peers_testing.h"

namespace axiscert::peer {

// A peer's answer: 'c'ontact, 's'eparated, 'u'ndecided, 'i'nvalid, and the measures that it gives.
struct SweepAnswer {
  char letter = '?';
  std::vector<double> measures;
};

// A peer's answers to a batch; none where it has no kernel of that precision, or its process was ended.
template <class Real>
std::vector<SweepAnswer> ask_sweeps(const std::string& name, const std::vector<Sweep<Real>>& queries) {
  const Reply reply = in_peer("moving-sphere/" + name, [&](AxiscertPlugin* plugin) -> std::string {
    const axiscert_kernel* kernel = nullptr;
    for (std::uint32_t i = 0; (kernel = plugin(i)) != nullptr && kernel->precision != 8 * sizeof(Real);) ++i;
    if (kernel == nullptr) return "";
    std::vector<std::vector<Real>> numbers(sweep_columns), given(kernel->measure_count);
    for (const Sweep<Real>& q : queries) {
      std::size_t k = 0;
      for (const Vec3<Real>& v : {q.a, q.b, q.c, q.p, q.d}) {
        for (const Real x : {v.x, v.y, v.z}) numbers[k++].push_back(x);
      }
      numbers[k].push_back(q.r);
    }
    std::vector<const void*> columns;
    for (const auto& column : numbers) columns.push_back(column.data());
    std::vector<void*> measures;
    for (auto& column : given) {
      column.resize(queries.size());
      measures.push_back(column.data());
    }
    std::vector<std::uint8_t> verdicts(queries.size(), 255);
    const axiscert_batch asked{sizeof asked, queries.size(), columns.size(), columns.data()};
    axiscert_answers answers{};
    answers.size = sizeof answers;
    answers.verdict = verdicts.data();
    answers.measure_count = measures.size();
    answers.measure = measures.data();
    kernel->run(&asked, &answers);
    std::string bytes;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      bytes += letter_of(*kernel, verdicts[i]);
      for (std::size_t k = 0; k < sweep_measures; ++k) {
        const double number = k < given.size() ? double{given[k][i]} : FirstContact<double>::unsaid;
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
      }
    }
    return bytes;
  });
  EXPECT_EQ(reply.signal, 0) << name;
  constexpr std::size_t size = 1 + sweep_measures * sizeof(double);
  std::vector<SweepAnswer> answers(reply.bytes.size() / size);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i].letter = reply.bytes[i * size];
    answers[i].measures.resize(sweep_measures);
    std::memcpy(answers[i].measures.data(), reply.bytes.data() + i * size + 1, size - 1);
  }
  return answers;
}

inline std::string letters_of(const std::vector<SweepAnswer>& answers) {
  std::string letters;
  for (const SweepAnswer& answer : answers) letters += answer.letter;
  return letters;
}

// A triangle with a right angle at the origin and legs of length 4.
template <class Real = float>
Sweep<Real> motion(Vec3<Real> p, Vec3<Real> d, Real r) {
  return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, d, r};
}

}  // namespace axiscert::peer
