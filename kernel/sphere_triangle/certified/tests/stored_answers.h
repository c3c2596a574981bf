// Queries with their answers in a file, written on one machine (fuzz/oracle_checks/write_certified_answers.cpp) and
// replayed on another (replay_answers.cpp). The file has sections, each with a Header, thirteen columns of numbers, the
// orders and the conservative verdicts. It is little-endian, as both machines are; numbers are stored as their bits.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace axiscert::certified {

static_assert(std::endian::native == std::endian::little);

struct Header {
  char format[16];  // "certified/1"
  char name[32];    // the source of the queries
  std::uint32_t precision, group;
  std::uint64_t size;
};
inline constexpr char answers_format[16] = "certified/1";

// The order of an invalid query. The others are the orders of the distance and r: -1 penetrating, 0 touching, 1
// separated.
inline constexpr std::int8_t invalid_order = 2;

template <class Real>
struct StoredAnswers {
  std::string name;
  std::size_t group = 1;  // number of consecutive queries that have the same sphere
  std::vector<Real> column[13];
  std::vector<std::int8_t> order;
  std::vector<std::uint8_t> conservative;  // an axiscert_verdict each

  std::size_t size() const { return column[0].size(); }
};

template <class Real>
bool write(const StoredAnswers<Real>& answers, std::FILE* file) {
  Header header{};
  std::memcpy(header.format, answers_format, sizeof answers_format);
  std::memcpy(header.name, answers.name.data(), answers.name.size() < 31 ? answers.name.size() : 31);
  header.precision = 8 * sizeof(Real);
  header.group = static_cast<std::uint32_t>(answers.group);
  header.size = answers.size();
  bool done = std::fwrite(&header, sizeof header, 1, file) == 1;
  const auto put = [&](const auto& all) {
    done = done && std::fwrite(all.data(), sizeof all[0], all.size(), file) == answers.size();
  };
  for (const auto& column : answers.column) put(column);
  put(answers.order);
  put(answers.conservative);
  return done;
}

// Reads the section after `header`. False if the file ends before it does.
template <class Real>
bool read(const Header& header, std::FILE* file, StoredAnswers<Real>& answers) {
  answers.name = header.name;
  answers.group = header.group;
  bool done = true;
  const auto get = [&](auto& all) {
    all.resize(header.size);
    done = done && std::fread(all.data(), sizeof all[0], all.size(), file) == all.size();
  };
  for (auto& column : answers.column) get(column);
  get(answers.order);
  get(answers.conservative);
  return done;
}

}  // namespace axiscert::certified
